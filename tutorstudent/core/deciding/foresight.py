"""What each level would execute in a decision, for the parts that want to know before they propose."""

from __future__ import annotations

from typing import Any

from tutorstudent.core.deciding.guard import Blame
from tutorstudent.core.deciding.limiting import Limiter
from tutorstudent.core.deciding.rendering import measure_deviation, measure_distance
from tutorstudent.core.words.turn import Turn


class Foresight:
    """The levels of one decision after cap, factor, bounds and slew, as they are when it is made.

    What the change raises when it is asked is the amplifier's incident; the answer is then level 0.
    """

    __slots__ = ("_blame", "_floor", "_limiter", "_room", "_turn")

    def __init__(self, limiter: Limiter, turn: Turn[Any, Any], blame: Blame) -> None:
        self._limiter, self._turn, self._blame = limiter, turn, blame
        self._floor, self._room = limiter.find_range(turn)

    @property
    def highest(self) -> int:
        """The highest level that cap and factor allow for any command of the tutor's, up to the thesis's eight."""
        with self._blame:
            return self._limiter.highest
        return 0

    def settle(self, level: int) -> int:
        """Return the level that would be executed if this one resulted."""
        asked = max(self._floor, level if self._room is None else min(level, self._room))
        with self._blame:
            return self._limiter.get_ladder(self._turn).climb(asked)
        return 0

    def measure(self, level: int) -> tuple[float, ...]:
        """Return how far from neutral it would bring each group of components, in units of the group's scale."""
        turn, settled = self._turn, self.settle(level)
        groups = turn._groups
        ends = self._limiter.get_ladder(turn).get_rung(settled).ends
        if ends:
            return tuple([measure_distance(group, end) / group.scale for group, end in zip(groups, ends, strict=True)])
        values = turn._original.__dict__
        return tuple([measure_deviation(group, values) / group.scale for group in groups])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Foresight):
            return NotImplemented
        return (self._floor, self._room) == (other._floor, other._room)

    __hash__ = None  # type: ignore[assignment]
