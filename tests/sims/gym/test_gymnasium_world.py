"""Any Gymnasium environment with a continuous action space is a world."""

from __future__ import annotations

import re
import sys
from typing import Any

import gymnasium
import numpy as np
import pytest

import tutorstudent as ts
from tests.sims.gym.carts import CartEnv, Torque, cart_pipeline
from tutorstudent.core.files.rundir import run_pipeline
from tutorstudent.core.roles.binding import Binding
from tutorstudent.sims.gym import GymnasiumWorld, GymState


def cart(**kwargs: Any) -> GymnasiumWorld:
    return GymnasiumWorld(id="tests/Cart-v0", kwargs=kwargs)


def test_a_state_is_what_the_environment_said() -> None:
    world = cart()
    first = world.reset(7)
    step = world.step(Torque(value=2.0))
    assert (0.0, False, False) == first[1:4]
    assert step.state.observation.tolist() == pytest.approx([first.observation[0] + 0.2, 1.0])
    assert (step.state.observation[0], False, False) == step.state[1:4]
    assert not step.state.info["crashed"]
    world.close()


def test_states_are_read_only_copies_of_buffers_that_are_reused() -> None:
    world = cart()
    first = world.reset(7)
    second = world.step(Torque(value=1.0)).state
    assert [0.0, 1.0] == [first.observation[1], second.observation[1]]
    arrays = [first.observation, first.info["buffer"], second.observation, second.info["buffer"]]
    assert not any(array.flags.writeable for array in arrays)
    world.close()


def test_terminated_ends_a_trial_and_truncated_cuts_it_off() -> None:
    world = cart(patience=4)
    world.reset(7)
    steps = [world.step(Torque(value=2.0)) for _ in range(4)]
    assert [(False, False)] * 3 + [(False, True)] == [(step.done, step.truncated) for step in steps]
    step = world.step(Torque(value=2.0))
    while not step.done:
        step = world.step(Torque(value=2.0))
    assert step.state.terminated
    world.close()


def test_events_are_the_reward_the_return_and_the_end() -> None:
    world = cart(patience=2)
    world.reset(7)
    first, second = (world.step(Torque(value=1.0)).events for _ in range(2))
    assert (first["reward"], 0.0) == (first["episode_return"], first["episodes"])
    assert (first["reward"] + second["reward"], 1.0) == (second["episode_return"], second["episodes"])
    world.reset(8)
    again = world.step(Torque(value=1.0)).events
    assert again["reward"] == again["episode_return"]
    assert set(world.event_names) == set(again)
    world.close()


def test_the_same_seed_begins_the_same_trial() -> None:
    world = cart()
    starts = [world.reset(seed).observation.tolist() for seed in (7, 7, 8)]
    assert starts[0] == starts[1] != starts[2]
    world.close()


def test_max_steps_cuts_trials_off_elsewhere() -> None:
    world = GymnasiumWorld(id="Pendulum-v1", max_steps=3)
    world.reset(1)
    assert [False, False, True] == [world.step(Torque(value=0.0)).truncated for _ in range(3)]
    world.close()


def test_two_runs_of_one_seed_are_identical_and_another_seed_is_another_run() -> None:
    summaries = []
    for seed in (3, 3, 4):
        finished = run_pipeline(cart_pipeline(seed=seed))
        summaries.append({key: value for key, value in finished.summary.items() if "second" not in key})
    assert summaries[0] == summaries[1] != summaries[2]
    assert 0 < summaries[0]["violated:info-true(crashed)"]
    assert summaries[0]["episodes"] == summaries[0]["violated:info-true(crashed)"]
    assert 0 == summaries[0]["incidents"]


def test_any_action_class_that_fits_is_executed() -> None:
    world = GymnasiumWorld(id="tests/Cart-v0", kwargs={"numbers": 2})
    world.bind(Binding(7, "world", ts.vector(-1, 2, 2)))
    before = world.reset(7).observation[0]
    assert 0.1 == pytest.approx(world.step(ts.vector(-1, 1, 2).read([0.25, 0.75])).state.observation[0] - before)
    world.close()


@pytest.mark.parametrize(
    ("action", "message"),
    [
        (ts.vector(-1, 1, 3), "the tutor's Vector has the components x0, x1, x2; the action space Box(-2.0, 2.0, (2,)"),
        (ts.scalar(-1, 1), "takes 2 numbers. Use a class of as many, as in ts.vector(low, high, 2)."),
        (ts.vector(-1, 3, 2), "the component 'x0' of the tutor's Vector lies in [-1, 3]; the action space allows"),
        (ts.vector(-3, 1, 2), "[-2, 2]. State these bounds."),
    ],
)
def test_an_action_class_that_does_not_fit_is_refused_at_assembly(action: type[ts.Action], message: str) -> None:
    world = GymnasiumWorld(id="tests/Cart-v0", kwargs={"numbers": 2})
    with pytest.raises(ts.ContractError, match=re.escape(message)) as caught:
        world.bind(Binding(7, "world", action))
    assert str(caught.value).startswith("world 'gymnasium' (tests/Cart-v0): ")
    world.close()


def test_an_action_class_that_does_not_fit_is_refused_in_somebodys_own_loop_too() -> None:
    world = cart()
    world.reset(7)
    with pytest.raises(ts.ContractError, match="takes 1 numbers"):
        world.step(ts.vector(-1, 1, 3).read([0, 0, 0]))
    world.close()


def test_bounds_in_single_precision_are_the_same_bounds() -> None:
    space = gymnasium.spaces.Box(-0.7, 0.7, (1,), np.float32)
    world = cart(action_space=space)
    world.bind(Binding(7, "world", ts.scalar(-0.7, 0.7)))
    world.reset(7)
    world.step(ts.scalar(-0.7, 0.7)(value=0.7))  # the environment asserts that it contains the action
    world.close()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"id": "tests/Choice-v0"}, "(tests/Choice-v0): the action space Discrete(3) has no magnitudes, so there is"),
        ({"id": "CartPole-v1"}, "use an environment whose action space is a Box of floats."),
        ({"id": "Pendulun-v1"}, "(Pendulun-v1): it cannot be made: NameNotFound:"),
        ({"id": "tests/Cart-v0", "kwargs": {"colour": 1}}, "it cannot be made: TypeError:"),
        ({"id": "no_such_module:Cart-v0"}, "it cannot be made: ModuleNotFoundError:"),
    ],
)
def test_an_environment_that_cannot_be_used_is_told(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ts.TutorStudentError, match=re.escape(message)):
        GymnasiumWorld(**options).bind(Binding(7, "world", Torque))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({}, "option 'id' is required"),
        ({"id": "x", "max_steps": 0}, "option 'max_steps'"),
        ({"id": "x", "ID": "y"}, r"unknown option 'ID' \(did you mean 'id'\?\). Options: id, kwargs, max_steps"),
    ],
)
def test_a_mistake_in_the_options_is_told(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ts.PipelineError, match=message):
        GymnasiumWorld(**options)


def test_a_whole_number_box_has_nothing_to_amplify() -> None:
    world = cart(action_space=gymnasium.spaces.Box(0, 5, (1,), np.int64))
    with pytest.raises(ts.ContractError, match="has no magnitudes, so there is nothing to amplify"):
        world.reset(7)


def test_without_a_trial_there_is_no_step() -> None:
    with pytest.raises(ts.ContractError, match=r"no trial is running; call reset\(seed\) first"):
        cart().step(Torque(value=0.0))


def test_closing_closes_the_environment_and_a_later_reset_makes_a_new_one() -> None:
    world = cart()
    world.close()
    world.reset(7)
    env: CartEnv = world._env.unwrapped
    world.close()
    world.close()
    assert 1 == env.closed
    world.reset(7)
    assert env is not world._env.unwrapped
    world.close()


def test_a_missing_extra_is_told_with_the_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "gymnasium", None)
    with pytest.raises(ts.PipelineError, match=re.escape("install it with: pip install 'tutorstudent[gym]'")):
        cart().reset(7)


def test_a_callable_tutor_and_the_runner_drive_it() -> None:
    engine = ts.wrap(lambda state: 0.5, action=Torque, conditions=[lambda state: state.info["crashed"]]).engine
    world = cart()
    ts.run(engine, world, 30, seed=1)
    assert isinstance(engine.last.decision.moment.state, GymState)  # type: ignore[union-attr]
    world.close()
