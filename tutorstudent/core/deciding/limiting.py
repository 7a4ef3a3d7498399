"""Lowers levels to what the limits allow, before anything is rendered: recorded, executed and taught level are one."""

from __future__ import annotations

from functools import cached_property, partial
from typing import Any, NamedTuple

from tutorstudent.core.deciding.ladder import Ladder, ask_change, scale_fractions
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.deciding.reach import HIGHEST_USEFUL, find_highest
from tutorstudent.core.deciding.rendering import measure_deviation
from tutorstudent.core.roles.interfaces import Amplifier
from tutorstudent.core.words.actions import Action, Group
from tutorstudent.core.words.turn import FOOT, Fractions, Rung, Turn


class Limited(NamedTuple):
    """A level within the limits, and why it is another than was asked for."""

    level: int
    rung: Rung
    by: str = ""
    is_held: bool = False
    """Whether slew holds it up."""


NOTHING = Limited(0, FOOT)


class Limiter:
    """Applies cap, factor and slew.

    Slew holds within a kind; where the tutor changes the kind, the level counts from 0, since a level of one kind says
    nothing about another (docs/decisions/0001). Cap and factor go before slew.
    """

    def __init__(self, limits: Limits, amplifier: Amplifier[Any], action: type[Action]) -> None:
        self._amplifier, self._action = amplifier, action
        self._limits, self._slew = limits, limits.slew
        self._change, self._amount = amplifier.change, amplifier.amount
        self._sized: tuple[Action | None, Fractions] = None, ()
        self.last: tuple[str, Limited] = "", NOTHING
        """Kind and level of what was executed last: slew counts from there."""

    @cached_property
    def highest(self) -> int:
        """The highest level that cap and factor allow for any command, up to the highest useful one."""
        return find_highest(self._action, self._amplifier, self._limits, HIGHEST_USEFUL)

    def forget(self) -> None:
        """Begin a trial: slew counts from level 0."""
        self.last = "", NOTHING

    def remember(self, kind: str, level: int, rung: Rung) -> None:
        """Take in what is executed: slew counts from there."""
        self.last = kind, Limited(level, rung)

    def find_range(self, kind: str, last: tuple[str, Limited]) -> tuple[int, int | None]:
        """Return the lowest and the highest level that slew allows for a kind after what was executed last."""
        if self._slew is None:
            return 0, None
        level = last[1].level if last[0] == kind else 0
        return max(0, level - self._slew), level + self._slew

    def get_ladder(self, turn: Turn[Any, Any]) -> Ladder:
        """Return what each level would move in a turn, as the amplifier's change says; made when it is first needed."""
        ladder: Ladder = turn._foresight.ladder
        return ladder

    def make_ladder(self, original: Action, groups: tuple[Group, ...]) -> Ladder:
        """Return what each level would move, as the amplifier's change says."""
        measure = partial(ask_change, self._change, self._amount, self._find_sizes(original, groups))
        return Ladder(measure, original, groups, self._limits)

    def limit_selected(self, turn: Turn[Any, Any]) -> tuple[int, str]:
        """Return what the limits leave of the selected level, and why it is another."""
        level = turn._selected.level
        if not level:
            return 0, ""
        _, room = self.find_range(turn._original.kind, self.last)
        return _climb(self.get_ladder(turn), level, room)

    def limit_resulting(self, turn: Turn[Any, Any], resulting: int) -> Limited:
        """Return what the limits leave of the resulting level; slew may hold it up."""
        floor, room = self.find_range(turn._original.kind, self.last)
        if resulting == floor == 0:
            return NOTHING
        return limit(self.get_ladder(turn), resulting, floor, room)

    def fall_back(self, turn: Turn[Any, Any]) -> Limited:
        """Return the tutor's own action, through slew where that is set, without asking any part.

        The way down reuses the distances that were last executed, since the amplifier may be what is broken.
        """
        floor, _ = self.find_range(turn._original.kind, self.last)
        if floor == 0:
            return NOTHING
        measure = partial(scale_fractions, self.last[1].rung.fractions, self.last[1].level)
        return _hold(floor, 0, "", Ladder(measure, turn._original, turn._groups, self._limits))

    def _find_sizes(self, original: Action, groups: tuple[Group, ...]) -> Fractions:
        # A tutor with a finite vocabulary says the same object for long.
        if original is not self._sized[0]:
            values = original.__dict__
            self._sized = original, tuple([measure_deviation(group, values) / group.scale for group in groups])
        return self._sized[1]


def limit(ladder: Ladder, asked: int, floor: int, room: int | None) -> Limited:
    """Return what cap, factor, bounds and slew leave of a level; slew may hold it up.

    Args:
        ladder: What each level would move.
        asked: The level.
        floor: The lowest level that slew allows.
        room: The highest level that slew allows; None without slew.
    """
    level, by = _climb(ladder, asked, room)
    return _hold(floor, level, by, ladder) if floor > level else Limited(level, ladder.get_rung(level), by)


def _climb(ladder: Ladder, asked: int, room: int | None) -> tuple[int, str]:
    by = ""
    if room is not None and asked > room:
        asked, by = room, "slew"
    level = ladder.climb(asked)
    return level, by if level == asked else ladder.limit


def _hold(floor: int, level: int, by: str, ladder: Ladder) -> Limited:
    held = ladder.climb(floor)
    return Limited(held, ladder.get_rung(held), "slew" if held > level else by, is_held=True)
