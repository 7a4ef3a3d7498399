"""The parts of a pipeline, each honest until the plot says otherwise."""

from __future__ import annotations

from random import Random
from typing import Any, NamedTuple

from tests.core.oracle.judge import Said, said
from tests.core.oracle.learner import Numbers, PlainKinds, PlainLevels, Plotted, PlottedStudent
from tests.core.oracle.plot import Plot
from tests.core.oracle.shapes import LAWS, Shape
from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.roles.leaves import Change, Condition
from tutorstudent.core.roles.part import Field, Options
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.records import Decision, GradedAction, Outcome
from tutorstudent.plugins.amplifiers import LearningPhase
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.selectors import SameKind
from tutorstudent.plugins.streamlined.modifier import Modifier


class State(NamedTuple):
    """What the sensors say: a number, whether it is too hot, and how far it is from that."""

    number: int
    hot: bool
    margin: float


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
