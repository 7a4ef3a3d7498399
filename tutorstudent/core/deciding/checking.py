"""What is checked of everything that a part hands back or was shown."""

from __future__ import annotations

import operator
from typing import Any

from pydantic import ValidationError

from tutorstudent.core.deciding.guard import Breach
from tutorstudent.core.words.actions import Action, ActionT, rebuild
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.proposals import require_bit, require_level
from tutorstudent.core.words.records import GradedAction
from tutorstudent.core.words.turn import Seal, Turn


def copy_checked(action: ActionT, what: str) -> ActionT:
    """Return a validated copy of an action that somebody handed in; raises ContractError if it is not sound."""
    try:
        return rebuild(action)
    except (ValidationError, KeyError) as error:
        problem = error.errors(include_url=False)[0]["msg"] if isinstance(error, ValidationError) else f"no {error}"
        raise ContractError(f"{what}: the {type(action).__name__} is not sound: {problem}.") from None


def seal(action: Action) -> Seal:
    """Return what an action is and holds, to tell later whether it still is and holds the same."""
    read = action.vocabulary.read
    return type(action), read, read(action.__dict__)


def check_seal(action: Action, sealed: Seal) -> None:
    """Raise a `Breach` if the copy that parts were shown was changed.

    Objects are compared, not values: what was put there in place of a number may lie about being equal.
    """
    kind, read, held = sealed
    try:
        if type(action) is kind and all(map(operator.is_, read(action.__dict__), held)):
            return
    except KeyError:
        pass
    raise Breach("mutated", "the action was changed; records are for reading.")


def check_records(turn: Turn[Any, Any]) -> None:
    """Raise a `Breach` if a part spoilt the actions in a turn's records."""
    decision = turn._decision
    check_seal(decision.moment.tutor_action, turn._seals[0])
    if decision.executed is not decision.moment.tutor_action:
        check_seal(decision.executed, turn._seals[1])


def renew_records(turn: Turn[Any, Any]) -> None:
    """Write fresh copies into a turn's records, after a part spoilt the old ones."""
    decision, shown, executed = turn._decision, rebuild(turn._original), rebuild(turn._action)
    turn._moment = decision.moment._replace(tutor_action=shown)
    turn._seals = seal(shown), seal(executed)
    turn._decision = decision._replace(
        moment=turn._moment,
        selected=decision.selected._replace(action=shown),
        resulting=decision.resulting._replace(action=shown),
        executed=executed,
    )
    if turn._lesson is not None:
        target = turn._lesson.target._replace(action=shown)
        turn._lesson = turn._lesson._replace(moment=turn._moment, target=target, executed=executed)


def check_proposal(proposal: Any, expected: type[Any]) -> None:
    """Raise a `Breach` unless a proposal is of the type that was agreed on and holds what its type says."""
    if type(proposal) is not expected:
        raise Breach("wrong-return", f"propose() returned {type(proposal).__name__}; return {expected.__name__}.")
    said = proposal.__dict__
    level, ampbit, kind = said.get("level"), said.get("ampbit"), said.get("kind")
    if type(level) is not int or level < 0 or type(ampbit) is not bool or not (kind is None or type(kind) is str):
        raise Breach("wrong-return", "propose() returned a proposal that was not validated; make it by its class.")


def check_graded(graded: Any, shown: ActionT) -> GradedAction[ActionT]:
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
