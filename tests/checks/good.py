"""Small parts that keep every promise; the broken ones of the tests differ from them in one thing each."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, Literal, NamedTuple

import numpy as np

import tutorstudent as ts
from tutorstudent.core.words.actions import AmplificationMap


class Heat(ts.Action):
    kind: Literal["off", "heat"]
    power: float = ts.component(0.0, 1.0, default=0.0)
    amplification: ClassVar[AmplificationMap] = {"heat": {"power": "+"}}


class Room(NamedTuple):
    celsius: float
    walls: Any
    door_open: bool = False

    @classmethod
    def examples(cls) -> list[Room]:
        return [room(celsius) for celsius in (-5.0, 10.0, 19.0, 19.5, 21.0, 35.0)]


def room(celsius: float) -> Room:
    walls = np.full(3, celsius - 1)
    return Room(celsius, walls)


class Stove(ts.Tutor[Room, Heat]):
    """Heats below a temperature."""

    name = "stove"
    action = Heat

    class Options(ts.Options):
        goal_celsius: float = ts.Field(20.0, description="the temperature to reach, degrees Celsius")

    def setup(self) -> None:
        self.asked = 0

    def reset(self) -> None:
        super().reset()
        self.asked = 0

    def act(self, state: Room) -> Heat:
        self.asked += 1
        if state.celsius < self.options.goal_celsius:
            return Heat(kind="heat", power=0.3 + 0.1 * float(self.rng.random()))
        return Heat(kind="off")


class Memory(ts.Student[Room, Heat, ts.LevelProposal]):
    """Remembers the last lesson for each degree."""

    name = "memory"

    @property
    def proposal(self) -> type[Any]:
        return ts.LevelProposal

    def setup(self) -> None:
        self.levels = np.zeros(100, dtype=np.int64)

    def place(self, moment: ts.Moment[Room, Heat]) -> int:
        return int(np.clip(moment.state.celsius, 0, 99))

    def propose(self, moment: ts.Moment[Room, Heat]) -> ts.LevelProposal:
        return ts.LevelProposal(level=self.levels[self.place(moment)], ampbit=True)

    def teach(self, lesson: ts.Lesson[Room, Heat]) -> None:
        self.levels[self.place(lesson.moment)] = lesson.target.level

    def state_dict(self) -> Mapping[str, Any]:
        return {"levels": self.levels.copy()}

    def load_state_dict(self, state: Mapping[str, Any]) -> None:
        if set(state) != {"levels"}:
            raise ts.ContractError(f"memory takes 'levels', not {sorted(state)}.")
        self.levels = np.array(state["levels"])


class Taker(ts.ActionSelector[Heat, ts.LevelProposal]):
    """Takes every level."""

    name = "taker"
    proposal = ts.LevelProposal

    def select(self, tutor_action: Heat, proposal: ts.LevelProposal) -> ts.GradedAction[Heat]:
        return ts.GradedAction(tutor_action, proposal.level, proposal.ampbit)


class Linear(ts.Change):
    """Moves by the amplification."""

    name = "linear"

    def fraction(self, amplification: float, magnitude: float) -> float:
        return amplification


class Raiser(ts.Amplifier[Heat]):
    """Raises every level by one."""

    name = "raiser"
    amount = 0.1
    change = Linear()

    def amplify(self, selected: ts.GradedAction[Heat], decision_number: int) -> ts.GradedAction[Heat]:
        return selected._replace(level=selected.level + 1)


class Judge(ts.Evaluator[Room, Heat]):
    """Teaches what was done."""

    name = "judge"

    def evaluate(self, decision: ts.Decision[Room, Heat], outcome: ts.Outcome[Room]) -> ts.Lesson[Room, Heat] | None:
        level = decision.resulting.level
        return ts.Lesson(decision.moment, decision.resulting, level, decision.executed, outcome)


class Degrees(ts.Encoder[Room, Heat]):
    """Bits for temperatures."""

    name = "degrees"
    width = 3

    def encode(self, moment: ts.Moment[Room, Heat]) -> Any:
        return np.array([moment.state.celsius > limit for limit in (0, 10, 20)], dtype=np.float64)


class Bits(ts.Codec[ts.LevelProposal]):
    """Two bits of level and the ampbit."""

    name = "bits"
    proposal = ts.LevelProposal
    width = 3

    def encode(self, target: ts.GradedAction[Any]) -> Any:
        level = min(target.level, 3)
        return np.array([level >> 1, level & 1, target.ampbit], dtype=np.float64)

    def decode(self, outputs: Any) -> ts.LevelProposal:
        high, low, bit = (bool(value > 0.5) for value in outputs)
        return ts.LevelProposal(level=2 * high + low, ampbit=bit)


class TooHot(ts.Condition[Room]):
    """Hotter than 30 degrees."""

    name = "too-hot"

    def violated(self, state: Room) -> bool:
        return state.celsius > 30

    def margins(self, state: Room) -> list[float]:
        return [30 - state.celsius]


class House(ts.World[Room, Heat]):
    """A room that cools down."""

    name = "house"
    action = Heat
    event_names = {"heated": "sum"}

    def reset(self, seed: int) -> Room:
        self.noise = np.random.default_rng(seed)
        self.celsius = 15.0
        return self.sense()

    def sense(self) -> Room:
        walls = np.full(3, self.celsius)
        walls.setflags(write=False)
        return Room(self.celsius, walls)

    def step(self, action: Heat) -> ts.Step[Room]:
        self.celsius += action.power - 0.2 + 0.1 * float(self.noise.random())
        return ts.Step(self.sense(), {"heated": action.power})

    def sketch(self) -> ts.Sketch:
        return ts.Sketch(discs=[((0.0, 0.0), 1.0, "red")])


class Counter(ts.Observer):
    """Counts decisions."""

    name = "counter"

    def setup(self) -> None:
        self.count = 0

    def observe(self, turn: Any, step: Any) -> None:
        self.count += 1

    def summary(self) -> Mapping[str, float]:
        return {"count": float(self.count)}


GOOD: tuple[type[ts.Component], ...] = (
    Stove,
    Memory,
    Taker,
    Linear,
    Raiser,
    Judge,
    Degrees,
    Bits,
    TooHot,
    House,
    Counter,
)
