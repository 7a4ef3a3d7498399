"""Gymnasium's heuristics: the tutors say what the heuristics say, and the worlds count what happened."""

from __future__ import annotations

import math
import sys
from types import SimpleNamespace

import numpy as np
import pytest

import tutorstudent as ts
from tutorstudent.core.roles.binding import Binding
from tutorstudent.sims.gym import GymState
from tutorstudent_controllers.box2d.bits import ObservationBits
from tutorstudent_controllers.box2d.lander import LanderHeuristic, Thrust
from tutorstudent_controllers.box2d.loading import load_box2d
from tutorstudent_controllers.box2d.walker import Torques, WalkerHeuristic
from tutorstudent_controllers.box2d.worlds import Lander, Walker


def bound(part: ts.Component, slot: str, action: type[ts.Action]) -> ts.Component:
    part.bind(Binding(seed=7, slot=slot, action=action))
    return part


def test_the_walkers_tutor_is_gymnasiums_heuristic_and_begins_anew_with_a_trial() -> None:
    tutor = bound(WalkerHeuristic(), "tutor", Torques)
    assert isinstance(tutor, WalkerHeuristic)
    world = bound(Walker(), "world", Torques)
    assert isinstance(world, Walker)
    for trial in (1, 2):
        heuristic = load_box2d("bipedal_walker", "test").BipedalWalkerHeuristics()
        tutor.reset()
        state = world.reset(trial)
        for _ in range(25):
            action = tutor.act(state)
            expected = heuristic.step_heuristic(state.observation)
            assert expected.tolist() == [action.hip_1, action.knee_1, action.hip_2, action.knee_2]
            state = world.step(action).state
    world.close()


def test_a_walker_that_does_nothing_falls_and_the_fall_is_counted_once() -> None:
    world = bound(Walker(), "world", Torques)
    assert isinstance(world, Walker)
    world.reset(1)
    limp = Torques(hip_1=0.6, knee_1=-1.0, hip_2=0.6, knee_2=-1.0)
    for _ in range(400):
        step = world.step(limp)
        assert float(step.done) == step.events["falls"]
        if step.done:
            break
    assert step.done
    assert -100 == step.state.reward
    assert 0 == step.events["arrivals"]
    world.close()


def test_the_way_is_the_one_that_the_simulator_made() -> None:
    world = bound(Walker(), "world", Torques)
    tutor = bound(WalkerHeuristic(), "tutor", Torques)
    assert isinstance(world, Walker)
    assert isinstance(tutor, WalkerHeuristic)
    state = world.reset(3)
    hull = world._env.unwrapped.hull
    began, way_m = float(hull.position[0]), 0.0
    for _ in range(150):
        step = world.step(tutor.act(state))
        state, way_m = step.state, way_m + step.events["distance_m"]
    assert way_m == pytest.approx(float(hull.position[0]) - began, abs=0.05)
    world.close()


def test_the_landers_tutor_is_gymnasiums_heuristic() -> None:
    tutor = bound(LanderHeuristic(), "tutor", Thrust)
    assert isinstance(tutor, LanderHeuristic)
    heuristic = load_box2d("lunar_lander", "test").heuristic
    env = SimpleNamespace(unwrapped=SimpleNamespace(continuous=True))
    for state in LanderHeuristic.examples():
        action = tutor.act(state)
        assert heuristic(env, state.observation).tolist() == [action.main, action.side]
        assert ("Landed" if state.observation[6] else "Flying") == tutor.situation


def test_a_lander_without_thrust_crashes_and_the_crash_is_counted_once() -> None:
    world = bound(Lander(), "world", Thrust)
    assert isinstance(world, Lander)
    world.reset(1)
    while not (step := world.step(Thrust(main=-1.0, side=0.0))).done:
        assert 0 == step.events["crashes"]
    assert (1.0, 0.0) == (step.events["crashes"], step.events["landings"])
    world.close()


@pytest.mark.parametrize("broken", [math.nan, math.inf])
@pytest.mark.parametrize(("tutor", "action"), [(WalkerHeuristic, Torques), (LanderHeuristic, Thrust)])
def test_observations_that_are_no_numbers_repeat_the_last_command(
    tutor: type[WalkerHeuristic], action: type[ts.Action], broken: float
) -> None:
    controller = tutor()
    bound(controller, "tutor", action)
    before = controller.act(tutor.examples()[0])
    assert before is controller.act(GymState(np.full(24, broken)))


def test_the_main_engine_is_amplified_away_from_off() -> None:
    constant, times = {"use": "constant", "level": 3}, {"use": "never", "change": "multiplicative"}
    loop = ts.wrap(LanderHeuristic(), student=constant, amplifier=times, factor=1.3, slew=None)
    gliding = GymState(np.array([0.0, 1.0, 0.0, -0.1, 0.0, 0.0, 0.0, 0.0]))
    assert Thrust(main=-1.0, side=0.0) == loop.step(gliding)
    falling = GymState(np.array([0.0, 1.4, 0.0, -1.5, 0.0, 0.0, 0.0, 0.0]))
    executed = loop.step(falling)
    assert loop.engine.pending is not None
    assert executed.main >= loop.engine.pending.moment.tutor_action.main


def test_the_student_sees_the_situation_and_thermometers() -> None:
    encoder = ObservationBits(situations=("Flying", "Landed"), numbers=[{"index": 1, "above": (0.0, 0.5)}])
    moment = ts.Moment(0, GymState(np.array([9.0, 0.2])), Thrust(main=0.0, side=0.0), "Landed")
    assert [0, 1, 1, 0] == encoder.encode(moment).tolist()
    assert 4 == encoder.width


def test_without_box2d_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "gymnasium.envs.box2d.lunar_lander", None)
    with pytest.raises(ts.PipelineError, match=r"tutor 'lander-heuristic' needs gymnasium\[box2d\]; install it with"):
        bound(LanderHeuristic(), "tutor", Thrust)
