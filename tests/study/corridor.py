"""A plugin as a third party would write it, for the tests of studies: a corridor, a shuttle, and what it senses."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

import tutorstudent as ts
from tutorstudent.core.running.observers import Entries
from tutorstudent.core.running.runner import make_trial_seed
from tutorstudent.sims.pioneer.types import DriveAction

LENGTHS_M = {"short": 3.0, "long": 6.0}


class Place(NamedTuple):
    x_m: float
    bumped: bool


class Corridor(ts.World[Place, DriveAction]):
    """One dimension with a wall at either end; a step that would end behind a wall is refused."""

    name = "corridor"
    action = DriveAction
    event_names = {
        "collided": "sum",
        "contacts": "sum",
        "distance_m": "sum",
        "time_s": "sum",
        "x_m": "last",
        "y_m": "last",
    }

    class Options(ts.Options):
        scene: str = ts.Field("short", pattern="^(short|long)$", description="which corridor")
        fails_with_seed: int | None = ts.Field(None, description="the seed of a run that breaks down")
        trial: int = ts.Field(40, description="length of a trial, decisions")

    def reset(self, seed: int) -> Place:
        if self.options.fails_with_seed is not None and seed == make_trial_seed(self.options.fails_with_seed, 0):
            raise RuntimeError("the wall fell down")
        self._noise = np.random.default_rng(seed)
        self._place, self._age, self._stuck = Place(1.0 + float(self._noise.random()), False), 0, False
        return self._place

    def step(self, action: DriveAction) -> ts.Step[Place]:
        self._age += 1
        goal = self._place.x_m + action.translation * 0.5 + 0.02 * float(self._noise.standard_normal())
        bumped = not 0.0 <= goal <= LENGTHS_M[self.options.scene]
        fresh, self._stuck = bumped and not self._stuck, bumped
        moved = 0.0 if bumped else goal - self._place.x_m
        self._place = Place(self._place.x_m + moved, bumped)
        events = {
            "collided": float(bumped),
            "contacts": float(fresh),
            "distance_m": abs(moved),
            "time_s": 0.2,
            "x_m": self._place.x_m,
            "y_m": 0.5,
        }
        return ts.Step(self._place, events, done=self._age % self.options.trial == 0)

    def sketch(self) -> ts.Sketch:
        length_m = LENGTHS_M[self.options.scene]
        outline = [(0.0, 0.0), (length_m, 0.0), (length_m, 1.0), (0.0, 1.0)]
        return ts.Sketch([(outline, "grey")], [((length_m, 0.5), 0.1, "red")], [(1.0, 0.5, 0.0, "green")])


class Shuttle(ts.Tutor[Place, DriveAction]):
    """Forward to 2 m or so, backward to 1 m, and so on."""

    name = "shuttle"
    action = DriveAction

    class Options(ts.Options):
        far_m: float = ts.Field(2.0, description="where it turns back")

    def reset(self) -> None:
        self._back = False

    def setup(self) -> None:
        self._back = False

    def act(self, state: Place) -> DriveAction:
        self._back = state.x_m > self.options.far_m or (self._back and state.x_m > 1.0)
        if self._back:
            return DriveAction(kind="backward", translation=-0.2)
        return DriveAction(kind="forward", translation=0.2)

    @property
    def situation(self) -> str:
        return "Returning" if self._back else "Leaving"


class Tollway(Corridor):
    """A corridor with events of its own: one that says all about itself, and one that says how it is summed."""

    name = "tollway"
    event_names = {
        **Corridor.event_names,
        "toll": ts.Measure("toll", "toll paid", unit="EUR", better="less", description="one for every metre begun"),
        "echoes": "sum",
    }

    def step(self, action: DriveAction) -> ts.Step[Place]:
        before = int(self._place.x_m)
        step = super().step(action)
        paid = abs(int(step.state.x_m) - before)
        return step._replace(events={**step.events, "toll": float(paid), "echoes": step.events["contacts"]})


class Effort(ts.Observer):
    """What driving takes."""

    name = "effort"
    measures = (
        ts.Measure("effort_j", "effort", unit="J", better="less", description="work of the motor"),
        ts.Measure("pull_n", "pull", unit="N", summed="max", detail=True),
    )

    def observe(self, turn: Any, step: Any) -> dict[str, float]:
        pull_n = abs(turn.decision.executed.translation)
        return {"effort_j": 0.1 * pull_n, "pull_n": pull_n} if pull_n else {}

    def summary(self) -> dict[str, float]:
        return {"horses": 2.0}


class Turns(Entries):
    """How often it turned back."""

    name = "turns"
    situation = "Returning"
    counted = "turns"


@ts.condition("at-wall")
def at_wall(state: Place) -> bool:
    return state.bumped


@ts.condition("far-out")
def far_out(state: Place) -> bool:
    """Beyond 2.5 m."""
    return state.x_m > 2.5


@ts.encoder("metre", width=4)
def metre(moment: Any) -> list[float]:
    """One bit for each metre."""
    return [float(int(moment.state.x_m) == i) for i in range(4)]


@ts.hookimpl
def tutorstudent_components() -> list[type[ts.Component]]:
    return [Corridor, Tollway, Shuttle, Turns, Effort, at_wall, far_out, metre]
