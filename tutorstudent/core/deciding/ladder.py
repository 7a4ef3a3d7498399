"""How far each level would move this decision's action, as far as cap and factor allow."""

from __future__ import annotations

import math
from collections.abc import Callable

from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.deciding.rendering import can_move, measure_deviation, measure_distance, move
from tutorstudent.core.roles.leaves import Change
from tutorstudent.core.words.actions import Action, Group
from tutorstudent.core.words.proposals import require_number
from tutorstudent.core.words.turn import FOOT, Ends, Fractions, Rung

HIGHEST_LEVEL = 1000
"""No level goes beyond it."""
ROUNDING = 1e-9
"""3 x 0.1 is 0.30000000000000004: a limit has to hold for the level that was meant. Relative: commands may be tiny."""


class Ladder:
    """What the levels of one decision move, as far as cap and factor allow; each level is measured once.

    Fractions are taken to grow with the level. Every level that is returned was measured itself, so a change whose
    fractions do not grow can lose amplification but never break a limit.
    """

    __slots__ = ("_allowed", "_groups", "_limits", "_measure", "_own", "_rungs", "_values", "limit")

    def __init__(
        self, measure: Callable[[int], Fractions], original: Action, groups: tuple[Group, ...], limits: Limits
    ) -> None:
        self._measure, self._groups, self._values, self._limits = measure, groups, original.__dict__, limits
        self._own = tuple([tuple([self._values[name] for name in group.names]) for group in groups])
        self._allowed: list[float] = []
        self._rungs: dict[int, Rung | str] = {0: FOOT}
        """What each level moves, or what forbids it."""
        self.limit = ""
        """What forbade the last level that was too high: ``cap``, ``factor``, ``highest level``, ``bounds`` or
        ``nothing to move``.
        """

    def climb(self, level: int) -> int:
        """Return the highest level up to `level` that cap and factor allow and that moves more than the one below."""
        if level > HIGHEST_LEVEL:
            level, self.limit = HIGHEST_LEVEL, "highest level"
        return self._settle(level if self._allows(level) is not None else self._find_allowed(level))

    def get_rung(self, level: int) -> Rung:
        """Return what a level moves that was climbed to."""
        return rung if isinstance(rung := self._rungs[level], Rung) else FOOT

    def _find_allowed(self, level: int) -> int:
        low, high = 0, level
        while high - low > 1:
            middle = (low + high) // 2
            if self._allows(middle) is not None:
                low = middle
            else:
                high = middle
        return low

    def _settle(self, level: int) -> int:
        """Return the lowest level that moves the action as far as this one, where a bound makes it void.

        A change that does not grow from one level to the next is its author's affair: its levels stay what they are.
        """
        if level == 0:
            return 0
        ends = self._reach(level)
        if ends == self._own:
            self.limit = "bounds" if self._is_stopped(level) else "nothing to move"
            return 0
        if self._reach(level - 1) != ends or self.get_rung(level).fractions == self.get_rung(level - 1).fractions:
            return level
        low, high = 0, level - 1
        while high - low > 1:
            middle = (low + high) // 2
            if self._reach(middle) == ends:
                high = middle
            else:
                low = middle
        self.limit = "bounds"
        return high

    def _is_stopped(self, level: int) -> bool:
        """Return whether a level would move something, were it not for the bounds."""
        pairs = zip(self._groups, self.get_rung(level).fractions, strict=True)
        return any(fraction > 0 and can_move(group, self._values) for group, fraction in pairs)

    def _reach(self, level: int) -> Ends | None:
        rung = self._allows(level)
        return None if rung is None else rung.ends or self._own

    def _allows(self, level: int) -> Rung | None:
        rung = self._rungs.get(level)
        if rung is None:
            rung = self._rungs[level] = self._find_rung(self._measure(level))
        if isinstance(rung, Rung):
            return rung
        self.limit = rung
        return None

    def _find_rung(self, fractions: Fractions) -> Rung | str:
        if max(fractions or (0.0,)) > self._limits.cap * (1 + ROUNDING):
            return "cap"
        groups, values = self._groups, self._values
        ends = tuple([move(group, values, part) for group, part in zip(groups, fractions, strict=True)])
        if self._limits.factor is not None and self._exceeds(self._limits.factor, ends):
            return "factor"
        return Rung(fractions, ends)

    def _exceeds(self, factor: float, ends: Ends) -> bool:
        groups = self._groups
        if not self._allowed:
            self._allowed = [factor * measure_deviation(group, self._values) * (1 + ROUNDING) for group in groups]
        return any(
            measure_distance(group, end) > allowed
            for group, end, allowed in zip(groups, ends, self._allowed, strict=True)
        )


def ask_change(change: Change, amount: float, sizes: Fractions, level: int) -> Fractions:
    """Return what a level moves, as a change says.

    Args:
        change: The amplifier's.
        amount: The amplifier's.
        sizes: The tutor's own distance from neutral for each group, in units of its scale.
        level: 1 or more.
    """
    amplification = level * amount
    return tuple([require_fraction(change.fraction(amplification, size)) for size in sizes])


def scale_fractions(fractions: Fractions, from_level: int, level: int) -> Fractions:
    """Return what a level moves where `from_level` moved these fractions: the way down without asking a part."""
    return tuple([fraction * level / from_level for fraction in fractions])


def require_fraction(fraction: float) -> float:
    """Return what a change returned as a plain float; ValueError if it is not finite or negative."""
    if type(fraction) is float and 0.0 <= fraction < math.inf:
        return fraction
    plain = require_number(fraction)
    if not 0 <= plain < math.inf:
        raise ValueError(f"a change returned {plain}; a fraction is finite and not negative")
    return plain
