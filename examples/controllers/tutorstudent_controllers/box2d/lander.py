"""Gymnasium's own controller of the lunar lander as a tutor."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np

import tutorstudent as ts
from tutorstudent.sims.gym import GymState
from tutorstudent_controllers.box2d.loading import load_box2d

CONTINUOUS = SimpleNamespace(unwrapped=SimpleNamespace(continuous=True))
"""All that the heuristic asks of its environment."""
LANDED = "Landed"
FLYING = "Flying"


class Thrust(ts.Action):
    """Main and side engine; an amplifier scales both together, as one gain of the controller."""

    main: float = ts.component(-1.0, 1.0, neutral=-1.0, description="off below 0, then half to full power")
    side: float = ts.component(-1.0, 1.0, description="off within 0.5 of 0, then half to full power to either side")

    amplification = {"command": {("main", "side"): "outward"}}


class LanderHeuristic(ts.Tutor[GymState, Thrust]):
    """`heuristic` of gymnasium.envs.box2d.lunar_lander (MIT), with continuous engines.

    Where the observation is not made of numbers it repeats its last command.
    """

    name = "lander-heuristic"
    action = Thrust

    def setup(self) -> None:
        self._module = load_box2d("lunar_lander", f"tutor '{self.name}'")
        self.reset()

    def reset(self) -> None:
        super().reset()
        self._last = Thrust(main=-1.0, side=0.0)
        self._situation = FLYING

    def act(self, state: GymState) -> Thrust:
        seen = state.observation
        if np.isfinite(seen).all():
            main, side = self._module.heuristic(CONTINUOUS, seen)
            self._last = Thrust(main=float(main), side=float(side))
            self._situation = LANDED if seen[6] or seen[7] else FLYING
        return self._last

    @property
    def situation(self) -> str:
        return self._situation

    @classmethod
    def examples(cls) -> list[GymState]:
        """Return states to try it with: high and low, upright and tilted, falling and standing."""
        return [
            _example(height, angle_rad, legs)
            for height in (0.05, 0.5, 1.4)
            for angle_rad in (-0.4, 0.0, 0.4)
            for legs in (0.0, 1.0)
        ]


def _example(height: float, angle_rad: float, legs: float) -> GymState:
    observation = np.array([0.1, height, 0.1, -0.5, angle_rad, 0.0, legs, legs], dtype=np.float32)
    observation.setflags(write=False)
    return GymState(observation)
