"""Actions to try parts with: made from what an action class declares."""

from __future__ import annotations

import math
from typing import Any, ClassVar, Literal

from pydantic import ValidationError

from tutorstudent.checks.outcome import CheckSkipped
from tutorstudent.core.words.actions import Action, AmplificationMap, ComponentSpec, component

SHARES = (0.25, 0.0, 0.5, 1.0)
"""How far towards its bound an amplified component is set."""


class Motion(Action):
    """Stands in where a part is made for any actions: every direction, a vector, and a kind with nothing to amplify."""

    kind: Literal["rest", "push", "pull", "steer"]
    force: float = component(-1.0, 1.0, default=0.0)
    x: float = component(-1.0, 1.0, default=0.0)
    y: float = component(-1.0, 1.0, default=0.0)

    amplification: ClassVar[AmplificationMap] = {
        "rest": {},
        "push": {"force": "+"},
        "pull": {"force": "-"},
        "steer": {("x", "y"): "outward"},
    }


def make_examples(cls: type[Action]) -> list[Any]:
    """Return sound actions of a class: of every kind, from doing nothing to the bounds.

    Components that are never amplified keep their defaults, so that a duration stays as short as it is by itself.

    Raises:
        CheckSkipped: if the class needs something that it does not declare as a bounded number.
    """
    try:
        return [_make_example(cls, kind, share) for share in SHARES for kind in cls.vocabulary.kinds]
    except ValidationError as error:
        problem = error.errors(include_url=False)[0]
        where = ".".join(map(str, problem["loc"]))
        raise CheckSkipped(f"no {cls.__name__} can be made up: {where}: {problem['msg']}") from None


def _make_example(cls: type[Action], kind: str, share: float) -> Action:
    vocabulary = cls.vocabulary
    directions = {name: group.direction for group in vocabulary.groups[kind] for name in group.names}
    values: dict[str, Any] = {} if vocabulary.kinds == ("command",) else {"kind": kind}
    for name, spec in vocabulary.components.items():
        if name in directions:
            values[name] = _move_towards(spec, directions[name], share)
        elif cls.model_fields[name].is_required() and spec.number:
            values[name] = min(max(spec.neutral, spec.low), spec.high)
    return cls(**values)


def _move_towards(spec: ComponentSpec, direction: str, share: float) -> float:
    low = spec.low if math.isfinite(spec.low) else spec.neutral - spec.scale
    high = spec.high if math.isfinite(spec.high) else spec.neutral + spec.scale
    end = low if direction == "-" else high
    return spec.neutral + share * (end - spec.neutral)
