"""The tutor's seat: what the engine does when the tutor itself fails, which no wrapper can replace."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Generic

from tutorstudent.core.deciding.checking import seal
from tutorstudent.core.deciding.foresight import Foresight
from tutorstudent.core.deciding.guard import Guard
from tutorstudent.core.deciding.limiting import Limiter
from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.words.actions import ActionT, rebuild
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.records import Margins, Moment, StateT
from tutorstudent.core.words.turn import Turn


class TutorSeat(Generic[StateT, ActionT]):
    """Asks the tutor; where it fails, raises or takes the action that the owner wrote down."""

    def __init__(
        self, tutor: Tutor[StateT, ActionT], guard: Guard, on_failure: ActionT | None, limiter: Limiter
    ) -> None:
        self._tutor, self._guard, self._on_failure = tutor, guard, on_failure
        self._limiter, self._in_amplifier = limiter, guard.blame("amplifier")
        self.hears = type(tutor).executed is not Tutor.executed

    def ask(
        self, turn: Turn[StateT, ActionT], number: int, state: StateT, shown: StateT, margins: Margins | None
    ) -> None:
        """Call the tutor once and write its action into the turn, with the copy that parts are shown.

        Where it fails, the owner's action stands in for it and the turn is void.
        """
        try:
            action = self._tutor.act(state)
            if type(action) is not self._tutor.action:
                raise ContractError(
                    f"tutor '{self._tutor.name}' returned {type(action).__name__}; "
                    f"expected {self._tutor.action.__name__}. Tutors return an action of their class for every state."
                )
            copy, situation = rebuild(action), self._tutor.situation
            if not isinstance(situation, str):
                raise ContractError(
                    f"tutor '{self._tutor.name}': situation is {situation!r}; it is a string, '' for none."
                )
        except BaseException as error:
            if self._on_failure is None:
                raise
            self._guard.record("tutor", error)
            action, copy, situation = self._on_failure, rebuild(self._on_failure), ""
            turn._void = "the tutor failed"
        turn._original, turn._groups = action, action.vocabulary.groups[action.kind]
        turn._foresight = Foresight(self._limiter, action, turn._groups, self._guard, self._in_amplifier)
        turn._moment = Moment(number, shown, copy, situation, margins, turn._foresight)
        turn._seals = (held := seal(copy)), held

    def tell(self, turn: Turn[StateT, ActionT]) -> None:
        """Tell the tutor what was really executed; for tutors that listen (`hears`)."""
        self._call(lambda: self._tutor.executed(rebuild(turn._decision.executed)))

    def reset(self) -> None:
        """Begin a trial."""
        self._call(self._tutor.reset)

    def _call(self, function: Callable[[], Any]) -> None:
        if self._on_failure is None:
            function()
        else:
            self._guard.call("tutor", function)
