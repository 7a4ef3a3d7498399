"""From a level to an action: the only place where amplified actions are made.

Everything here starts from the tutor's own action. How far comes from the amplifier's change, in which direction from
the action class, how far at most from the limits.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

from tutorstudent.core.actions import ActionT, Group
from tutorstudent.core.limits import Limits

Fractions = tuple[float, ...]
"""One distance for each group of the action's kind, in units of the group's scale."""

FractionOf = Callable[[int, float], float]
"""(level, magnitude) -> fraction; magnitude is the tutor's own distance from neutral in units of the scale."""

NOTHING: Fractions = ()
# 3 x 0.1 is 0.30000000000000004: a limit has to hold for the level that was meant.
_ROUNDING = 1e-9


class Permitted(NamedTuple):
    """The highest level that the limits allow, with the distances that it stands for."""

    level: int
    fractions: Fractions


def deviation(group: Group, values: Mapping[str, float]) -> float:
    """Return how far the tutor's own values are from neutral, >= 0."""
    if len(group.names) == 1:
        return abs(values[group.names[0]] - group.neutral[0])
    return math.dist([values[name] for name in group.names], group.neutral)


def can_move(groups: tuple[Group, ...], values: Mapping[str, float]) -> bool:
    """Return whether there is anything to amplify in an action with these values."""
    return any(group.direction != "outward" or deviation(group, values) > 0 for group in groups)


def moved(group: Group, values: Mapping[str, float], fraction: float) -> tuple[float, ...]:
    """Return the group's values moved by `fraction` of its scale in its direction, clipped to the bounds."""
    if len(group.names) == 1:
        return (_moved_scalar(group, values[group.names[0]], fraction * group.scale),)
    return _moved_vector(group, [values[name] for name in group.names], fraction * group.scale)


def _moved_scalar(group: Group, value: float, distance: float) -> float:
    sign = 1.0 if group.direction == "+" else -1.0
    if group.direction == "outward":
        sign = math.copysign(1.0, value - group.neutral[0]) if value != group.neutral[0] else 0.0
    return min(max(value + sign * distance, group.low[0]), group.high[0])


def _moved_vector(group: Group, values: list[float], distance: float) -> tuple[float, ...]:
    arm = [value - neutral for value, neutral in zip(values, group.neutral, strict=True)]
    length = math.hypot(*arm)
    if length == 0:
        return tuple(values)
    stretch = 1 + distance / length
    for part, neutral, low, high in zip(arm, group.neutral, group.low, group.high, strict=True):
        if part:
            stretch = min(stretch, ((high if part > 0 else low) - neutral) / part)
    stretch = max(stretch, 1.0)
    ends = [neutral + part * stretch for part, neutral in zip(arm, group.neutral, strict=True)]
    return tuple(min(max(end, low), high) for end, low, high in zip(ends, group.low, group.high, strict=True))


def render(original: ActionT, groups: tuple[Group, ...], fractions: Fractions) -> ActionT:
    """Return the tutor's action with every group moved by its fraction; the original itself where nothing moves."""
    values = original.__dict__
    changes = {
        name: value
        for group, fraction in zip(groups, fractions, strict=True)
        if fraction > 0
        for name, value in zip(group.names, moved(group, values, fraction), strict=True)
    }
    if not changes:
        return original
    return type(original)(**{name: changes.get(name, values[name]) for name in original.vocabulary.fields})


def permitted(
    level: int, groups: tuple[Group, ...], values: Mapping[str, float], fraction_of: FractionOf, limits: Limits
) -> Permitted:
    """Return the highest level up to `level` that cap and factor allow.

    Fractions are taken to grow with the level. The level that is returned was tried itself, so a change that does not
    grow costs amplification and never breaks a limit.
    """
    if level == 0 or not groups:
        return Permitted(level, (0.0,) * len(groups))
    fractions = _fractions(level, groups, values, fraction_of)
    if within(fractions, groups, values, limits):
        return Permitted(level, fractions)
    low, high, best = 0, level, (0.0,) * len(groups)
    while high - low > 1:
        middle = (low + high) // 2
        fractions = _fractions(middle, groups, values, fraction_of)
        if within(fractions, groups, values, limits):
            low, best = middle, fractions
        else:
            high = middle
    return Permitted(low, best)


def within(fractions: Fractions, groups: tuple[Group, ...], values: Mapping[str, float], limits: Limits) -> bool:
    """Return whether cap and factor allow these fractions."""
    return all(_within(fraction, group, values, limits) for fraction, group in zip(fractions, groups, strict=True))


def _within(fraction: float, group: Group, values: Mapping[str, float], limits: Limits) -> bool:
    if fraction > limits.cap + _ROUNDING:
        return False
    if limits.factor is None:
        return True
    ends = dict(zip(group.names, moved(group, values, fraction), strict=True))
    return deviation(group, ends) <= limits.factor * deviation(group, values) + _ROUNDING * group.scale


def _fractions(
    level: int, groups: tuple[Group, ...], values: Mapping[str, float], fraction_of: FractionOf
) -> Fractions:
    return tuple(_exact(fraction_of(level, deviation(group, values) / group.scale)) for group in groups)


def _exact(fraction: float) -> float:
    plain = float(fraction)
    if not 0 <= plain < math.inf:
        raise ValueError(f"a change returned {plain}; a fraction is finite and not negative")
    return plain


def progress(group: Group, values: Mapping[str, float], ends: Mapping[str, float]) -> float:
    """Return how far `ends` lies from the tutor's values along the group's direction; negative means less than it."""
    if group.direction == "outward":
        return deviation(group, ends) - deviation(group, values)
    distance = ends[group.names[0]] - values[group.names[0]]
    return distance if group.direction == "+" else -distance
