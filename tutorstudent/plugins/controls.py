"""What comparisons compare with: students that learn nothing, and an evaluator that is told nothing.

The students propose levels only, so a control replaces student, selector (``modifier``) and amplifier (``never``)
together; ``blind`` replaces the evaluator only.
"""

from __future__ import annotations

from typing import Any

from tutorstudent.core.deciding.judging import NO_MARGINS
from tutorstudent.core.roles import part
from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.interfaces import Evaluator, Student
from tutorstudent.core.roles.leaves import Encoder
from tutorstudent.core.roles.part import Component, Field
from tutorstudent.core.roles.part_options import Part
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.proposals import LevelProposal
from tutorstudent.core.words.records import Decision, Lesson, Moment, Outcome, StateT
from tutorstudent.plugins.evaluators import Conditions


class Unteachable(Student[StateT, ActionT, LevelProposal]):
    """A student that proposes levels and learns nothing."""

    learns = False

    @property
    def proposal(self) -> type[Any]:
        return LevelProposal

    def teach(self, lesson: Lesson[StateT, ActionT]) -> None:
        pass


class Silent(Unteachable[StateT, ActionT]):
    """Never asks for anything: the tutor alone."""

    name = "silent"

    def setup(self) -> None:
        self._nothing = LevelProposal(level=0, ampbit=True)

    def propose(self, moment: Moment[StateT, ActionT]) -> LevelProposal:
        return self._nothing


class Constant(Unteachable[StateT, ActionT]):
    """Always asks for the same level."""

    name = "constant"

    class Options(part.Options):
        """Which level."""

        level: int = Field(default=4, ge=0, description="the level, the same in every decision")

    def setup(self) -> None:
        self._proposal = LevelProposal(level=self.options.level, ampbit=False)

    def propose(self, moment: Moment[StateT, ActionT]) -> LevelProposal:
        return self._proposal


class Random(Unteachable[StateT, ActionT]):
    """Asks for a level drawn anew in every decision."""

    name = "random"

    class Options(part.Options):
        """From which levels."""

        max_level: int = Field(default=8, ge=0, description="highest level; all from 0 on are equally likely")

    def propose(self, moment: Moment[StateT, ActionT]) -> LevelProposal:
        return LevelProposal(level=self.rng.integers(self.options.max_level, endpoint=True), ampbit=False)


class Ramp(Unteachable[StateT, ActionT]):
    """Asks for one level more while the tutor's kind and the encoded inputs stay the same, else begins at 1 again."""

    name = "ramp"

    class Options(part.Options):
        """What has to stay the same, and where the ramp ends."""

        encoder: Part[Encoder[Any, Any]] | None = Field(default=None, description="inputs; none: the kind only")
        max_level: int = Field(default=8, ge=0, description="highest level")

    def setup(self) -> None:
        self.reset()

    def reset(self) -> None:
        super().reset()
        self._key: tuple[str, bytes] | None = None
        self._level = 0

    def propose(self, moment: Moment[StateT, ActionT]) -> LevelProposal:
        inputs = self.options.encoder.encode(moment).tobytes() if self.options.encoder else b""
        key = (moment.tutor_action.kind, inputs)
        self._level = (
            min(self._level + 1, self.options.max_level) if key == self._key else min(1, self.options.max_level)
        )
        self._key = key
        return LevelProposal(level=self._level, ampbit=False)


class Blind(Evaluator[StateT, ActionT]):
    """Teach as another evaluator would if no condition were ever violated. What is recorded stays true."""

    name = "blind"

    class Options(part.Options):
        """Whose eyes are closed."""

        evaluator: Part[Evaluator[Any, Any]] = Field(default_factory=Conditions, description="the evaluator to blind")
        margins: bool = Field(default=False, description="whether it still sees margins, so that only violations go")

    def evaluate(self, decision: Decision[StateT, ActionT], outcome: Outcome[StateT]) -> Lesson[StateT, ActionT] | None:
        unseen = outcome._replace(violated=())
        if not self.options.margins:
            unseen = unseen._replace(margins_before=None, margins=NO_MARGINS)
        lesson: Lesson[StateT, ActionT] | None = self.options.evaluator.evaluate(decision, unseen)
        return lesson


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the shipped controls."""
    return [Silent, Constant, Random, Ramp, Blind]
