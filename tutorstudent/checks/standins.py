"""The plainest parts of an engine, for observers to watch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.roles.interfaces import ActionSelector, Amplifier, Evaluator, Student, Tutor
from tutorstudent.core.roles.leaves import Change, Condition
from tutorstudent.core.roles.world import Step, World
from tutorstudent.core.words.measures import Summary
from tutorstudent.core.words.proposals import LevelProposal
from tutorstudent.core.words.records import Decision, GradedAction, Lesson, Moment, Outcome
from tutorstudent.core.words.turn import Turn


class Repeater(Tutor[float, Any]):
    """Says the given actions in turn."""

    name = "repeater"

    def __init__(self, actions: Sequence[Any]) -> None:
        super().__init__()
        self.action = type(actions[0])
        self._actions = actions

    def act(self, state: float) -> Any:
        return self._actions[int(state) % len(self._actions)]

    @property
    def situation(self) -> str:
        return "repeating"


class Asker(Student[float, Any, LevelProposal]):
    """Always asks for level 1."""

    name = "asker"

    @property
    def proposal(self) -> type[Any]:
        return LevelProposal

    def propose(self, moment: Moment[float, Any]) -> LevelProposal:
        return LevelProposal(level=1, ampbit=True)

    def teach(self, lesson: Lesson[float, Any]) -> None:
        pass


class Taker(ActionSelector[Any, LevelProposal]):
    """Takes every level."""

    name = "taker"
    proposal = LevelProposal

    def select(self, tutor_action: Any, proposal: LevelProposal) -> GradedAction[Any]:
        return GradedAction(tutor_action, proposal.level, proposal.ampbit)


class Straight(Change):
    """Moves by the amplification."""

    name = "straight"

    def fraction(self, amplification: float, magnitude: float) -> float:
        return amplification


class Raiser(Amplifier[Any]):
    """Raises every level by one."""

    name = "raiser"
    amount = 0.1
    change = Straight()

    def amplify(self, selected: GradedAction[Any], decision_number: int) -> GradedAction[Any]:
        return selected._replace(level=selected.level + 1)


class Repeating(Evaluator[float, Any]):
    """Teaches what was done."""

    name = "repeating"

    def evaluate(self, decision: Decision[float, Any], outcome: Outcome[float]) -> Lesson[float, Any]:
        return Lesson(decision.moment, decision.resulting, decision.resulting.level, decision.executed, outcome)


class Fifth(Condition[float]):
    """Is violated in every fifth state."""

    name = "fifth"

    def violated(self, state: float) -> bool:
        return state % 5 == 0


class Clock(World[float, Any]):
    """Counts decisions."""

    name = "clock"

    def __init__(self, action: type[Any]) -> None:
        super().__init__()
        self.action = action

    @property
    def event_names(self) -> Mapping[str, Summary]:
        return {"collided": "sum", "time_s": "last"}

    def reset(self, seed: int) -> float:
        self._time = 0.0
        return self._time

    def step(self, action: Any) -> Step[float]:
        self._time += 1
        return Step(self._time, {"collided": float(self._time % 5 == 0), "time_s": self._time}, self._time == 20)


def make_engine(actions: Sequence[Any]) -> tuple[Engine[Any, Any, Any], Clock]:
    """Return an engine whose tutor says these actions, and a world that executes them."""
    engine: Engine[Any, Any, Any] = Engine(
        tutor=Repeater(actions),
        student=Asker(),
        selector=Taker(),
        amplifier=Raiser(),
        evaluator=Repeating(),
        conditions=[Fifth()],
    )
    return engine, Clock(type(actions[0]))


def play(actions: Sequence[Any], decisions: int = 25) -> Iterator[tuple[Turn[Any, Any], Step[Any]]]:
    """Yield what an observer sees of a short run."""
    engine, clock = make_engine(actions)
    state = clock.reset(0)
    for _ in range(decisions):
        step = clock.step(engine.propagate(state))
        turn = engine.evaluate(step.state)
        if turn is not None:
            yield turn, step
        state = clock.reset(0) if step.done else step.state
