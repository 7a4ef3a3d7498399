"""Stand-ins for the parts of an engine whose levels a learner outside it chooses."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from tutorstudent.core.roles import part
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.roles.interfaces import Amplifier, Student, Tutor
from tutorstudent.core.roles.leaves import Change, Encoder
from tutorstudent.core.roles.part import Component, Field
from tutorstudent.core.roles.part_options import Part
from tutorstudent.core.words.actions import Action, ActionT, rebuild
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.proposals import LevelProposal
from tutorstudent.core.words.records import GradedAction, Lesson, Moment, StateT


class Outside(Student[StateT, ActionT, LevelProposal]):
    """Proposes the level that was decided outside; learns nothing itself."""

    name = "outside"

    class Options(part.Options):
        """What the other learner sees."""

        encoder: Part[Encoder[Any, Any]] = Field(description="the inputs that the other learner is shown")

    level = 0
    """The level of the next decision."""

    @property
    def proposal(self) -> type[Any]:
        return LevelProposal

    def propose(self, moment: Moment[StateT, ActionT]) -> LevelProposal:
        return LevelProposal(level=self.level, ampbit=False)

    def teach(self, lesson: Lesson[StateT, ActionT]) -> None:
        pass


class Held(Amplifier[ActionT]):
    """Raises nothing; a level moves a component as far as under the amplifier that it holds."""

    name = "held"

    class Options(part.Options):
        """Whose amount and change."""

        amplifier: Part[Amplifier[Any]] = Field(description="the amplifier that is not asked")

    @property
    def amount(self) -> float:
        return float(self.options.amplifier.amount)

    @property
    def change(self) -> Change:
        found: Change = self.options.amplifier.change
        return found

    def amplify(self, selected: GradedAction[ActionT], decision_number: int) -> GradedAction[ActionT]:
        return selected


class Ahead(Tutor[Any, Any]):
    """A tutor that can be asked before the engine asks, so that whoever chooses the level sees its action.

    The tutor inside is still called once per decision, in order, and has this one's slot.
    """

    name = "ahead"

    class Options(part.Options):
        """Whom to ask."""

        tutor: Part[Tutor[Any, Any]] = Field(description="the tutor")

    def __init__(self, **options: Any) -> None:
        super().__init__(**options)
        self._tutor: Tutor[Any, Any] = self.options.tutor
        self.action: type[Action] = self._tutor.action
        self._said: Action | None = None
        self._error: Exception | None = None

    def parts(self) -> Iterator[tuple[str, Component]]:
        """Yield nothing: the tutor inside is bound to this one's slot, so that its random numbers stay the same."""
        yield from ()

    def bind(self, binding: Binding) -> None:
        super().bind(binding)
        self._tutor.bind(binding)

    def ask(self, state: Any, instead: Action | None) -> Action:
        """Return a copy of the tutor's action for this state, which `act` will return.

        Args:
            state: The state now.
            instead: What is executed if the tutor fails; without it, the failure is raised at once.
        """
        self._said = self._error = None
        try:
            said = self._tutor.act(state)
            if type(said) is not self.action:
                raise ContractError(
                    f"tutor '{self._tutor.name}' returned {type(said).__name__}; expected {self.action.__name__}."
                )
            self._said = said
            return rebuild(said)
        except Exception as error:
            if instead is None:
                raise
            self._error = error
            return rebuild(instead)

    def act(self, state: Any) -> Any:
        if self._error is not None:
            raise self._error
        return self._said

    @property
    def situation(self) -> str:
        return self._tutor.situation

    def executed(self, action: Any) -> None:
        self._tutor.executed(action)

    def reset(self) -> None:
        self._tutor.reset()

    def close(self) -> None:
        """Close the tutor."""
        self._tutor.close()
