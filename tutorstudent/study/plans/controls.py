"""What comparisons compare with: pipelines that learn nothing, and one that is told nothing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from tutorstudent.study.plans.constant_level import TUTOR_ALONE, name_candidate
from tutorstudent.study.plans.resolving import Resolved

UNSEARCHED = 4
"""The constant level where none is searched for: half of the thesis's highest. Choice: see docs/fidelity.md."""
CONSTANT = f"constant-{UNSEARCHED}"
"""The name of that control."""


class Control(NamedTuple):
    """Values that stand in for those of the pipeline that is controlled."""

    name: str
    about: str
    values: dict[str, Any]


def make_controls(resolved: Resolved) -> Iterator[Control]:
    """Yield the controls of a pipeline, but for the constant level.

    A control replaces student, selector and amplifier together, and keeps how far a level moves a component; ``blind``
    replaces the evaluator only.
    """
    evaluator = resolved.values["evaluator"]
    ramp = {"use": "ramp"} | ({"encoder": resolved.encoder} if resolved.encoder else {})
    yield _make_tutor_alone(resolved)
    yield Control(
        "blind",
        "The same learner, never told of a violation.",
        resolved.values | {"evaluator": {"use": "blind", "evaluator": evaluator}},
    )
    yield _replace_student(
        resolved, "ramp", "No learning: one level more while the tutor's kind and the inputs stay.", ramp
    )
    yield _replace_student(
        resolved, "random", "No learning: a level drawn anew in every decision, 0 to 8.", {"use": "random"}
    )


def make_unsearched(resolved: Resolved) -> Control:
    """Return the control of a constant level where none is searched for."""
    about = f"No learning: level {UNSEARCHED} in every decision; no other level was tried."
    return _make_constant(resolved, CONSTANT, about, UNSEARCHED)


def make_candidates(resolved: Resolved) -> Iterator[Control]:
    """Yield what a search for the best constant level tries: the tutor alone, then every level that differs."""
    yield _make_tutor_alone(resolved)
    for level in range(1, resolved.highest_level + 1):
        yield _make_constant(resolved, name_candidate(level), f"No learning: level {level} in every decision.", level)


def _make_tutor_alone(resolved: Resolved) -> Control:
    return _replace_student(resolved, TUTOR_ALONE, "The tutor, never amplified.", {"use": "silent"})


def _make_constant(resolved: Resolved, name: str, about: str, level: int) -> Control:
    return _replace_student(resolved, name, about, {"use": "constant", "level": level})


def _replace_student(resolved: Resolved, name: str, about: str, student: dict[str, Any]) -> Control:
    reins = {
        "student": student,
        "learned": None,  # what the learner begins with, no other student could take
        "selector": {"use": "modifier"},
        "amplifier": {"use": "never", "amount": resolved.amount, "change": resolved.change},
    }
    return Control(name, about, resolved.values | reins)
