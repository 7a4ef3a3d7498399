"""What every comparison is held against: pipelines that learn nothing, and one that is told nothing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from tutorstudent.study.resolving import Resolved

LEVEL = 4
"""Of the constant control: half of the thesis's highest level. Choice: see docs/fidelity.md."""


class Control(NamedTuple):
    """Values that stand in for those of the pipeline that is controlled."""

    name: str
    about: str
    values: dict[str, Any]


def controls_of(resolved: Resolved) -> Iterator[Control]:
    """Yield the controls of a pipeline.

    A control replaces student, selector and amplifier together, and keeps how far a level moves a component; ``blind``
    replaces the evaluator only.
    """
    student, evaluator = resolved.values["student"], resolved.values["evaluator"]
    encoder = student.get("encoder")
    ramp = {"use": "ramp"} | ({"encoder": encoder} if isinstance(encoder, dict) else {})
    yield _replacing(resolved, "tutor-alone", "The tutor, never amplified.", {"use": "silent"})
    yield Control(
        "blind",
        "The same learner, never told of a violation.",
        resolved.values | {"evaluator": {"use": "blind", "evaluator": evaluator}},
    )
    yield _replacing(resolved, "ramp", "No learning: one level more while the tutor's kind and the inputs stay.", ramp)
    constant = {"use": "constant", "level": LEVEL}
    yield _replacing(resolved, f"constant-{LEVEL}", f"No learning: level {LEVEL} in every decision.", constant)
    yield _replacing(
        resolved, "random", "No learning: a level drawn anew in every decision, 0 to 8.", {"use": "random"}
    )


def _replacing(resolved: Resolved, name: str, about: str, student: dict[str, Any]) -> Control:
    reins = {
        "student": student,
        "selector": {"use": "modifier"},
        "amplifier": {"use": "never", "amount": resolved.amount, "change": resolved.change},
    }
    return Control(name, about, resolved.values | reins)
