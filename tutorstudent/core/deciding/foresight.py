"""What each level would execute in a decision, for the parts that want to know before they propose."""

from __future__ import annotations

from typing import Any

from tutorstudent.core.deciding.guard import Blame, Guard
from tutorstudent.core.deciding.ladder import Ladder
from tutorstudent.core.deciding.limiting import Limiter, limit
from tutorstudent.core.deciding.rendering import measure_deviation, measure_distance
from tutorstudent.core.words.actions import Action, Group
from tutorstudent.core.words.proposals import require_level


class Foresight:
    """The levels of one decision after cap, factor, bounds and slew, as they are when it is made.

    What the change raises when it is asked is the amplifier's incident; the answer is then level 0. It knows nothing of
    the turn that it belongs to, which would keep all of them alive; a copy of it is None.
    """

    __slots__ = ("_groups", "_guard", "_in_amplifier", "_ladder", "_last", "_limiter", "_original")

    def __init__(
        self, limiter: Limiter, original: Action, groups: tuple[Group, ...], guard: Guard, in_amplifier: Blame
    ) -> None:
        self._limiter, self._original, self._groups = limiter, original, groups
        self._guard, self._in_amplifier = guard, in_amplifier
        self._ladder: Ladder | None = None
        self._last = limiter.last  # as it is now: what is executed later does not count

    @property
    def ladder(self) -> Ladder:
        """What each level moves; made when it is first needed."""
        if self._ladder is None:
            self._ladder = self._limiter.make_ladder(self._original, self._groups)
        return self._ladder

    @property
    def highest(self) -> int:
        """The highest level that cap and factor allow for any command of the tutor's, up to the thesis's eight."""
        self._guard.check_recursion()
        with self._in_amplifier:
            return self._limiter.highest
        return 0

    def settle(self, level: int) -> int:
        """Return the level that would be executed if this one resulted."""
        self._guard.check_recursion()
        asked = require_level(level)
        with self._in_amplifier:
            floor, room = self._limiter.find_range(self._original.kind, self._last)
            return limit(self.ladder, max(0, asked), floor, room).level
        return 0

    def measure(self, level: int) -> tuple[float, ...]:
        """Return how far from neutral it would bring each group of components, in units of the group's scale."""
        settled, groups = self.settle(level), self._groups
        ends = self.ladder.get_rung(settled).ends
        if ends:
            return tuple([measure_distance(group, end) / group.scale for group, end in zip(groups, ends, strict=True)])
        values = self._original.__dict__
        return tuple([measure_deviation(group, values) / group.scale for group in groups])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Foresight):
            return NotImplemented
        return self._last[0] == other._last[0] and self._last[1].level == other._last[1].level

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        return type(None), ()
