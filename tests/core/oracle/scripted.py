"""Parts that say what a script says, and remember what they were told."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.roles.interfaces import Student, Tutor
from tutorstudent.core.roles.leaves import Condition
from tutorstudent.core.roles.part import Field, Options
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.proposals import KindProposal, LevelProposal
from tutorstudent.core.words.records import Lesson, Moment
from tutorstudent.plugins.amplifiers import Never
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.streamlined.modifier import Modifier
from tutorstudent.sims.pioneer.types import DriveAction


class ScriptedTutor(Tutor[Any, Any]):
    """Act by a function of the state; count the calls."""

    name = "scripted"
    action: type[Action] = DriveAction

    class Options(Options):
        """The script."""

        act: Callable[[Any], Any] = Field(description="the action for a state")

    def setup(self) -> None:
        self.asked: list[Any] = []

    def act(self, state: Any) -> Any:
        self.asked.append(state)
        return self.options.act(state)


class ListeningTutor(ScriptedTutor):
    """Remember what was executed."""

    name = "listening"

    def setup(self) -> None:
        super().setup()
        self.heard: list[Any] = []

    def executed(self, action: Any) -> None:
        self.heard.append(action)


class _ScriptedStudent(Student[Any, Any, Any]):
    """Propose by a function of the moment; remember the lessons."""

    says: type[Any]

    class Options(Options):
        """The script."""

        propose: Callable[[Any], Any] = Field(description="the proposal at a moment")

    @property
    def proposal(self) -> type[Any]:
        return self.says

    def setup(self) -> None:
        self.lessons: list[Lesson[Any, Any]] = []

    def propose(self, moment: Moment[Any, Any]) -> Any:
        return self.options.propose(moment)

    def teach(self, lesson: Lesson[Any, Any]) -> None:
        self.lessons.append(lesson)


class KindStudent(_ScriptedStudent):
    """A scripted student of the full algorithm."""

    name = "scripted-kind"
    says = KindProposal


class LevelStudent(_ScriptedStudent):
    """A scripted student of the streamlined algorithm."""

    name = "scripted-level"
    says = LevelProposal


class Says(Condition[Any]):
    """Violated by a function of the state."""

    name = "says"

    class Options(Options):
        """The script."""

        violated: Callable[[Any], Any] = Field(description="what it answers for a state")
        label: str = Field("says", description="its name")

    @property
    def label(self) -> str:
        return str(self.options.label)

    def violated(self, state: Any) -> Any:
        return self.options.violated(state)


class Measures(Says):
    """A condition that declares margins too."""

    name = "measures"

    class Options(Says.Options):
        """The script."""

        margins: Callable[[Any], Any] = Field(description="its margins for a state")

    def margins(self, state: Any) -> Any:
        return self.options.margins(state)


def level(number: int, ampbit: bool = False) -> LevelStudent:
    """Return a student that always proposes the same."""
    said = LevelProposal(level=number, ampbit=ampbit)
    return LevelStudent(propose=lambda moment: said)


def engine(act: Callable[[Any], Any], student: LevelStudent, **others: Any) -> Engine[Any, Any, Any]:
    """Return an engine of the streamlined algorithm that raises nothing; `others` replace its parts."""
    parts: dict[str, Any] = {
        "tutor": ScriptedTutor(act=act),
        "student": student,
        "selector": Modifier(),
        "amplifier": Never(),
        "evaluator": Conditions(),
    }
    return Engine(**{**parts, **others})


def forward(translation: float, rotation: float = 0.0) -> Callable[[Any], DriveAction]:
    """Return a tutor's script that always says the same."""
    action = DriveAction(kind="forward", translation=translation, rotation=rotation)
    return lambda state: action
