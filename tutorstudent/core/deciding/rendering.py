"""From a level to an action: the only place where amplified actions are made.

Everything here starts from the tutor's own action. How far comes from the amplifier's change, in which direction from
the action class, how far at most from the limits.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.words.actions import ActionT, Group, rebuild
from tutorstudent.core.words.proposals import require_number

Fractions = tuple[float, ...]
"""One distance for each group of the action's kind, in units of the group's scale; none where nothing moves."""

# 3 x 0.1 is 0.30000000000000004: a limit has to hold for the level that was meant.
_ROUNDING = 1e-9


class Permitted(NamedTuple):
    """The highest level that the limits allow, with the distances that it stands for."""

    level: int
    fractions: Fractions


NOTHING = Permitted(0, ())


def deviation(group: Group, values: Mapping[str, float]) -> float:
    """Return how far the tutor's own values are from neutral, >= 0."""
    return _from_neutral(group, [values[name] for name in group.names])


def _from_neutral(group: Group, numbers: Sequence[float]) -> float:
    return abs(numbers[0] - group.neutral[0]) if len(numbers) == 1 else math.dist(numbers, group.neutral)


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
    end, low, high = value + sign * distance, group.low[0], group.high[0]
    return low if end < low else high if end > high else end


def _moved_vector(group: Group, values: list[float], distance: float) -> tuple[float, ...]:
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


def render(original: ActionT, groups: tuple[Group, ...], fractions: Fractions) -> ActionT:
    """Return the tutor's action with every group moved by its fraction; the original itself where nothing moves."""
    values = original.__dict__
    if not fractions:
        return original
    changed: dict[str, float] = {}
    for group, fraction in zip(groups, fractions, strict=True):
        if fraction > 0:
            changed.update(zip(group.names, moved(group, values, fraction), strict=True))
    return rebuild(original, changed) if changed else original


def permitted(
    level: int,
    groups: tuple[Group, ...],
    values: Mapping[str, float],
    fractions_at: Callable[[int], Fractions],
    limits: Limits,
) -> Permitted:
    """Return the highest level up to `level` that cap and factor allow.

    Fractions are taken to grow with the level. The level that is returned was tried itself, so a change that does not
    grow costs amplification and never breaks a limit.
    """
    if level == 0:
        return NOTHING
    fractions = fractions_at(level)
    if within(fractions, groups, values, limits):
        return Permitted(level, fractions)
    low, high, best = 0, level, NOTHING.fractions
    while high - low > 1:
        middle = (low + high) // 2
        fractions = fractions_at(middle)
        if within(fractions, groups, values, limits):
            low, best = middle, fractions
        else:
            high = middle
    return Permitted(low, best)


def within(fractions: Fractions, groups: tuple[Group, ...], values: Mapping[str, float], limits: Limits) -> bool:
    """Return whether cap and factor allow these fractions."""
    cap, factor = limits.cap + _ROUNDING, limits.factor
    for fraction, group in zip(fractions, groups, strict=True):
        if fraction > cap or (factor is not None and not _within_factor(fraction, group, values, factor)):
            return False
    return True


def _within_factor(fraction: float, group: Group, values: Mapping[str, float], factor: float) -> bool:
    ends = moved(group, values, fraction)
    return _from_neutral(group, ends) <= factor * deviation(group, values) + _ROUNDING * group.scale


def magnitudes(groups: tuple[Group, ...], values: Mapping[str, float]) -> Fractions:
    """Return the tutor's own distance from neutral for each group, in units of its scale."""
    return tuple([deviation(group, values) / group.scale for group in groups])


def exact_fraction(fraction: float) -> float:
    """Return what a change returned as a plain float; ValueError if it is not finite or negative."""
    plain = require_number(fraction)
    if not 0 <= plain < math.inf:
        raise ValueError(f"a change returned {plain}; a fraction is finite and not negative")
    return plain


def progress(group: Group, values: Mapping[str, float], ends: Mapping[str, float]) -> float | None:
    """Return how far `ends` lies from the tutor's values in the group's direction, in units of its scale.

    Negative means less than the tutor's own. None means that it does not lie in that direction.
    """
    if group.direction == "outward":
        distance = deviation(group, ends) - deviation(group, values)
    else:
        distance = (ends[group.names[0]] - values[group.names[0]]) * (1 if group.direction == "+" else -1)
    if distance < 0:
        return distance / group.scale
    on_the_way = moved(group, values, distance / group.scale)
    off = max(abs(ends[name] - value) for name, value in zip(group.names, on_the_way, strict=True))
    return distance / group.scale if off <= _ROUNDING * group.scale else None
