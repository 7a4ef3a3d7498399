"""A tiny environment with everything that the tests need to see, and a pipeline that drives it."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from gymnasium.spaces import Box, Discrete

import tutorstudent as ts
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.sims.gym import GymState


class CartEnv(gymnasium.Env[Any, Any]):
    """A cart is pushed; beyond 1 m it crashes. Its buffers are reused, as real ones are."""

    def __init__(self, numbers: int = 1, patience: int = 1000, action_space: Any = None) -> None:
        self.action_space = action_space or Box(-2.0, 2.0, (numbers,), np.float32)
        self.observation_space = Box(-9.0, 9.0, (2,), np.float64)
        self.patience = patience
        self.closed = 0
        self._buffer = np.zeros(2)

    def reset(self, *, seed: int | None = None, options: Any = None) -> Any:
        super().reset(seed=seed)
        self._buffer[:] = [self.np_random.uniform(-0.1, 0.1), 0]
        self.steps = 0
        return self._buffer, {"crashed": False, "buffer": self._buffer}

    def step(self, action: Any) -> Any:
        assert self.action_space.contains(action), action
        self.steps += 1
        self._buffer += [0.1 * float(np.sum(action)), 1]
        crashed = bool(self._buffer[0] > 1)
        info = {"crashed": crashed, "buffer": self._buffer}
        return self._buffer, float(self._buffer[0]), crashed, self.steps >= self.patience, info

    def close(self) -> None:
        self.closed += 1


class ChoiceEnv(CartEnv):
    def __init__(self) -> None:
        super().__init__(action_space=Discrete(3))


gymnasium.register("tests/Cart-v0", CartEnv, disable_env_checker=True)
gymnasium.register("tests/Choice-v0", ChoiceEnv, disable_env_checker=True)

Torque = ts.scalar(-2, 2)


class CartTutor(ts.Tutor[GymState, Any]):
    """Push to the right, with a random tremor."""

    name = "cart-tutor"
    action = Torque

    def act(self, state: GymState) -> Any:
        return Torque(value=float(0.3 + 0.1 * self.rng.random()))

    @property
    def situation(self) -> str:
        return "pushing"


PIPELINE = """\
seed: 3
decisions: 60
world: {use: gymnasium, id: tests/Cart-v0}
tutor: cart-tutor
student: {use: table, encoder: {use: ranges, ranges: []}, codec: level-ampbit}
selector: modifier
amplifier: {use: learning-phase, decisions: 20, change: multiplicative}
conditions: [{use: info-true, key: crashed}, {use: reward-below, threshold: -1}]
limits: {factor: 1.5}
on_incident: raise
"""


def registry() -> Registry:
    found = Registry.discover()
    found.add(CartTutor)
    return found


def cart_pipeline(**values: Any) -> Pipeline:
    changes = {key.replace("__", "."): value for key, value in values.items()}
    return Pipeline(parse_yaml(PIPELINE, "cart.yaml"), registry()).replaced(changes)
