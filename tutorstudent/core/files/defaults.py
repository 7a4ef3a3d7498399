"""What stands in for the slots that a pipeline leaves out. The same for YAML and for `ts.wrap`.

A continuous command of one kind has nothing for a student to name, so that its defaults are those of the streamlined
algorithm, with a change in proportion and limits that keep it near the tutor's command. Where there are several kinds
they are the thesis's (docs/decisions/0011).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tutorstudent.core.files.registry import Registry
from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.words.proposals import LevelProposal

DEFAULTS: dict[str, Any] = {
    "selector": "same-kind",
    "amplifier": "learning-phase",
    "evaluator": "conditions",
    "conditions": [],
    "observers": [],
    "limits": {},
    "on_tutor_failure": "raise",
}
"""Whatever the tutor."""
CHANGE = "multiplicative"
FACTOR, SLEW = 1.3, 1
ONE_KIND: dict[str, Any] = {
    "student": "budgeted",
    "selector": "modifier",
    "amplifier": {"use": "learning-phase", "decisions": 0, "change": CHANGE},
    "limits": {"factor": FACTOR, "slew": SLEW},
}
"""Of a tutor whose actions are of one kind."""


def has_one_kind(tutor: Tutor[Any, Any]) -> bool:
    """Return whether a tutor's actions are of one kind, so that only their size can be learned."""
    action = getattr(tutor, "action", None)  # without one, assembly says so
    return action is not None and len(action.vocabulary.kinds) == 1


def make_defaults(tutor: Tutor[Any, Any]) -> dict[str, Any]:
    """Return the value of each slot that a pipeline with this tutor may leave out."""
    return DEFAULTS | ONE_KIND if has_one_kind(tutor) else DEFAULTS


def choose_selector(student: Any, tutor: Tutor[Any, Any]) -> str:
    """Return the selector where none is named: with one kind, the one that reads the student's proposals."""
    reads_levels = has_one_kind(tutor) and getattr(student, "proposal", None) is LevelProposal
    return str(ONE_KIND["selector"] if reads_levels else DEFAULTS["selector"])


def add_change(amplifier: Any, tutor: Tutor[Any, Any], registry: Registry) -> Any:
    """Return what a pipeline says of its amplifier, with the change that it leaves out."""
    values = {"use": amplifier} if isinstance(amplifier, str) else amplifier
    if not has_one_kind(tutor) or not isinstance(values, Mapping) or "change" in values:
        return amplifier
    found = [item.cls for item in registry.of("amplifier") if item.cls.name == values.get("use")]
    takes_one = found and "change" in found[0].Options.model_fields
    return {**values, "change": CHANGE} if takes_one else amplifier
