"""`wrap`: a learner around a working controller, in one line."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from tutorstudent.core.deciding.function_tutor import as_tutor
from tutorstudent.core.deciding.loop import Loop
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.yamlfile import Document
from tutorstudent.core.roles.leaves import Condition, condition
from tutorstudent.core.words.actions import Action

Predicate = Callable[[Any], bool] | type[Condition[Any]]
"""Also what `condition` made of one."""


def wrap(
    controller: Any,
    *,
    action: type[Action] | None = None,
    condition: Predicate | Condition[Any] | None = None,
    conditions: Sequence[Predicate | Condition[Any]] = (),
    ranges: Sequence[tuple[float, float]] = (),
    factor: float | None = 1.3,
    slew: int | None = 1,
    seed: int = 0,
    **slots: Any,
) -> Loop:
    """Return a loop around a controller; call its ``step(state)`` where you called the controller.

    Args:
        controller: A callable of the state, or a `Tutor`.
        action: What the controller returns, as in ``scalar(-1, 1)``; a `Tutor` brings its own.
        condition: Operational condition: true means violated.
        conditions: Several of them.
        ranges: Low and high of each number of the state; without them the student sees only the controller's own
            command.
        factor: The executed magnitude is at most this many times the controller's own.
        slew: Largest change of the amplification level from one decision to the next.
        seed: The one seed.
        slots: Other slots of a pipeline, as plain values: ``student={"use": "backprop", ...}``; ``limits`` adds to
            factor and slew.

    Raises:
        TutorStudentError: if the parts do not fit; the message says what to do.
    """
    found = [condition, *conditions] if condition is not None else list(conditions)
    slots["limits"] = {"factor": factor, "slew": slew} | slots.get("limits", {})
    pipeline = Pipeline(Document("wrap()", {"seed": seed} | _make_defaults(ranges) | slots, {}))
    return Loop(pipeline.engine(tutor=as_tutor(controller, action), conditions=_name_conditions(found)))


def _make_defaults(ranges: Sequence[tuple[float, float]]) -> dict[str, Any]:
    return {
        "student": {
            "use": "table",
            "encoder": {"use": "ranges", "ranges": [list(pair) for pair in ranges]},
            "codec": "level-ampbit",
        },
        "selector": "modifier",
        "amplifier": {"use": "learning-phase", "decisions": 0, "change": "multiplicative"},
    }


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
