"""A third party's plugin that has nothing to do with robots: a kettle, its controller, and a part in every slot."""

from __future__ import annotations

from typing import Any

import numpy as np

import tutorstudent as ts
from tutorstudent.core.running.observers import Entries

Heat = ts.scalar(0.0, 1.0)


class Kettle(ts.World[float, Any]):
    """Water that cools by itself; its state is its temperature in degrees Celsius."""

    name = "kettle"
    action = Heat
    event_names = {"boiled": "sum", "energy": "sum"}

    def reset(self, seed: int) -> float:
        self._noise = np.random.default_rng(seed)
        self._celsius = 20.0 + 5.0 * float(self._noise.random())
        return self._celsius

    def step(self, action: Any) -> ts.Step[float]:
        self._celsius += 4.0 * action.value - 0.01 * (self._celsius - 20.0) + 0.1 * float(self._noise.standard_normal())
        boiled = float(self._celsius > 85.0)
        return ts.Step(self._celsius, {"boiled": boiled, "energy": action.value})


class Keeper(ts.Tutor[float, Any]):
    """Heats in proportion to what is missing to 80 degrees."""

    name = "keeper"
    action = Heat

    def act(self, state: float) -> Any:
        self._warm = state > 70.0
        return Heat(value=min(1.0, max(0.0, (80.0 - state) / 60.0)))

    @property
    def situation(self) -> str:
        return "Warm" if self._warm else "Cold"


class Eager(ts.Student[float, Any, ts.LevelProposal]):
    """Proposes levels, has no encoder, and learns how often it was told off."""

    name = "eager"

    @property
    def proposal(self) -> type[Any]:
        return ts.LevelProposal

    def setup(self) -> None:
        self._scoldings = 0

    def propose(self, moment: Any) -> ts.LevelProposal:
        return ts.LevelProposal(level=max(0, 6 - self._scoldings), ampbit=True)

    def teach(self, lesson: Any) -> None:
        self._scoldings += not lesson.target.ampbit


class Timid(ts.ActionSelector[Any, ts.LevelProposal]):
    """Selects half of what was proposed."""

    name = "timid"
    proposal = ts.LevelProposal

    def select(self, tutor_action: Any, proposal: ts.LevelProposal) -> ts.GradedAction[Any]:
        return ts.GradedAction(tutor_action, proposal.level // 2, proposal.ampbit)


class Jump(ts.Amplifier[Any]):
    """Raises by two levels at once."""

    name = "jump"

    class Options(ts.Options):
        """How far a level moves."""

        step: float = ts.Field(0.05, gt=0, description="amplification per level")
        change: ts.Part[ts.Change] = ts.Field(..., description="how it becomes a distance")

    @property
    def amount(self) -> float:
        return float(self.options.step)

    @property
    def change(self) -> ts.Change:
        found: ts.Change = self.options.change
        return found

    def amplify(self, selected: ts.GradedAction[Any], decision_number: int) -> ts.GradedAction[Any]:
        return selected._replace(level=selected.level + 2)


class Strict(ts.Evaluator[float, Any]):
    """Teaches violations only."""

    name = "strict"

    def evaluate(self, decision: Any, outcome: Any) -> ts.Lesson[float, Any] | None:
        if not outcome.violated:
            return None
        target = ts.GradedAction(decision.moment.tutor_action, 0, False)
        return ts.Lesson(decision.moment, target, decision.resulting.level, decision.executed, outcome)


@ts.change("rooted")
def rooted(amplification: float, magnitude: float) -> float:
    """Less for large actions."""
    return amplification * (1.0 - magnitude)


@ts.condition("too-hot")
def too_hot(state: float) -> bool:
    return state > 85.0


class Warmed(Entries):
    """How often it became warm."""

    name = "warmed"
    situation = "Warm"
    counted = "warmed"


@ts.hookimpl
def tutorstudent_components() -> list[type[ts.Component]]:
    return [Kettle, Keeper, Eager, Timid, Jump, Strict, rooted, too_hot, Warmed]
