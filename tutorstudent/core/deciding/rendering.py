"""From a level to an action: the only file where amplified actions are made.

Everything here starts from the tutor's own action. How far comes from the amplifier's change, in which direction from
the action class, how far at most from the limits.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from tutorstudent.core.deciding.guard import Breach
from tutorstudent.core.words.actions import ActionT, Group, rebuild
from tutorstudent.core.words.sameness import is_same
from tutorstudent.core.words.turn import Ends


def measure_deviation(group: Group, values: Mapping[str, float]) -> float:
    """Return how far a group's values are from neutral, >= 0."""
    return measure_distance(group, [values[name] for name in group.names])


def measure_distance(group: Group, ends: Sequence[float]) -> float:
    """Return how far values of a group, in the order of its names, are from neutral, >= 0."""
    return abs(ends[0] - group.neutral[0]) if len(ends) == 1 else math.dist(ends, group.neutral)


def can_move(group: Group, values: Mapping[str, float]) -> bool:
    """Return whether there is a way for a group with these values, bounds aside."""
    return group.direction != "outward" or measure_deviation(group, values) > 0


def move(group: Group, values: Mapping[str, float], fraction: float) -> tuple[float, ...]:
    """Return the group's values moved by `fraction` of its scale in its direction, clipped to the bounds."""
    if len(group.names) == 1:
        return (_move_scalar(group, values[group.names[0]], fraction * group.scale),)
    return _move_vector(group, [values[name] for name in group.names], fraction * group.scale)


def _move_scalar(group: Group, value: float, distance: float) -> float:
    sign = 1.0 if group.direction == "+" else -1.0
    if group.direction == "outward":
        sign = math.copysign(1.0, value - group.neutral[0]) if value != group.neutral[0] else 0.0
    end, low, high = value + sign * distance, group.low[0], group.high[0]
    return low if end < low else high if end > high else end


def _move_vector(group: Group, values: Sequence[float], distance: float) -> tuple[float, ...]:
    arm = [value - neutral for value, neutral in zip(values, group.neutral, strict=True)]
    longest = max(map(abs, arm))
    if longest == 0:
        return tuple(values)
    shape = [part / longest for part in arm]  # the length of the faintest numbers would be rounded
    length = math.hypot(*shape)
    heading = [part / length for part in shape]
    for value, part, low, high in zip(values, heading, group.low, group.high, strict=True):
        if part:
            distance = min(distance, ((high if part > 0 else low) - value) / part)
    ends = [value + part * distance for value, part in zip(values, heading, strict=True)]
    return tuple(min(max(end, low), high) for end, low, high in zip(ends, group.low, group.high, strict=True))


def render(original: ActionT, groups: tuple[Group, ...], ends: Ends) -> ActionT:
    """Return the tutor's action with the values of every group where they were brought."""
    values, changed = original.__dict__, {}
    for group, end in zip(groups, ends, strict=True):
        for name, value in zip(group.names, end, strict=True):
            if value != values[name]:
                changed[name] = value
    return _make(original, changed)


def _make(original: ActionT, changed: dict[str, float]) -> ActionT:
    made = rebuild(original, changed)
    own, new = original.__dict__, made.__dict__
    for name in original.vocabulary.fields:
        expected = changed.get(name, own[name])
        if expected is not new[name] and not is_same(expected, new[name]):
            raise Breach(
                "mutated",
                f"making the amplified {type(original).__name__} gave '{name}' another value than the one that was "
                "decided; the class must leave values alone that are sound.",
            )
    return made
