"""The student that a wrapped controller gets where nobody names another."""

from __future__ import annotations

from typing import Any

from tutorstudent.core.deciding.reach import HIGHEST_USEFUL
from tutorstudent.core.roles import part
from tutorstudent.core.roles.interfaces import Student
from tutorstudent.core.roles.part import Field, Learned
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.proposals import LevelProposal
from tutorstudent.core.words.records import Lesson, Moment, StateT
from tutorstudent.core.words.turn import Turn
from tutorstudent.plugins.budgeted.controller import BudgetController, Pace
from tutorstudent.plugins.learned import take_arrays


class Budgeted(Student[StateT, ActionT, LevelProposal]):
    """Amplify as strongly as a budget of violations allows: rise slowly, fall with every violation of one's own.

    It needs no inputs and no margins, only whether a condition was violated, and it works where the violation comes
    decisions after its cause. In the long run at most `budget` violations per decision are its own, whatever the plant
    does; docs/guide/budgeted.md says under which conditions. Choice: the defaults, see docs/guide/budgeted.md.
    """

    name = "budgeted"

    class Options(part.Options):
        """The budget, and how fast to spend it."""

        budget: float = Field(
            0.003, gt=0, lt=1, description="violations per decision that may be its own, in the long run"
        )
        fall: float = Field(0.1, gt=0, le=100, description="levels that each own violation takes away")
        begin: float = Field(1.0, ge=0, le=8, description="level to begin with; its whole part is asked for")
        climb: float = Field(0.004, ge=0, le=1, description="levels per decision before the first own violation")
        window: int = Field(20, ge=0, description="decisions after an amplified one in which a violation is its own")

    def setup(self) -> None:
        options = self.options
        pace = Pace(options.budget, options.fall, options.climb, options.window)
        self._controller = BudgetController(pace, options.begin)
        self._proposals = [LevelProposal(level=level, ampbit=False) for level in range(HIGHEST_USEFUL + 1)]

    @property
    def proposal(self) -> type[Any]:
        return LevelProposal

    @property
    def own_violations(self) -> int:
        """How many violations were laid to amplification so far."""
        return self._controller.own

    @property
    def level(self) -> float:
        """The level that it stands at, a real number; its whole part is proposed, and 0 where it is negative."""
        return self._controller.level

    def propose(self, moment: Moment[StateT, ActionT]) -> LevelProposal:
        highest = HIGHEST_USEFUL if moment.levels is None else moment.levels.highest
        return self._proposals[self._controller.ask(highest)]

    def teach(self, lesson: Lesson[StateT, ActionT]) -> None:
        self._controller.learn(lesson.executed_level, bool(lesson.outcome.violated))

    def judged(self, turn: Turn[StateT, ActionT]) -> None:
        """Remember that something was amplified also where nothing is taught about it."""
        if turn.lesson is None:
            self._controller.pass_over(turn.decision.resulting.level)

    def reset(self) -> None:
        super().reset()
        self._controller.forget()

    def state_dict(self) -> Learned:
        controller = self._controller
        return {"level": controller.level, "own": controller.own, "decisions": controller.decisions}

    def load_state_dict(self, state: Learned) -> None:
        owner, controller = f"student '{self.name}'", self._controller
        taken = take_arrays(owner, state, {"level": (), "own": (), "decisions": ()})
        for name in ("own", "decisions"):
            if taken[name] < 0 or taken[name] % 1:
                raise ContractError(f"{owner} cannot load '{name}': found {taken[name]:g}; it is a count.")
        controller.level = float(taken["level"])
        controller.own, controller.decisions = int(taken["own"]), int(taken["decisions"])
