"""Keeps what goes wrong in a part from reaching the robot, and remembers it."""

from __future__ import annotations

import operator
from collections import Counter, deque
from collections.abc import Callable
from typing import Any, Literal

from pydantic import ValidationError

from tutorstudent.core.words.actions import Action, ActionT, rebuild
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.proposals import require_bit, require_level
from tutorstudent.core.words.records import GradedAction, Incident

OnIncident = Literal["continue", "raise"]
REMEMBERED = 1000

Seal = tuple[object, ...]
"""The very objects that an action holds."""


class Breach(Exception):
    """A part did something that its contract forbids, other than raising. Never leaves the engine."""

    def __init__(self, kind: str, message: str) -> None:
        super().__init__(message)
        self.kind = kind


class Guard:
    """Records incidents. It never grows without bound: it counts all and remembers the newest."""

    def __init__(self, on_incident: OnIncident) -> None:
        self.on_incident = on_incident
        self.counts: Counter[tuple[str, str]] = Counter()
        """Incidents by (part, kind)."""
        self.log: deque[Incident] = deque(maxlen=REMEMBERED)
        self.turn: list[Incident] = []
        """Incidents of the current decision."""

    def record(self, decision: int, part: str, error: BaseException) -> None:
        """Remember an incident; in ``raise`` mode, raise it.

        Raises:
            ContractError: where incidents are to be raised.
        """
        kind = error.kind if isinstance(error, Breach) else "raised"
        incident = Incident(decision, part, kind, _say(error))
        self.counts[part, kind] += 1
        self.log.append(incident)
        self.turn.append(incident)
        if self.on_incident == "raise":
            raise ContractError(f"decision {decision}: {part}: {kind}: {incident.message}") from error

    def call(self, decision: int, part: str, function: Callable[[], Any]) -> None:
        """Call something that belongs to a part; what it raises is an incident."""
        try:
            function()
        except KeyboardInterrupt:
            raise
        except BaseException as error:
            self.record(decision, part, error)


def _say(error: BaseException) -> str:
    name = type(error).__name__
    try:
        return str(error) if isinstance(error, Breach) else f"{name}: {error}"[:500]
    except KeyboardInterrupt:
        raise
    except BaseException:
        return f"{name} (its message could not be read)"


def checked_replica(action: ActionT, what: str) -> ActionT:
    """Return a validated copy of an action that somebody handed in; raises ContractError if it is not sound."""
    try:
        return rebuild(action)
    except (ValidationError, KeyError) as error:
        problem = error.errors(include_url=False)[0]["msg"] if isinstance(error, ValidationError) else f"no {error}"
        raise ContractError(f"{what}: the {type(action).__name__} is not sound: {problem}.") from None


def sealed(action: Action) -> Seal:
    """Return what an action holds, to tell later whether it still holds the same."""
    return tuple(action.__dict__.values())


def check_intact(shown: Action, seal: Seal) -> None:
    """Raise a `Breach` if the copy that parts were shown was changed.

    Objects are compared, not values: what was put there in place of a number may lie about being equal.
    """
    held = shown.__dict__
    if len(held) < len(seal) or not all(map(operator.is_, held.values(), seal)):
        raise Breach("mutated", "the action was changed; records are for reading.")


def received(graded: Any, shown: ActionT) -> GradedAction[ActionT]:
    """Return a part's graded action with plain values, round the action that the part was shown."""
    if type(graded) is not GradedAction:
        raise Breach("wrong-return", f"returned {type(graded).__name__}; return a GradedAction.")
    action, level, ampbit = graded
    if action is shown and type(level) is int and level >= 0 and (ampbit is True or ampbit is False):
        return graded
    if action is not shown and action != shown:
        raise Breach("wrong-return", "returned another action than the tutor's; parts move levels and bits only.")
    level, ampbit = require_level(level), require_bit(ampbit)
    if level < 0:
        raise Breach("out-of-bounds", f"returned the level {level}; levels are 0 or more.")
    return GradedAction(shown, level, ampbit)
