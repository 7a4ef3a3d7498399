"""Whatever an environment of somebody else raises or returns is one sentence with its name."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
import pytest

import tutorstudent as ts
from tests.sims.gym.carts import CartEnv, Torque
from tutorstudent.core.roles.binding import Binding
from tutorstudent.sims.gym import GymnasiumWorld


class ForeignEnv(CartEnv):
    """Does what others do."""

    def __init__(self, where: str = "", error: str = "", **returns: Any) -> None:
        super().__init__()
        self.where, self.error, self.returns = where, error, returns
        self.fail("make")

    def fail(self, where: str) -> None:
        if where == self.where:
            raise {"file": FileNotFoundError("no meshes"), "run": RuntimeError("GL"), "exit": SystemExit(0)}[self.error]

    def reset(self, *, seed: int | None = None, options: Any = None) -> Any:
        self.fail("reset")
        assert seed is not None
        assert seed < 2**31
        observation, info = super().reset(seed=seed, options=options)
        return observation, self.returns.get("info", info)

    def step(self, action: Any) -> Any:
        self.fail("step")
        observation, reward, done, cut, info = super().step(action)
        return observation, self.returns.get("reward", reward), done, cut, self.returns.get("info", info)


gymnasium.register("tests/Foreign-v0", ForeignEnv, disable_env_checker=True)


def foreign(**kwargs: Any) -> GymnasiumWorld:
    world = GymnasiumWorld(id="tests/Foreign-v0", kwargs=kwargs)
    world.bind(Binding(7, "world", Torque))
    return world


ERRORS = [("file", "FileNotFoundError: no meshes."), ("run", "RuntimeError: GL."), ("exit", "SystemExit: 0.")]


@pytest.mark.parametrize(("error", "said"), ERRORS)
def test_an_environment_that_cannot_be_made_is_a_sentence(error: str, said: str) -> None:
    with pytest.raises(ts.PipelineError) as caught:
        foreign(where="make", error=error)
    assert f"world 'gymnasium' (tests/Foreign-v0): it cannot be made: {said}" == str(caught.value)


@pytest.mark.parametrize(("error", "said"), ERRORS)
def test_a_reset_that_fails_is_a_sentence(error: str, said: str) -> None:
    with pytest.raises(ts.ContractError) as caught:
        foreign(where="reset", error=error).reset(1)
    assert str(caught.value).startswith(f"world 'gymnasium' (tests/Foreign-v0): reset() failed: {said} An environment")


@pytest.mark.parametrize(("error", "said"), ERRORS)
def test_a_step_that_fails_is_a_sentence(error: str, said: str) -> None:
    world = foreign(where="step", error=error)
    world.reset(1)
    with pytest.raises(ts.ContractError) as caught:
        world.step(Torque(value=0.0))
    assert str(caught.value).startswith(f"world 'gymnasium' (tests/Foreign-v0): step() 0 of a trial failed: {said} An")


@pytest.mark.parametrize(
    ("reward", "number"), [(np.array([0.5]), 0.5), (np.float32(0.5), 0.5), (None, 0.0), (np.array(2), 2.0)]
)
def test_a_reward_of_any_shape_of_one_number_is_taken(reward: Any, number: float) -> None:
    world = foreign(reward=reward)
    world.reset(1)
    assert number == world.step(Torque(value=0.0)).events["reward"]


def test_a_reward_that_is_no_number_is_a_sentence() -> None:
    world = foreign(reward="much")
    world.reset(1)
    with pytest.raises(ts.ContractError, match=r"\(tests/Foreign-v0\): step\(\) 0 of a trial failed: ValueError"):
        world.step(Torque(value=0.0))


@pytest.mark.parametrize(("info", "seen"), [(None, {}), ({3: "x", ("a", 1): 2}, {"3": "x", "('a', 1)": 2})])
def test_an_info_has_words_as_keys(info: Any, seen: dict[str, Any]) -> None:
    world = foreign(info=info)
    assert seen == dict(world.reset(1).info)
    assert seen == dict(world.step(Torque(value=0.0)).state.info)


def test_seeds_are_below_two_to_the_31() -> None:
    first, second = foreign().reset(2**31 + 5), foreign().reset(5)
    assert first.observation.tolist() == second.observation.tolist()
