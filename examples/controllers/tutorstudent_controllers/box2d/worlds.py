"""Two of Gymnasium's Box2D environments, with what happened in the environment's own terms."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import tutorstudent as ts
from tutorstudent.sims.gym import GymnasiumWorld, GymState
from tutorstudent_controllers.box2d.lander import Thrust
from tutorstudent_controllers.box2d.loading import load_box2d
from tutorstudent_controllers.box2d.walker import Torques

LOST = -100.0
"""Reward of the last step of a trial that ended badly, in both environments."""
SPEED_SCALE = 6.0
"""The walker observes 0.12 of its forward speed, and 50 decisions are a second: observation / 6 is the way, m."""


class WalkerOptions(GymnasiumWorld.Options):
    """Which environment."""

    id: str = ts.Field("BipedalWalker-v3", min_length=1, description="registered id")


class Walker(GymnasiumWorld):
    """Walk to the right over gentle ground until the end of it, until 1600 decisions are over, or until a fall."""

    name = "bipedal-walker"
    action: type[ts.Action] = Torques
    Options = WalkerOptions

    def setup(self) -> None:
        load_box2d("bipedal_walker", f"world '{self.name}'")
        super().setup()

    @property
    def event_names(self) -> Mapping[str, Any]:
        return {**super().event_names, "falls": "sum", "arrivals": "sum", "distance_m": "sum"}

    def step(self, action: ts.Action) -> ts.Step[GymState]:
        done = super().step(action)
        state = done.state
        ended = {"falls": _is_lost(state), "arrivals": state.terminated and not _is_lost(state)}
        way_m = float(state.observation[2]) / SPEED_SCALE
        return done._replace(events={**done.events, **_counts(ended), "distance_m": way_m})


class LanderOptions(GymnasiumWorld.Options):
    """Which environment, and with which engines."""

    id: str = ts.Field("LunarLander-v3", min_length=1, description="registered id")
    kwargs: dict[str, Any] = ts.Field({"continuous": True}, description="arguments of the environment, plain values")


class Lander(GymnasiumWorld):
    """Come down and stand still. A trial ends with a crash, with flying off, or with the lander at rest."""

    name = "lunar-lander"
    action: type[ts.Action] = Thrust
    Options = LanderOptions

    def setup(self) -> None:
        load_box2d("lunar_lander", f"world '{self.name}'")
        super().setup()

    @property
    def event_names(self) -> Mapping[str, Any]:
        return {**super().event_names, "crashes": "sum", "landings": "sum"}

    def step(self, action: ts.Action) -> ts.Step[GymState]:
        done = super().step(action)
        state = done.state
        ended = {"crashes": _is_lost(state), "landings": state.terminated and not _is_lost(state)}
        return done._replace(events={**done.events, **_counts(ended)})


def _is_lost(state: GymState) -> bool:
    return state.terminated and state.reward <= LOST


def _counts(happened: Mapping[str, bool]) -> dict[str, float]:
    return {name: float(value) for name, value in happened.items()}
