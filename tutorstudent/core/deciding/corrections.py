"""What a decision becomes once somebody says that something else was executed."""

from __future__ import annotations

from typing import Any, NamedTuple

from tutorstudent.core.deciding.guard import Guard, sealed
from tutorstudent.core.deciding.limiting import LevelLimiter, reached_level
from tutorstudent.core.deciding.rendering import NOTHING, Permitted
from tutorstudent.core.deciding.teaching import Pending
from tutorstudent.core.words.actions import Action, rebuild

UNKNOWN = "the executed level could not be told"


class Correction(NamedTuple):
    """The decision with what was really executed."""

    pending: Pending
    permitted: Permitted
    """The level that was really reached."""
    untold: str
    """Why the decision teaches nothing, or empty."""


def corrected(pending: Pending, executed: Action, levels: LevelLimiter, guard: Guard) -> Correction:
    """Return the pending decision with the level that a sound executed action really reached.

    An earlier word about the same decision is taken back.
    """
    asked, record = pending.asked, rebuild(executed)
    level, permitted, untold = _reached(pending, executed, levels, guard)
    decision = asked._replace(
        selected=asked.selected._replace(level=min(level, asked.selected.level)),
        resulting=asked.resulting._replace(level=level),
        executed=record,
    )
    seals = (pending.seals[0], sealed(record))
    return Correction(pending._replace(decision=decision, executed=executed, seals=seals), permitted, untold)


def _reached(pending: Pending, executed: Any, levels: LevelLimiter, guard: Guard) -> tuple[int, Permitted, str]:
    asked, original, groups = pending.asked, pending.original, pending.groups
    try:
        level = reached_level(original, groups, executed, asked.resulting.level, levels)
        if level is not None:
            return level, levels.permit(level, original, groups), ""
        return 0, NOTHING, "something else was executed"
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        guard.record(asked.moment.number, "amplifier", error)
    return 0, NOTHING, UNKNOWN
