"""The tutor's seat: what the engine does when the tutor itself fails, which no wrapper can replace."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Generic

from tutorstudent.core.deciding.guard import Guard
from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.words.actions import ActionT, rebuild
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.records import StateT


class TutorSeat(Generic[StateT, ActionT]):
    """Asks the tutor; where it fails, raises or hands out the action that the owner wrote down."""

    def __init__(self, tutor: Tutor[StateT, ActionT], guard: Guard, on_failure: ActionT | None) -> None:
        self._tutor, self._guard, self._on_failure = tutor, guard, on_failure
        self.hears = type(tutor).executed is not Tutor.executed

    def ask(self, number: int, state: StateT) -> tuple[ActionT, ActionT, str, bool]:
        """Call the tutor once.

        Returns:
            A sound action that nobody but the engine sees, its copy, the situation, and whether the tutor failed.
        """
        try:
            action = self._tutor.act(state)
            if type(action) is not self._tutor.action:
                raise ContractError(
                    f"tutor '{self._tutor.name}' returned {type(action).__name__}; "
                    f"expected {self._tutor.action.__name__}. Tutors return an action of their class for every state."
                )
            shown, situation = rebuild(action), self._tutor.situation
            if not isinstance(situation, str):
                raise ContractError(
                    f"tutor '{self._tutor.name}': situation is {situation!r}; it is a string, '' for none."
                )
            return action, shown, situation, False
        except KeyboardInterrupt:
            raise
        except BaseException as error:
            if self._on_failure is None:
                raise
            self._guard.record(number, "tutor", error)
            return self._on_failure, rebuild(self._on_failure), "", True

    def tell(self, number: int, executed: ActionT) -> None:
        """Tell the tutor what was really executed; for tutors that listen (`hears`)."""
        self._call(number, lambda: self._tutor.executed(rebuild(executed)))

    def reset(self, number: int) -> None:
        """Begin a trial."""
        self._call(number, self._tutor.reset)

    def _call(self, number: int, function: Callable[[], Any]) -> None:
        if self._on_failure is None:
            function()
        else:
            self._guard.call(number, "tutor", function)
