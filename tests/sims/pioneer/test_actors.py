"""Prey and predator: what each layer says, and that neither is trapped for long."""

from __future__ import annotations

import numpy as np
import pytest

from tests.sims.pioneer.scenes import EXACT, STOP, robot, scene
from tutorstudent.sims.pioneer.actors import Predator, PredatorOptions, Prey, PreyOptions, Sensed, sense
from tutorstudent.sims.pioneer.types import DriveAction

OPEN = Sensed(ahead_m=5.0, left_m=5.0, right_m=5.0, open_side=1.0, learner_rad=None)


def prey(**options):
    return Prey(PreyOptions(**options), np.random.default_rng(1))


def predator(**options):
    return Predator(PredatorOptions(**options), np.random.default_rng(1))


def test_what_the_front_sonars_mean():
    assert sense([0.5, 0.4, 1.0, 0.9, 0.8, 1.1, 2.0, 3.0], 0.3) == Sensed(0.8, 0.4, 2.0, -1.0, 0.3)
    assert sense([3.0, 2.0, 1.1, 0.8, 0.9, 1.0, 0.4, 0.5], None) == Sensed(0.8, 2.0, 0.4, 1.0, None)


def test_a_prey_with_a_free_way_drives_on_in_gentle_arcs():
    actor = prey(forward=0.9, turn=0.3)
    commands = [actor.act(OPEN, False) for _ in range(2000)]
    arcs = [rotation for _, rotation in commands]
    assert {translation for translation, _ in commands} == {0.9}
    assert 2000 / 60 <= len(set(arcs)) <= 2000 / 40 + 1
    assert np.std(sorted(set(arcs))) == pytest.approx(0.4 * 0.3, rel=0.35)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_before_an_obstacle_it_turns_to_the_open_side_and_the_same_way_until_the_front_is_clear(side):
    actor = prey()
    near = OPEN._replace(ahead_m=0.39, open_side=side)
    assert actor.act(near, False) == (0.0, side * 0.3)
    assert actor.act(near._replace(ahead_m=0.69, open_side=-side), False) == (0.0, side * 0.3)
    assert actor.act(near._replace(ahead_m=0.71), False)[0] == 0.9


@pytest.mark.parametrize(("left_m", "right_m", "away"), [(0.1, 0.14, -0.3), (0.14, 0.1, 0.3)])
def test_beside_a_wall_it_bears_away_at_half_speed(left_m, right_m, away):
    assert prey().act(OPEN._replace(left_m=left_m, right_m=right_m), False) == (0.45, away)


def test_after_a_stall_it_keeps_one_recovery_for_three_to_nine_ticks():
    lengths, backward = [], 0
    actor = prey()
    for _ in range(300):
        first = actor.act(OPEN, True)
        assert abs(first[0]) == 0.45
        assert abs(first[1]) <= 0.3
        backward += first[0] < 0
        length = 1
        while (command := actor.act(OPEN, False))[0] != 0.9:
            assert command == first
            length += 1
        lengths.append(length)
    assert (min(lengths), max(lengths)) == (3, 9)
    assert backward / 300 == pytest.approx(0.7, abs=0.08)


def test_a_predator_turns_to_the_learner_and_then_drives_at_it():
    actor = predator()
    assert actor.act(OPEN._replace(learner_rad=0.5), False) == (0.0, 0.25)
    assert actor.act(OPEN._replace(learner_rad=-0.5), False) == (0.0, -0.25)
    assert actor.act(OPEN._replace(learner_rad=0.1), False) == (0.1, 0.0)


def test_a_chase_outdoes_avoiding_until_the_stop_distance():
    actor = predator()
    assert actor.act(OPEN._replace(learner_rad=0.0, ahead_m=0.35), False) == (0.1, 0.0)
    assert actor.act(OPEN._replace(learner_rad=0.0, ahead_m=0.29), False) == (0.0, 0.25)


def test_a_stall_outdoes_the_chase():
    assert abs(predator().act(OPEN._replace(learner_rad=0.0), True)[0]) == 0.05


def test_a_predator_that_sees_nobody_wanders_as_a_prey_does():
    assert predator().act(OPEN, False)[0] == 0.1


def test_a_predator_finds_a_learner_that_stands_still(make_world):
    world = make_world(scene(1, 1, others=[robot("predator", "blue", 5, 5, 0)]), **EXACT, predator={"forward": 0.4})
    world.reset(2)
    for _ in range(400):
        world.step(STOP)
    (x, y, *_), (u, v, *_) = world.sketch().poses
    assert np.hypot(u - x, v - y) < 1.2


def test_a_predator_does_not_see_through_walls(make_world):
    """It looks at the learner, but a wall stands between them; it wanders, and never turns on the spot to aim."""
    wall = {"wall": [[3.0, 0.5], [3.1, 0.5], [3.1, 5.5], [3.0, 5.5]]}
    content = scene(1.5, 3, islands=wall, others=[robot("predator", "blue", 4.5, 3, 150)])
    world = make_world(content, **EXACT)
    world.reset(1)
    before = world.sketch().poses[1]
    world.step(STOP)
    assert world.sketch().poses[1][:2] != before[:2]
    without = make_world(content | {"walls": {"arena": content["walls"]["arena"]}}, **EXACT)
    without.reset(1)
    without.step(STOP)
    assert without.sketch().poses[1][:2] == before[:2]
    assert without.sketch().poses[1][2] > before[2]


def track(world, seconds):
    """Return the positions of the prey, every 2 s, shape (seconds / 2, prey, 2)."""
    hold = DriveAction(kind="stop", duration_s=2.0)
    positions = []
    for _ in range(seconds // 2):
        world.step(hold)
        positions.append([pose[:2] for pose in world.sketch().poses if pose[3] == "red"])
    return np.array(positions)


@pytest.mark.parametrize("name", ["chase-avoid", "cave-predator-prey", "cave-predator-prey-box"])
@pytest.mark.parametrize("seconds", [240, pytest.param(2000, marks=pytest.mark.slow)])
def test_no_prey_is_trapped(make_world, name, seconds):
    """In every minute each prey gets about a metre or more, and in all far enough."""
    world = make_world(name)
    world.reset(4)
    positions = track(world, seconds)
    minutes = [np.ptp(positions[i : i + 30], axis=0).max(axis=1) for i in range(0, len(positions) - 29, 30)]
    assert np.min(minutes) > 1.0
    assert np.hypot(*np.diff(positions, axis=0).T).sum(axis=1).min() > 0.2 * 0.81 * seconds


@pytest.mark.slow
@pytest.mark.parametrize("name", ["chase-avoid", "cave-predator-prey", "cave-predator-prey-box"])
def test_in_2000_seconds_no_robot_is_stuck_while_the_learner_wanders(make_world, name):
    """The learner wanders as a slow prey would; a predator may stand before it for a while, but no stall is long."""
    world = make_world(name)
    state = world.reset(1)
    learner = Prey(PreyOptions(forward=0.2, turn=0.4), np.random.default_rng(3))
    way = longest = stalled = 0.0
    for _ in range(10_000):
        translation, rotation = learner.act(sense(state.sonar_m[:8].tolist(), None), state.stalled)
        state, events, *_ = world.step(DriveAction(kind="forward", translation=translation, rotation=rotation))
        way += events["distance_m"]
        stalled = stalled + 1 if events["collided"] else 0
        longest = max(longest, stalled)
    assert way > 0.4 * 0.18 * 2000
    assert longest < 50
