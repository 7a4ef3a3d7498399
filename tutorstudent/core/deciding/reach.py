"""How high a level can get within the limits, whatever the tutor says."""

from __future__ import annotations

import math
from typing import Any

from tutorstudent.core.deciding.guard import is_owners
from tutorstudent.core.deciding.ladder import ROUNDING
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.roles.interfaces import Amplifier
from tutorstudent.core.roles.leaves import Change
from tutorstudent.core.words.actions import Action, Group

SHARES = tuple(2.0**-i for i in range(12))
HIGHEST_USEFUL = 8
"""The thesis's highest level (3.3.2): the last one that is looked at."""
FAR = 1000.0
"""How far from neutral an unbounded command is tried, in scales."""


def explain_unreachable(action: type[Action], amplifier: Amplifier[Any], limits: Limits) -> str:
    """Return which limit forbids level 1 of every command that an action class allows; empty where one allows it.

    Commands from the bounds down to a few thousandths of them are tried.
    """
    return _find_forbidding(action, amplifier.change, amplifier.amount, limits)


def find_highest(action: type[Action], amplifier: Amplifier[Any], limits: Limits, most: int) -> int:
    """Return the highest level, up to `most`, that the limits allow for any command of an action class.

    Levels beyond it are one and the same. A change that cannot be asked allows all, as far as anybody knows.
    """
    change, amount = amplifier.change, amplifier.amount
    beyond = (level for level in range(1, most + 1) if _find_forbidding(action, change, level * amount, limits))
    return next(beyond, most + 1) - 1


def _find_forbidding(action: type[Action], change: Change, amplification: float, limits: Limits) -> str:
    """Return which limit forbids this amplification of every command; empty where one allows it."""
    groups = [group for found in action.vocabulary.groups.values() for group in found]
    try:
        found = {
            _find_limit(change.fraction(amplification, size), size, group, limits)
            for size, group in _list_sizes(groups)
        }
    except BaseException as error:  # whatever the change has against being asked; decisions will show it
        if is_owners(error):
            raise
        return ""
    return "" if "" in found or not found else "factor" if "factor" in found else "cap"


def _list_sizes(groups: list[Group]) -> list[tuple[float, Group]]:
    return [(_find_largest(group) * share, group) for group in groups for share in SHARES]


def _find_largest(group: Group) -> float:
    reach = [
        max(abs(low - neutral), abs(high - neutral))
        for low, high, neutral in zip(group.low, group.high, group.neutral, strict=True)
    ]
    largest = math.hypot(*reach) / group.scale
    return largest if math.isfinite(largest) else FAR


def _find_limit(fraction: float, size: float, group: Group, limits: Limits) -> str:
    if fraction > limits.cap * (1 + ROUNDING):
        return "cap"
    if limits.factor is None or group.direction != "outward":
        return ""
    return "factor" if size + fraction > limits.factor * size * (1 + ROUNDING) else ""
