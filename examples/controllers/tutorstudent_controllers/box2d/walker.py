"""Gymnasium's own controller of the bipedal walker as a tutor."""

from __future__ import annotations

from typing import Any

import numpy as np

import tutorstudent as ts
from tutorstudent.sims.gym import GymState
from tutorstudent_controllers.box2d.loading import load_box2d

SITUATIONS = {1: "Stay on one leg", 2: "Put other down", 3: "Push off"}
"""By the number that the heuristic gives its states."""


class Torques(ts.Action):
    """Torques of hips and knees; an amplifier scales all four together."""

    hip_1: float = ts.component(-1.0, 1.0, description="fraction of full torque")
    knee_1: float = ts.component(-1.0, 1.0, description="fraction of full torque")
    hip_2: float = ts.component(-1.0, 1.0, description="fraction of full torque")
    knee_2: float = ts.component(-1.0, 1.0, description="fraction of full torque")

    amplification = {"command": {("hip_1", "knee_1", "hip_2", "knee_2"): "outward"}}


class WalkerHeuristic(ts.Tutor[GymState, Torques]):
    """`BipedalWalkerHeuristics` of gymnasium.envs.box2d.bipedal_walker (MIT), a new one for each trial.

    Its authors call it suboptimal, without a notion of balance. Where the observation is not made of numbers it
    repeats its last command.
    """

    name = "walker-heuristic"
    action = Torques

    def setup(self) -> None:
        self._module = load_box2d("bipedal_walker", f"tutor '{self.name}'")
        self.reset()

    def reset(self) -> None:
        super().reset()
        self._heuristic: Any = self._module.BipedalWalkerHeuristics()
        self._last = Torques(hip_1=0.0, knee_1=0.0, hip_2=0.0, knee_2=0.0)

    def act(self, state: GymState) -> Torques:
        if np.isfinite(state.observation).all():
            hip_1, knee_1, hip_2, knee_2 = map(float, self._heuristic.step_heuristic(state.observation))
            self._last = Torques(hip_1=hip_1, knee_1=knee_1, hip_2=hip_2, knee_2=knee_2)
        return self._last

    @property
    def situation(self) -> str:
        return SITUATIONS[self._heuristic.state]

    @classmethod
    def examples(cls) -> list[GymState]:
        """Return states to try it with: upright and leaning, on either leg."""
        return [_example(angle_rad, leg) for angle_rad in (-0.2, 0.0, 0.2) for leg in (8, 13)]


def _example(angle_rad: float, standing: int) -> GymState:
    observation = np.zeros(24, dtype=np.float32)
    observation[[0, standing]] = angle_rad, 1.0
    observation.setflags(write=False)
    return GymState(observation)
