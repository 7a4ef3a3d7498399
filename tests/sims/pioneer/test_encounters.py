"""Encounters: crossing a radius round something red, with hysteresis."""

from __future__ import annotations

import pytest

from tests.sims.pioneer.scenes import EXACT, STOP, box, forward, robot, scene
from tutorstudent.sims.pioneer.body import Pose, Rectangle
from tutorstudent.sims.pioneer.events import Encounters
from tutorstudent.sims.pioneer.types import DriveAction

BACK = DriveAction(kind="backward", translation=-0.2)


def encounters(world, actions):
    return [world.step(action).events["encounters"] for action in actions]


def walk(*distances):
    """Return the encounters of a robot at these distances from the side of a red box."""
    thing = Rectangle("red", 0.0, 0.0, 1.0, 0.0, 0.15, 0.15)
    counter = Encounters(Pose(9.0, 0.0, 0.0), [thing], [], 1.0, 1.5)
    return [counter.count(Pose(0.15 + distance, 0.0, 0.0), []) for distance in distances]


def test_coming_nearer_than_the_radius_counts_once():
    assert walk(1.01, 0.99, 0.5, 0.98, 0.3) == [0, 1, 0, 0, 0]


def test_between_the_radii_nothing_changes():
    assert walk(1.2, 0.9, 1.2, 0.9, 1.49, 0.9) == [0, 1, 0, 0, 0, 0]


def test_beyond_the_release_radius_the_thing_counts_again():
    assert walk(0.9, 1.51, 1.2, 0.9, 8.0, 0.9) == [1, 0, 0, 1, 0, 1]


def test_the_distance_is_to_the_surface_also_at_a_corner():
    """From the corner (0.15, 0.15) along the diagonal."""
    thing = Rectangle("red", 0.0, 0.0, 1.0, 0.0, 0.15, 0.15)
    counter = Encounters(Pose(9.0, 0.0, 0.0), [thing], [], 1.0, 1.5)
    diagonal = 1.0 / 2**0.5
    assert counter.count(Pose(0.15 + diagonal + 0.01, 0.15 + diagonal, 0.0), []) == 0
    assert counter.count(Pose(0.15 + diagonal - 0.01, 0.15 + diagonal, 0.0), []) == 1


def test_what_is_near_at_the_start_does_not_count(make_world):
    world = make_world(scene(3, 3, boxes=[box("red", 3.8, 3)]), **EXACT)
    world.reset(1)
    assert encounters(world, [STOP] * 3) == [0.0] * 3


def test_driving_to_a_box_and_away_and_back_counts_twice(make_world):
    options = EXACT | {"encounter_radius_m": 0.95, "encounter_release_m": 1.2}
    world = make_world(scene(3, 3, boxes=[box("red", 5, 3)]), **options)
    world.reset(1)
    there = encounters(world, [forward(0.2)] * 30)
    away = encounters(world, [BACK] * 20)
    again = encounters(world, [forward(0.2)] * 20)
    assert (sum(there), sum(away), sum(again)) == (1.0, 0.0, 1.0)
    assert there.index(1.0) == 25  # 1.85 m at 0.036 m a decision: within 0.95 m after 25 decisions


def test_blue_things_are_no_encounters(make_world):
    world = make_world(scene(3, 3, boxes=[box("blue", 5, 3)]), **EXACT)
    world.reset(1)
    assert sum(encounters(world, [forward(0.2)] * 30)) == 0.0


def test_a_red_robot_counts_at_its_body(make_world):
    still = {"forward": 0.0, "turn": 0.0}
    world = make_world(scene(1, 3, others=[robot("prey", "red", 4, 3)]), **EXACT, prey=still)
    world.reset(1)
    assert sum(encounters(world, [forward(1.0)] * 9)) == 0.0  # x = 2.62; the tail is at 3.74
    assert sum(encounters(world, [forward(1.0)])) == 1.0  # x = 2.8


def test_a_release_below_the_radius_is_refused(make_world):
    with pytest.raises(Exception, match="encounter_release_m is less than encounter_radius_m"):
        make_world("cave-box", encounter_radius_m=1.0, encounter_release_m=0.9)
