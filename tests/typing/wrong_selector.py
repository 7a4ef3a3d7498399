"""A student of levels wired to a selector of kinds: an error."""

from __future__ import annotations

from typing import Any

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.roles.interfaces import Student, Tutor
from tutorstudent.core.words.proposals import LevelProposal
from tutorstudent.core.words.records import Lesson, Moment
from tutorstudent.plugins.amplifiers import LearningPhase
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.selectors import SameKind
from tutorstudent.sims.pioneer.types import DriveAction, PioneerState


class Wall(Tutor[PioneerState, DriveAction]):
    name = "wall"
    action = DriveAction

    def act(self, state: PioneerState) -> DriveAction:
        return DriveAction(kind="forward")


class Levels(Student[PioneerState, DriveAction, LevelProposal]):
    name = "levels"

    @property
    def proposal(self) -> type[Any]:
        return LevelProposal

    def propose(self, moment: Moment[PioneerState, DriveAction]) -> LevelProposal:
        return LevelProposal(level=1, ampbit=True)

    def teach(self, lesson: Lesson[PioneerState, DriveAction]) -> None:
        pass


mixed = Engine(  # error
    tutor=Wall(),
    student=Levels(),
    selector=SameKind(),
    amplifier=LearningPhase(),
    evaluator=Conditions(),
)
