"""Students wired to the selectors that read their proposals: no error."""

from __future__ import annotations

from typing import Any

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.roles.interfaces import Student, Tutor
from tutorstudent.core.words.proposals import KindProposal, LevelProposal
from tutorstudent.core.words.records import Lesson, Moment
from tutorstudent.plugins.amplifiers import LearningPhase
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.selectors import SameKind
from tutorstudent.plugins.streamlined.modifier import Modifier
from tutorstudent.sims.pioneer.types import DriveAction, PioneerState


class Wall(Tutor[PioneerState, DriveAction]):
    name = "wall"
    action = DriveAction

    def act(self, state: PioneerState) -> DriveAction:
        return DriveAction(kind="stop" if state.stalled else "forward")


class Kinds(Student[PioneerState, DriveAction, KindProposal]):
    name = "kinds"

    @property
    def proposal(self) -> type[Any]:
        return KindProposal

    def propose(self, moment: Moment[PioneerState, DriveAction]) -> KindProposal:
        return KindProposal(kind=moment.tutor_action.kind, level=1, ampbit=True)

    def teach(self, lesson: Lesson[PioneerState, DriveAction]) -> None:
        pass


class Levels(Student[PioneerState, DriveAction, LevelProposal]):
    name = "levels"

    @property
    def proposal(self) -> type[Any]:
        return LevelProposal

    def propose(self, moment: Moment[PioneerState, DriveAction]) -> LevelProposal:
        return LevelProposal(level=1, ampbit=not moment.state.stalled)

    def teach(self, lesson: Lesson[PioneerState, DriveAction]) -> None:
        pass


full = Engine(tutor=Wall(), student=Kinds(), selector=SameKind(), amplifier=LearningPhase(), evaluator=Conditions())
streamlined = Engine(
    tutor=Wall(), student=Levels(), selector=Modifier(), amplifier=LearningPhase(), evaluator=Conditions()
)


def drive(state: PioneerState) -> DriveAction:
    return full.step(state)
