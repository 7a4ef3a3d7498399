"""`wrap`: a learner around a working controller, in one line."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from tutorstudent.core.deciding.function_tutor import as_tutor
from tutorstudent.core.deciding.loop import Loop
from tutorstudent.core.files.defaults import FACTOR, ONE_KIND, SLEW, has_one_kind
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.yamlfile import Document
from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.roles.leaves import Condition, condition
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import ContractError

Predicate = Callable[[Any], bool] | type[Condition[Any]]
"""Also what `condition` made of one."""
Ranges = Sequence[float] | Sequence[tuple[float, float]] | Mapping[str, tuple[float, float]]


def wrap(
    controller: Any,
    *,
    action: type[Action] | None = None,
    condition: Predicate | Condition[Any] | None = None,
    conditions: Sequence[Predicate | Condition[Any]] = (),
    ranges: Ranges = (),
    factor: float | None = FACTOR,
    slew: int | None = SLEW,
    seed: int = 0,
    **slots: Any,
) -> Loop:
    """Return a loop around a controller; call its ``step(state)`` where you called the controller.

    Args:
        controller: A callable of the state, or a `Tutor`.
        action: What the controller returns, as in ``scalar(-1, 1)``; a `Tutor` brings its own.
        condition: Operational condition: true means violated.
        conditions: Several of them.
        ranges: Low and high of each number of the state, or of those that are named: ``{"pose.x": (0, 5)}``; of a
            single number also ``(0, 100)``. With them the student is ``table``, which learns a level for every part
            of the ranges; without them it is ``budgeted``, which needs no inputs.
        factor: The executed magnitude is at most this many times the controller's own.
        slew: Largest step of the amplification level, up or down; down at once where more would move nothing.
        seed: The one seed.
        slots: Other slots of a pipeline, as plain values: ``student={"use": "backprop", ...}``; ``limits`` adds to
            factor and slew.

    Raises:
        TutorStudentError: if the parts do not fit; the message says what to do.
    """
    if len(ranges) and "student" in slots:
        raise ContractError(
            "wrap(): found ranges= and student=; ranges make the student 'table'. Write them into yours, as in "
            "student={'use': 'table', 'encoder': {'use': 'ranges', 'ranges': [[0, 100]]}, 'codec': 'level-ampbit'}."
        )
    found = [condition, *conditions] if condition is not None else list(conditions)
    tutor = as_tutor(controller, action)
    limits = slots.get("limits", {})
    if isinstance(limits, Mapping):  # anything else is refused with the pipeline
        slots["limits"] = {"factor": factor, "slew": slew} | dict(limits)
    pipeline = Pipeline(Document("wrap()", {"seed": seed} | _make_defaults(tutor, ranges) | slots, {}))
    return Loop(pipeline.engine(tutor=tutor, conditions=_name_conditions(found)))


def _make_defaults(tutor: Tutor[Any, Any], ranges: Ranges) -> dict[str, Any]:
    """Return what stands in for slots that are not given: a pipeline's defaults of one kind, whatever the kinds."""
    others = {} if has_one_kind(tutor) else {key: ONE_KIND[key] for key in ("selector", "amplifier")}
    return {"student": _make_table(ranges) if len(ranges) else ONE_KIND["student"]} | others


def _make_table(ranges: Ranges) -> dict[str, Any]:
    """Return the student that learns a level for every part of the ranges."""
    declared = dict(ranges) if isinstance(ranges, Mapping) else np.asarray(ranges).tolist()
    return {"use": "table", "encoder": {"use": "ranges", "ranges": declared}, "codec": "level-ampbit"}


def _name_conditions(conditions: Sequence[Predicate | Condition[Any]]) -> list[Condition[Any]]:
    return [
        item if isinstance(item, Condition) else _make_class(item, number)()
        for number, item in enumerate(conditions, start=1)
    ]


def _make_class(item: Any, number: int) -> type[Condition[Any]]:
    """Return the class that `condition` makes of a predicate; it may have been made already."""
    if isinstance(item, type) and issubclass(item, Condition):
        return item
    return condition(f"condition-{number}")(item)
