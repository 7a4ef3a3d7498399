"""The parts of a pipeline, each honest until the plot says otherwise."""

from __future__ import annotations

from random import Random
from typing import Any, ClassVar, NamedTuple

import numpy as np

from tests.core.oracle.judge import Said, said
from tests.core.oracle.plot import Plot
from tests.core.oracle.shapes import LAWS, Shape
from tutorstudent.core.actions import Action
from tutorstudent.core.component import Field, Options, Part
from tutorstudent.core.interfaces import Student, Tutor
from tutorstudent.core.leaves import Change, Codec, Condition, Encoder
from tutorstudent.core.proposals import KindProposal, LevelProposal
from tutorstudent.core.records import Decision, GradedAction, Lesson, Moment, Outcome
from tutorstudent.plugins.amplifiers import LearningPhase
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.selectors import SameKind
from tutorstudent.plugins.streamlined.modifier import Modifier


class State(NamedTuple):
    """What the sensors say: a number, whether it is too hot, and how far it is from that."""

    number: int
    hot: bool
    margin: float


class Plotted(Options):
    """Whose plot it is."""

    plot: Any = Field(description="the plot")


class MoodyTutor(Tutor[Any, Any]):
    """Say something valid, often of the kind said before; keep a record by value of what was said."""

    name = "moody"

    class Options(Options):
        """What it may say."""

        shape: Any = Field(description="the shape of its actions")
        seed: int = Field(description="seed of its moods")

    @property
    def action(self) -> type[Action]:  # type: ignore[override]
        shape: Shape = self.options.shape
        return shape.action

    def setup(self) -> None:
        self._random = Random(self.options.seed)
        self.record: list[Said] = []
        self._last: Any = None

    def act(self, state: Any) -> Any:
        shape, before = self.options.shape, self._last
        dice = self._random.random()
        if before is not None and dice < 0.25:
            action = before  # the very same object: controllers cache their commands
        else:
            action = shape.draw(self._random, before.kind if before is not None and dice < 0.85 else None)
        self._last = action
        self.record.append(said(shape, action))
        return action


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


class PlottedSameKind(SameKind[Any]):
    """The shipped selector with a plot."""

    name = "plotted-same-kind"
    Options = Plotted

    def select(self, tutor_action: Any, proposal: Any) -> Any:
        honest = super().select
        return self.options.plot.twist("selector", lambda: honest(tutor_action, proposal), [tutor_action])


class PlottedModifier(Modifier[Any]):
    """The shipped modifier with a plot."""

    name = "plotted-modifier"
    Options = Plotted

    def select(self, tutor_action: Any, proposal: Any) -> Any:
        honest = super().select
        return self.options.plot.twist("selector", lambda: honest(tutor_action, proposal), [tutor_action])


class PlottedChange(Change):
    """A lawful change with a plot."""

    name = "plotted"

    class Options(Plotted):
        """Which law."""

        law: str = Field(description="additive or multiplicative")

    def fraction(self, amplification: float, magnitude: float) -> Any:
        honest = LAWS[self.options.law](amplification, magnitude)
        return self.options.plot.twist("change", lambda: honest)


class PlottedAmplifier(LearningPhase[Any]):
    """The shipped amplifier with a plot."""

    name = "plotted"

    class Options(LearningPhase.Options, Plotted):
        """The shipped options and the plot."""

    def amplify(self, selected: GradedAction[Any], decision_number: int) -> Any:
        honest = super().amplify
        return self.options.plot.twist("amplifier", lambda: honest(selected, decision_number), [selected.action])


class PlottedEvaluator(Conditions[Any, Any]):
    """The shipped evaluator with a plot."""

    name = "plotted"
    Options = Plotted

    def evaluate(self, decision: Decision[Any, Any], outcome: Outcome[Any]) -> Any:
        honest = super().evaluate
        actions = [decision.moment.tutor_action, decision.executed, decision.selected.action]
        return self.options.plot.twist("evaluator", lambda: honest(decision, outcome), actions)


class Flag(Condition[Any]):
    """Too hot."""

    name = "flag"
    Options = Plotted

    def violated(self, state: State) -> Any:
        return self.options.plot.twist("condition", lambda: state.hot)

    def margins(self, state: State) -> Any:
        return self.options.plot.twist("margins", lambda: (state.margin,))


def parts(plot: Plot, shape: Shape, seed: int, law: str, amount: float, learning_phase: int, kinds: bool) -> dict:
    """Return a whole pipeline of plotted parts, as the engine takes them."""
    codec = PlainKinds(plot=plot) if kinds else PlainLevels(plot=plot)
    return {
        "tutor": MoodyTutor(shape=shape, seed=seed),
        "student": PlottedStudent(plot=plot, encoder=Numbers(plot=plot), codec=codec),
        "selector": PlottedSameKind(plot=plot) if kinds else PlottedModifier(plot=plot),
        "amplifier": PlottedAmplifier(
            plot=plot, decisions=learning_phase, amount=amount, change=PlottedChange(plot=plot, law=law)
        ),
        "evaluator": PlottedEvaluator(plot=plot),
        "conditions": [Flag(plot=plot)],
        "seed": seed,
    }
