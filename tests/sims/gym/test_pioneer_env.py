"""The Pioneer world as a Gymnasium environment."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import tutorstudent as ts
import tutorstudent.sims.gym.envs
from tutorstudent.core.roles.world import Sketch
from tutorstudent.sims.gym.drawing import SIDE, draw_picture
from tutorstudent.sims.gym.pioneer_env import PioneerEnv, make_drive_action
from tutorstudent.sims.pioneer.pioneer_world import PioneerWorld
from tutorstudent.sims.pioneer.types import DriveAction


def test_gymnasiums_own_checks_pass_without_a_warning() -> None:
    check_env(gymnasium.make("tutorstudent/Pioneer-v0", render_mode="rgb_array").unwrapped)


def test_it_can_be_made_in_one_word_and_is_cut_off() -> None:
    env = gymnasium.make("tutorstudent.sims.gym.envs:tutorstudent/Pioneer-v0", max_episode_steps=2, scene="cave-box")
    env.reset(seed=1)
    assert [False, True] == [env.step(np.zeros(2, np.float32))[3] for _ in range(2)]
    env.close()


def test_it_drives_as_the_world_does() -> None:
    env, world = PioneerEnv(), PioneerWorld()
    env.reset(seed=5)
    seed = int(np.random.Generator(np.random.PCG64(np.random.SeedSequence(5))).integers(2**31))
    world.reset(seed)
    for command in ([0.5, 0.0], [0.0, -0.25], [1.0, 0.5]):
        seen, _, _, _, events = env.step(np.array(command, np.float32))
        step = world.step(make_drive_action(*command))
        assert dict(step.events) == events
        assert step.state.sonar_m == pytest.approx(seen["sonar_m"])
    env.close()
    world.close()


def test_the_reward_is_the_weighted_events() -> None:
    env = PioneerEnv(weights={"distance_m": 2.0, "time_s": -1.0})
    env.reset(seed=5)
    _, reward, _, _, events = env.step(np.array([0.5, 0.0], np.float32))
    assert 2.0 * events["distance_m"] - events["time_s"] == pytest.approx(reward)
    env.close()


def test_a_weight_for_an_unknown_event_is_told() -> None:
    with pytest.raises(ts.ContractError, match=r"weights: there is no event 'colided' \(did you mean 'collided'\?\)"):
        PioneerEnv(weights={"colided": -1.0})


def test_what_is_in_view_is_in_the_observation() -> None:
    env = PioneerEnv(scene="chase-avoid")
    seen, _ = env.reset(seed=1)
    things: list[Any] = []
    for _ in range(60):
        seen, *_ = env.step(np.array([0.0, 0.5], np.float32))
        things.append(seen["red"].tolist())
        assert env.observation_space.contains(seen)
    assert {0.0, 1.0} == {thing[0] for thing in things}
    assert all(thing[2] == pytest.approx(env.world.options.camera_range_m) for thing in things if not thing[0])
    env.close()


@pytest.mark.parametrize(
    ("command", "kind"),
    [((0, 0), "stop"), ((0.2, 0.1), "forward"), ((-0.2, 0.2), "backward"), ((0.1, 0.2), "left"), ((0, -1), "right")],
)
def test_a_command_has_the_kind_of_its_larger_component(command: tuple[float, float], kind: str) -> None:
    action = make_drive_action(*command)
    assert DriveAction(kind=kind, translation=command[0], rotation=command[1]) == action  # type: ignore[arg-type]


def test_a_picture_shows_outlines_discs_and_poses_in_their_colours() -> None:
    square = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
    image = draw_picture(Sketch([(square, "black")], [((1.0, 1.0), 0.5, "red")], [(1.0, 1.0, 0.0, "mauve")]))
    assert (SIDE, SIDE, 3) == image.shape
    colours = {tuple(pixel) for pixel in image.reshape(-1, 3).tolist()}
    assert {(255, 255, 255), (0, 0, 0), (204, 51, 51)} == colours


@pytest.mark.parametrize("sketch", [Sketch(), Sketch([([], "black")]), Sketch([([(1.0, 1.0)], "black")])])
def test_a_picture_of_next_to_nothing_can_be_drawn(sketch: Sketch) -> None:
    assert (SIDE, SIDE, 3) == draw_picture(sketch).shape


def test_without_a_render_mode_nothing_is_drawn() -> None:
    env = PioneerEnv()
    env.reset(seed=1)
    assert env.render() is None
    env.close()
