"""A student with encoder and codec, each honest until the plot says otherwise."""

from __future__ import annotations

from typing import Any, ClassVar, NamedTuple

import numpy as np

from tutorstudent.core.roles.interfaces import Student
from tutorstudent.core.roles.leaves import Codec, Encoder
from tutorstudent.core.roles.part import Field, Options
from tutorstudent.core.roles.part_options import Part
from tutorstudent.core.words.proposals import KindProposal, LevelProposal
from tutorstudent.core.words.records import GradedAction, Lesson, Moment


class Plotted(Options):
    """Whose plot it is."""

    plot: Any = Field(description="the plot")


class Numbers(Encoder[Any, Any]):
    """The number of the state, in a buffer that is reused."""

    name = "numbers"
    Options = Plotted

    @property
    def width(self) -> int:
        return 2

    def setup(self) -> None:
        self._buffer = np.zeros(2)

    def encode(self, moment: Moment[Any, Any]) -> Any:
        self._buffer[:] = moment.number, 1.0
        return self.options.plot.twist("encoder", lambda: self._buffer, [moment.tutor_action])


class _Plain(Codec[Any]):
    """Three numbers: the kind's place, the level, the ampbit."""

    Options = Plotted

    @property
    def width(self) -> int:
        return 3

    def encode(self, target: GradedAction[Any]) -> Any:
        honest = np.array([0.0, target.level, target.ampbit])
        return self.options.plot.twist("encode", lambda: honest, [target.action])

    def decode(self, outputs: Any) -> Any:
        return self.options.plot.twist("decode", lambda: self._proposal(outputs))

    def _proposal(self, outputs: Any) -> Any:
        return LevelProposal(level=int(outputs[1]), ampbit=bool(outputs[2]))


class PlainLevels(_Plain):
    """Read level and ampbit."""

    name = "plain-levels"
    proposal: ClassVar[type[Any]] = LevelProposal


class PlainKinds(_Plain):
    """Read kind, level and ampbit."""

    name = "plain-kinds"
    proposal: ClassVar[type[Any]] = KindProposal

    def _proposal(self, outputs: Any) -> Any:
        kinds = (*self.action_class.vocabulary.kinds, None)
        return KindProposal(kind=kinds[int(outputs[0])], level=int(outputs[1]), ampbit=bool(outputs[2]))


class Heard(NamedTuple):
    """A lesson, by value."""

    number: int
    state: Any
    tutor: dict[str, object]
    level: int
    ampbit: bool
    executed_level: int
    executed: dict[str, object]


class PlottedStudent(Student[Any, Any, Any]):
    """Propose at random, mostly the tutor's kind; remember by value what is taught."""

    name = "plotted"

    class Options(Plotted):
        """Its parts."""

        encoder: Part[Encoder[Any, Any]] = Field(description="what it sees")
        codec: Part[Codec[Any]] = Field(description="what its outputs mean")

    @property
    def proposal(self) -> type[Any]:
        found: type[Any] = self.options.codec.proposal
        return found

    def setup(self) -> None:
        self.heard: list[Heard] = []

    def propose(self, moment: Moment[Any, Any]) -> Any:
        def honest() -> Any:
            return self.options.codec.decode(self._outputs(self.options.encoder.encode(moment), moment))

        made = self.options.plot.twist("student", honest, [moment.tutor_action])
        if isinstance(made, KindProposal):
            return self.options.plot.twist("kinds", lambda: made, [moment.tutor_action])
        return made

    def _outputs(self, inputs: Any, moment: Moment[Any, Any]) -> Any:
        kinds = self.action_class.vocabulary.kinds
        same = self.rng.random() < 0.8
        place = kinds.index(moment.tutor_action.kind) if same else self.rng.integers(len(kinds), endpoint=True)
        level = self.rng.integers(6 if self.rng.random() < 0.85 else 40)
        return np.array([place, level, self.rng.integers(2)]) + 0 * inputs[0]

    def teach(self, lesson: Lesson[Any, Any]) -> None:
        moment, target = lesson.moment, lesson.target
        self.heard.append(
            Heard(
                moment.number,
                moment.state,
                dict(moment.tutor_action.__dict__),
                target.level,
                target.ampbit,
                lesson.executed_level,
                dict(lesson.executed.__dict__),
            )
        )
        self.options.codec.encode(target)
        self.options.plot.twist("learner", lambda: None, [moment.tutor_action, lesson.executed, target.action])
