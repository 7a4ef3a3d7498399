"""What a turn becomes once somebody says that something else was executed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Generic

from tutorstudent.core.deciding.checking import seal
from tutorstudent.core.deciding.guard import Guard
from tutorstudent.core.deciding.ladder import ROUNDING, Ladder
from tutorstudent.core.deciding.limiting import Limiter
from tutorstudent.core.deciding.rendering import measure_deviation, move
from tutorstudent.core.words.actions import Action, ActionT, Group, rebuild
from tutorstudent.core.words.records import StateT
from tutorstudent.core.words.turn import FOOT, Rung, Turn

UNKNOWN = "the executed level could not be told"
TOLD = "executed"
"""What bound a level that somebody else lowered."""


class Corrector(Generic[StateT, ActionT]):
    """Writes into a turn what was really executed, with the level that it really reached."""

    def __init__(self, limiter: Limiter, guard: Guard) -> None:
        self._limiter, self._in_amplifier = limiter, guard.blame("amplifier")

    def correct(self, turn: Turn[StateT, ActionT], executed: ActionT) -> None:
        """Take in a sound executed action. An earlier word about the same decision is taken back."""
        turn._untold = UNKNOWN  # should telling it raise
        level, ladder = 0, self._limiter.get_ladder(turn)
        with self._in_amplifier:
            reached = find_level(turn, executed, ladder)
            level, turn._untold = reached or 0, "" if reached is not None else "something else was executed"
        self._write(turn, executed, level, ladder.get_rung(level))

    def take_back(self, turn: Turn[StateT, ActionT]) -> None:
        """Take in that the tutor's own action was executed after all."""
        turn._untold = ""
        self._write(turn, turn._original, 0, FOOT)

    def _write(self, turn: Turn[StateT, ActionT], executed: ActionT, level: int, rung: Rung) -> None:
        asked, record = turn._asked, rebuild(executed)
        turn._limited_by = TOLD if level < asked.resulting.level else turn._decided_by
        turn._decision = asked._replace(
            selected=asked.selected._replace(level=min(level, asked.selected.level)),
            resulting=asked.resulting._replace(level=level),
            executed=record,
        )
        turn._action, turn._seals = executed, (turn._seals[0], seal(record))
        self._limiter.remember(turn._original.kind, level, rung)


def find_level(turn: Turn[Any, Any], executed: Action, ladder: Ladder) -> int | None:
    """Return the highest level up to the one that was asked for that an executed action reached.

    None if it is not an amplification of the tutor's action at all: another kind, other components changed, another
    direction, less than the tutor's own action, or more than was asked for.
    """
    original, groups = turn._original, turn._groups
    own, done = original.__dict__, executed.__dict__
    movable = {name for group in groups for name in group.names}
    if any(done[name] != own[name] for name in original.vocabulary.fields if name not in movable):
        return None
    if all(done[name] == own[name] for name in movable):
        return 0
    ways = [measure_progress(group, own, done) for group in groups]
    top = ladder.climb(turn._asked.resulting.level)
    most = _measure_level(top, turn, ladder)
    slack = [ROUNDING * _measure_size(group, own, done) for group in groups]
    found = list(zip(ways, most, slack, strict=True))
    if any(way is None or not -free <= way <= mark + free for way, mark, free in found):
        return None
    levels = dict.fromkeys(ladder.climb(level) for level in range(top, -1, -1))
    return next(
        level
        for level in levels
        if all(
            (way or 0.0) >= mark - free
            for way, mark, free in zip(ways, _measure_level(level, turn, ladder), slack, strict=True)
        )
    )


def _measure_size(group: Group, own: Mapping[str, float], done: Mapping[str, float]) -> float:
    """Return the largest number in the group, in units of its scale: what rounding errors are measured by."""
    return max(abs(values[name]) for values in (own, done) for name in group.names) / group.scale


def _measure_level(level: int, turn: Turn[Any, Any], ladder: Ladder) -> list[float]:
    """Return how far a level moves each group, after clipping, in units of its scale."""
    own, ends = turn._original.__dict__, ladder.get_rung(level).ends
    if not ends:
        return [0.0] * len(turn._groups)
    named = [dict(zip(group.names, end, strict=True)) for group, end in zip(turn._groups, ends, strict=True)]
    return [measure_progress(group, own, end) or 0.0 for group, end in zip(turn._groups, named, strict=True)]


def measure_progress(group: Group, values: Mapping[str, float], ends: Mapping[str, float]) -> float | None:
    """Return how far `ends` lies from the tutor's values in the group's direction, in units of its scale.

    Negative means less than the tutor's own. None means that it does not lie in that direction.
    """
    if group.direction == "outward":
        distance = measure_deviation(group, ends) - measure_deviation(group, values)
    else:
        distance = (ends[group.names[0]] - values[group.names[0]]) * (1 if group.direction == "+" else -1)
    if distance < 0:
        return distance / group.scale
    on_the_way = move(group, values, distance / group.scale)
    off = max(abs(ends[name] - value) for name, value in zip(group.names, on_the_way, strict=True))
    return distance / group.scale if off <= ROUNDING * _measure_size(group, values, ends) * group.scale else None
