"""A tutor of one robot with a condition about another's state: an error."""

from __future__ import annotations

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.roles.leaves import Condition
from tutorstudent.plugins.amplifiers import Never
from tutorstudent.plugins.controls import Silent
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.streamlined.modifier import Modifier
from tutorstudent.sims.pioneer.types import DriveAction, PioneerState


class Wall(Tutor[PioneerState, DriveAction]):
    name = "wall"
    action = DriveAction

    def act(self, state: PioneerState) -> DriveAction:
        return DriveAction(kind="forward")


class TooHot(Condition[float]):
    name = "too-hot"

    def violated(self, state: float) -> bool:
        return state > 80


silent: Silent[PioneerState, DriveAction] = Silent()
too_hot: Condition[float] = TooHot()
mixed = Engine(  # error
    tutor=Wall(),
    student=silent,
    selector=Modifier(),
    amplifier=Never(),
    evaluator=Conditions(),
    conditions=[too_hot],
    limits=Limits(cap=0.5),
)
wrong: str = mixed.step  # error
