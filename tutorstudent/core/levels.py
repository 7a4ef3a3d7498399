"""Lowers levels to what the limits allow, before anything is rendered: recorded, executed and taught level are one."""

from __future__ import annotations

from typing import Any, NamedTuple

from tutorstudent.core.actions import Action, Group
from tutorstudent.core.interfaces import Amplifier
from tutorstudent.core.limits import Limits
from tutorstudent.core.rendering import Permitted, can_move, moved, permitted, progress, within

_ROUNDING = 1e-9


class Executed(NamedTuple):
    """What was executed last: the level from which `Limits.slew` counts."""

    kind: str
    permitted: Permitted


class LevelLimiter:
    """Applies cap, factor and slew.

    Slew holds within a kind; where the tutor changes the kind, the level counts from 0, since a level of one kind says
    nothing about another (docs/decisions/0001). Cap and factor go before slew.
    """

    def __init__(self, limits: Limits, amplifier: Amplifier[Any]) -> None:
        self._limits = limits
        self._amplifier = amplifier
        self.previous: Executed | None = None

    def permit(self, level: int, original: Action, groups: tuple[Group, ...]) -> Permitted:
        """Return the highest level up to `level` that cap and factor allow."""
        return permitted(level, groups, original.__dict__, self._fraction, self._limits)

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
        if resulting > selected and not can_move(groups, original.__dict__):
            resulting = selected
        result = self.permit(min(resulting, self._ceiling(original.kind, resulting)), original, groups)
        floor = self._floor(original.kind)
        if floor > result.level:
            result = self.permit(floor, original, groups)
            selected = max(selected, result.level)
        return selected, result

    def fall_back(self, original: Action, groups: tuple[Group, ...]) -> Permitted:
        """Return the tutor's own action, through slew where that is set, without asking any part.

        The way down reuses the distances that were last executed, since the amplifier may be what is broken.
        """
        floor, nothing = self._floor(original.kind), Permitted(0, (0.0,) * len(groups))
        if floor == 0 or self.previous is None:
            return nothing
        last = self.previous.permitted
        fractions = tuple(fraction * floor / last.level for fraction in last.fractions)
        return Permitted(floor, fractions) if within(fractions, groups, original.__dict__, self._limits) else nothing

    def _fraction(self, level: int, magnitude: float) -> float:
        return self._amplifier.change.fraction(level * self._amplifier.amount, magnitude)

    def _last_level(self, kind: str) -> int:
        return self.previous.permitted.level if self.previous is not None and self.previous.kind == kind else 0

    def _ceiling(self, kind: str, level: int) -> int:
        return level if self._limits.slew is None else self._last_level(kind) + self._limits.slew

    def _floor(self, kind: str) -> int:
        return 0 if self._limits.slew is None else max(0, self._last_level(kind) - self._limits.slew)


def reached_level(
    original: Action, groups: tuple[Group, ...], executed: Action, level: int, levels: LevelLimiter
) -> int | None:
    """Return the highest level up to `level` that an executed action reached.

    None if it is not an amplification of the tutor's action at all: another kind, other components changed, less than
    the tutor's own action, or more than was asked for.
    """
    own, done = original.__dict__, executed.__dict__
    movable = {name for group in groups for name in group.names}
    if executed.kind != original.kind or any(
        done[name] != own[name] for name in original.vocabulary.fields if name not in movable
    ):
        return None
    if any(not _between(group, own, done, 0.0, f) for group, f in _with(level, original, groups, levels)):
        return None
    return next(
        lower
        for lower in range(level, -1, -1)
        if all(_between(group, own, done, f, float("inf")) for group, f in _with(lower, original, groups, levels))
    )


def _with(level: int, original: Action, groups: tuple[Group, ...], levels: LevelLimiter) -> list[tuple[Group, float]]:
    return list(zip(groups, levels.permit(level, original, groups).fractions, strict=True))


def _between(group: Group, own: dict[str, float], done: dict[str, float], low: float, high: float) -> bool:
    slack = _ROUNDING * group.scale
    ends = dict(zip(group.names, moved(group, own, low), strict=True))
    if progress(group, own, done) < progress(group, own, ends) - slack:
        return False
    if high == float("inf"):
        return True
    ends = dict(zip(group.names, moved(group, own, high), strict=True))
    return progress(group, own, done) <= progress(group, own, ends) + slack
