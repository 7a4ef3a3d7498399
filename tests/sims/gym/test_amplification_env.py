"""A pipeline as an environment: somebody else's learner chooses levels, and the contract holds."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import tutorstudent as ts
import tutorstudent.sims.gym.envs
from tests.sims.gym.carts import CartTutor, Torque, cart_pipeline, registry
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.sims.gym.amplification_env import AmplificationEnv
from tutorstudent.sims.gym.outside import Ahead


def env_of(max_level: int = 8, weights: Any = None, encoded: Any = (0.0, 1.0), **values: Any) -> AmplificationEnv:
    given = {} if weights is None else {"weights": weights}
    return AmplificationEnv(cart_pipeline(**values), max_level, encoded=encoded, **given)


def test_gymnasiums_own_checks_pass_without_a_warning() -> None:
    env = gymnasium.make("tutorstudent/Amplification-v0", pipeline=cart_pipeline(), render_mode="rgb_array")
    check_env(env.unwrapped)


def test_a_pipeline_file_is_read(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text(
        "world: {use: gymnasium, id: Pendulum-v1}\ntutor: pioneer\nstudent: {use: table, encoder: ranges}\n",
        encoding="utf-8",
    )
    with pytest.raises(ts.UnknownPlugin, match=r"p.yaml:2:1: tutor: no tutor named 'pioneer'"):
        AmplificationEnv(path)


def test_the_chosen_level_is_executed_on_the_tutors_action() -> None:
    env = env_of(limits__factor=None, limits__slew=None)
    env.reset(seed=3)
    for level in (0, 3, 8, 1):
        *_, info = env.step(np.int64(level))
        turn = env.engine.last
        own = turn.decision.moment.tutor_action.value
        assert (level, pytest.approx(own * (1 + 0.1 * level))) == (info["level"], turn.decision.executed.value)
    env.close()


def test_limits_lower_what_the_learner_asks_for() -> None:
    env = env_of(limits__slew=1)
    env.reset(seed=3)
    assert [1, 2, 3, 4, 5, 5] == [env.step(8)[4]["level"] for _ in range(6)]  # slew 1, factor 1.5
    env.close()


def test_the_observation_is_of_the_action_that_is_about_to_be_amplified() -> None:
    env = env_of()
    encoder = env.engine.student.options.encoder
    seen, _ = env.reset(seed=3)
    for _ in range(10):
        before = seen
        seen, *_ = env.step(2)
        assert before.tolist() == encoder.encode(env.engine.last.decision.moment).tolist()
    env.close()


def test_the_tutor_is_asked_once_per_decision_and_not_after_the_last(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[float] = []
    act = CartTutor.act
    monkeypatch.setattr(CartTutor, "act", lambda self, state: asked.append(state.observation[1]) or act(self, state))
    env = env_of(world__kwargs={"patience": 3})
    env.reset(seed=3)
    assert [False, False, True] == [env.step(0)[3] for _ in range(3)]
    env.reset()
    env.step(0)
    assert [0.0, 1.0, 2.0, 0.0, 1.0] == asked
    assert 4 == env.engine.decisions
    env.close()


def test_a_trial_that_was_cut_off_is_not_judged_and_one_that_ended_is() -> None:
    env = env_of(world__kwargs={"patience": 1})
    env.reset(seed=3)
    *_, truncated, _ = env.step(0)
    assert (True, "dropped") == (truncated, env.engine.last.void)
    env.close()
    env = env_of()
    env.reset(seed=3)
    rewards, terminated = [], False
    while not terminated:
        _, reward, terminated, _, info = env.step(5)
        rewards.append(reward)
    assert [-1.0] == [reward for reward in rewards if reward]
    assert 1.0 == info["violated"]
    env.close()


def test_the_same_seed_is_the_same_run_and_trials_of_one_run_differ() -> None:
    env = env_of(encoded=(0.0, 1.0))

    def trial(seed: int | None) -> list[float]:
        env.reset(seed=seed)
        return [env.step(level)[4]["reward"] for level in range(9)]

    first, second = trial(3), trial(None)
    assert first != second
    assert (first, second) == (trial(3), trial(None))
    env.close()


def test_the_tutor_draws_what_it_draws_in_the_pipeline() -> None:
    pipeline = cart_pipeline()
    engine = pipeline.engine()
    expected = [engine.propagate(None) and engine.pending.moment.tutor_action.value for _ in range(5)]
    env = AmplificationEnv(pipeline)
    env.reset()
    found = []
    for _ in range(5):
        env.step(0)
        found.append(env.engine.last.decision.moment.tutor_action.value)
    assert expected == found
    env.close()


def test_the_reward_is_the_weighted_events() -> None:
    env = env_of(weights={"reward": 2.0, "violated": -3.0})
    env.reset(seed=3)
    _, reward, _, _, info = env.step(0)
    assert 2.0 * info["reward"] == reward
    env.close()


def test_a_tutor_that_fails_is_replaced_by_the_owners_action(monkeypatch: pytest.MonkeyPatch) -> None:
    def act(self: Any, state: Any) -> Any:
        if state.observation[1] == 1:
            raise RuntimeError("sensor lost")
        return Torque(value=0.5) if state.observation[1] < 3 else "full speed"

    monkeypatch.setattr(CartTutor, "act", act)
    env = env_of(on_tutor_failure={"value": -0.1}, on_incident="continue")
    env.reset(seed=3)
    executed = [env.step(0) and env.engine.last.decision.executed.value for _ in range(4)]
    assert [0.5, -0.1, 0.5, -0.1] == executed
    assert {("tutor", "raised"): 2} == env.engine.incident_counts
    env.close()
    env = env_of()
    env.reset(seed=3)
    with pytest.raises(RuntimeError, match="sensor lost"):
        env.step(0)
    env.close()


def test_the_tutor_hears_what_was_executed(monkeypatch: pytest.MonkeyPatch) -> None:
    heard: list[float] = []
    monkeypatch.setattr(CartTutor, "executed", lambda self, action: heard.append(action.value))
    env = env_of()
    env.reset(seed=3)
    executed = [env.step(4) and env.engine.last.decision.executed.value for _ in range(3)]
    assert executed == heard
    assert "pushing" == env.engine.last.decision.moment.situation
    env.close()


@pytest.mark.parametrize("level", [-1, 9, 0.5, None, "3"])
def test_what_is_no_level_is_refused(level: Any) -> None:
    env = env_of()
    env.reset(seed=3)
    with pytest.raises(ts.ContractError, match=re.escape(f"step(): found {level!r}; a level is a whole number in")):
        env.step(level)
    env.close()


def test_without_a_trial_there_is_no_step() -> None:
    with pytest.raises(ts.ContractError, match=r"no trial is running; call reset\(\) first"):
        env_of().step(0)


def test_an_encoder_beyond_its_declared_range_is_told() -> None:
    env = env_of(encoded=(0.0, 0.5))
    with pytest.raises(
        ts.ContractError, match=r"encoder 'ranges': returned .*State the range .* encoded=\(-1.0, 1.0\)"
    ):
        env.reset(seed=3)
    env.close()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("tutor: cart-tutor", "p.yaml: student: the student names no encoder, so there is nothing to observe; add one"),
        ("tutor: cart-tutor\nstudent: silent", "p.yaml:2:1: student: the student names no encoder"),
        ("student: {use: table, encoder: ranges}", "p.yaml: there is no 'tutor'; name one"),
        ("tutor: cart-tutor\nstudent: {use: table, encoder: rangs}", "student.encoder: no encoder named 'rangs'"),
        (
            "tutor: cart-tutor\nstudent: {use: table, encoder: ranges}\namplifier: {use: nevr}",
            "no amplifier named 'nevr'",
        ),
        ("tutor: cart-tutor\nstudent: {use: table, encoder: ranges}", "p.yaml: there is no 'world'; add one"),
        (
            "tutor: cart-tutor\nstudent: {use: table, encoder: ranges}\nworld: pioneer",
            "world 'pioneer' executes DriveAction but tutor 'ahead' returns Scalar",
        ),
    ],
)
def test_a_pipeline_that_does_not_fit_is_told(text: str, message: str) -> None:
    with pytest.raises(ts.TutorStudentError, match=re.escape(message)):
        AmplificationEnv(Pipeline(parse_yaml(text, "p.yaml"), registry()))


def test_there_is_at_least_one_level() -> None:
    with pytest.raises(ts.PipelineError, match="max_level: found 0; the highest level is at least 1"):
        env_of(max_level=0)
    with pytest.raises(ts.ContractError, match="weights: there is no event 'crash'"):
        env_of(weights={"crash": 1.0})


def test_a_tutor_asked_ahead_stands_where_the_tutor_stands() -> None:
    ahead = Ahead(tutor=CartTutor())
    assert Torque is ahead.action
