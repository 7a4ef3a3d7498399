"""Lowers levels to what the limits allow, before anything is rendered: recorded, executed and taught level are one."""

from __future__ import annotations

from typing import Any

from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.deciding.rendering import (
    NOTHING,
    Fractions,
    Permitted,
    can_move,
    exact_fraction,
    magnitudes,
    moved,
    permitted,
    progress,
)
from tutorstudent.core.roles.interfaces import Amplifier
from tutorstudent.core.words.actions import Action, Group

HIGHEST_LEVEL = 1000
"""No level goes beyond it, even where a level moves nothing."""
_ROUNDING = 1e-9


class LevelLimiter:
    """Applies cap, factor and slew.

    Slew holds within a kind; where the tutor changes the kind, the level counts from 0, since a level of one kind says
    nothing about another (docs/decisions/0001). Cap and factor go before slew.
    """

    def __init__(self, limits: Limits, amplifier: Amplifier[Any]) -> None:
        self._limits, self._slew = limits, limits.slew
        self._change = amplifier.change
        self._amount = amplifier.amount
        self._sized: tuple[Action | None, Fractions] = (None, ())
        self.forget()

    def forget(self) -> None:
        """Begin a trial: slew counts from level 0."""
        self._last_kind, self._last = "", NOTHING

    def remember(self, kind: str, executed: Permitted) -> None:
        """Take in what is executed: slew counts from there."""
        self._last_kind, self._last = kind, executed

    def permit(self, level: int, original: Action, groups: tuple[Group, ...]) -> Permitted:
        """Return the highest level up to `level` that cap and factor allow."""
        level = min(level, HIGHEST_LEVEL)
        change, amount = self._change, self._amount
        sizes = self._sizes(original, groups) if level else ()

        def fractions_at(level: int) -> Fractions:
            return tuple([exact_fraction(change.fraction(level * amount, size)) for size in sizes])

        return permitted(level, groups, original.__dict__, fractions_at, self._limits)

    def select(self, level: int, original: Action, groups: tuple[Group, ...]) -> int:
        """Return what the limits leave of a selected level."""
        return level and self.permit(min(level, self._ceiling(original.kind, level)), original, groups).level

    def result(
        self, selected: int, resulting: int, original: Action, groups: tuple[Group, ...]
    ) -> tuple[int, Permitted]:
        """Return what the limits leave of the selected and the resulting level.

        The selected level is only raised where slew holds the resulting level up, so that slowing down is never taken
        for amplification.
        """
        if resulting == 0 and self._slew is None:
            return selected, NOTHING
        if resulting > selected and not can_move(groups, original.__dict__):
            resulting = selected
        result = self.permit(min(resulting, self._ceiling(original.kind, resulting)), original, groups)
        if self._slew is not None and (floor := self._floor(original.kind)) > result.level:
            result = self.permit(floor, original, groups)
            selected = max(selected, result.level)
        return selected, result

    def fall_back(self, original: Action, groups: tuple[Group, ...]) -> Permitted:
        """Return the tutor's own action, through slew where that is set, without asking any part.

        The way down reuses the distances that were last executed, since the amplifier may be what is broken.
        """
        floor = self._floor(original.kind)
        if floor == 0:
            return NOTHING
        last = self._last

        def fractions_at(level: int) -> Fractions:
            return tuple([fraction * level / last.level for fraction in last.fractions])

        return permitted(floor, groups, original.__dict__, fractions_at, self._limits)

    def _sizes(self, original: Action, groups: tuple[Group, ...]) -> Fractions:
        # Most decisions ask twice, and a tutor with a finite vocabulary says the same object for long.
        if original is not self._sized[0]:
            self._sized = original, magnitudes(groups, original.__dict__)
        return self._sized[1]

    def _last_level(self, kind: str) -> int:
        return self._last.level if self._last_kind == kind else 0

    def _ceiling(self, kind: str, level: int) -> int:
        return level if self._slew is None else self._last_level(kind) + self._slew

    def _floor(self, kind: str) -> int:
        return 0 if self._slew is None else max(0, self._last_level(kind) - self._slew)


def reached_level(
    original: Action, groups: tuple[Group, ...], executed: Action, level: int, levels: LevelLimiter
) -> int | None:
    """Return the highest level up to `level` that an executed action reached.

    None if it is not an amplification of the tutor's action at all: another kind, other components changed, another
    direction, less than the tutor's own action, or more than was asked for.
    """
    own, done = original.__dict__, executed.__dict__
    movable = {name for group in groups for name in group.names}
    if any(done[name] != own[name] for name in original.vocabulary.fields if name not in movable):
        return None
    ways = [progress(group, own, done) for group in groups]
    if any(way is None or way < -_ROUNDING for way in ways):
        return None
    if not _reached(ways, _progress_of(level, original, groups, levels), at_most=True):
        return None
    return next(
        lower
        for lower in range(level, -1, -1)
        if _reached(ways, _progress_of(lower, original, groups, levels), at_most=False)
    )


def _progress_of(level: int, original: Action, groups: tuple[Group, ...], levels: LevelLimiter) -> list[float]:
    own, fractions = original.__dict__, levels.permit(level, original, groups).fractions
    if not fractions:
        return [0.0] * len(groups)
    ends = [
        dict(zip(group.names, moved(group, own, fraction), strict=True))
        for group, fraction in zip(groups, fractions, strict=True)
    ]
    return [progress(group, own, end) or 0.0 for group, end in zip(groups, ends, strict=True)]


def _reached(ways: list[float | None], marks: list[float], *, at_most: bool) -> bool:
    pairs = [(way or 0.0, mark) for way, mark in zip(ways, marks, strict=True)]
    if at_most:
        return all(way <= mark + _ROUNDING for way, mark in pairs)
    return all(way >= mark - _ROUNDING for way, mark in pairs)
