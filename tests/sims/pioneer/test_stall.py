"""Refused steps and contacts of the kinematic drive."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.sims.pioneer.scenes import EXACT, STOP, forward, pose, robot, scene
from tutorstudent.sims.pioneer.events import wrap_rad
from tutorstudent.sims.pioneer.types import DriveAction

FRONT_M = 0.18
BACK = DriveAction(kind="backward", translation=-0.3)


def against_the_wall(make_world, **options):
    """Return a world whose robot was just driven against the right wall."""
    world = make_world(scene(5.7, 3), **EXACT, **options)
    world.reset(1)
    for _ in range(3):
        step = world.step(forward(0.5))
    assert step.state.stalled
    return world


def test_a_step_into_a_wall_is_refused_whole(make_world):
    """0.09 m a tick from x = 5.7: the front would be at 5.97, then beyond the wall at 6."""
    world = make_world(scene(5.7, 3), **EXACT, ticks_per_decision=1)
    world.reset(1)
    first = world.step(forward(1.0))
    assert not first.state.stalled
    second = world.step(DriveAction(kind="forward", translation=1.0, rotation=0.5))
    assert second.state.stalled
    assert pose(world) == pytest.approx((5.79, 3.0, 0.0))


def test_a_robot_may_come_as_near_as_the_clearance_and_no_nearer(make_world):
    world = make_world(scene(5.7, 3), **EXACT, ticks_per_decision=1)
    world.reset(1)
    for _ in range(400):
        world.step(forward(0.005))
    assert 0.002 <= 6.0 - FRONT_M - pose(world).x_m <= 0.0035


def test_a_stall_lasts_while_the_robot_pushes_and_ends_with_the_first_free_step(make_world):
    world = against_the_wall(make_world)
    assert [world.step(forward(0.5)).state.stalled for _ in range(4)] == [True] * 4
    assert not world.step(BACK).state.stalled


def test_standing_still_is_no_stall(make_world):
    world = against_the_wall(make_world)
    assert not world.step(STOP).state.stalled


def test_a_rectangle_beside_a_wall_cannot_turn(make_world):
    """The left side is 1 cm from the wall; turning on the spot would put a rear corner into it."""
    world = make_world(scene(3, 6 - 0.165 - 0.01), **EXACT, ticks_per_decision=1)
    world.reset(1)
    stalls = [world.step(DriveAction(kind="right", rotation=-1.0)).state.stalled for _ in range(3)]
    assert stalls[-1]
    assert world.step(DriveAction(kind="left", rotation=0.01)).events["contact_speed_mps"] == 0.0


def test_events_count_ticks_decisions_and_new_contacts(make_world):
    world = make_world(scene(5.79, 3), **EXACT)
    world.reset(1)
    pushes = [world.step(forward(0.5)).events for _ in range(3)]
    assert [push["stalled_ticks"] for push in pushes] == [2.0, 2.0, 2.0]
    assert [push["collided"] for push in pushes] == [1.0, 1.0, 1.0]
    assert [push["longest_stall"] for push in pushes] == [1.0, 2.0, 3.0]
    assert [push["contacts"] for push in pushes] == [1.0, 0.0, 0.0]
    assert [push["contact_speed_mps"] for push in pushes] == pytest.approx([0.45, 0.0, 0.0])
    assert [push["distance_m"] for push in pushes] == [0.0, 0.0, 0.0]
    away = world.step(BACK).events
    assert (away["stalled_ticks"], away["collided"], away["longest_stall"], away["contacts"]) == (0.0, 0.0, 0.0, 0.0)
    assert away["distance_m"] == pytest.approx(0.054)
    assert sum(world.step(forward(0.3, 0.4)).events["contacts"] for _ in range(3)) == 1.0


def test_a_stall_in_one_tick_of_a_decision_makes_it_collided(make_world):
    world = make_world(scene(5.7, 3), **EXACT)
    world.reset(1)
    events = world.step(forward(1.0)).events
    assert (events["stalled_ticks"], events["collided"], events["contacts"]) == (1.0, 1.0, 1.0)


def test_driving_into_a_standing_robot_is_the_drivers_stall_alone(make_world):
    """The robot ahead is a prey that does not move; nothing is pushed."""
    world = make_world(scene(1, 3, others=[robot("prey", "red", 2.0, 3)]), **EXACT, prey={"forward": 0.0, "turn": 0.0})
    world.reset(1)
    counted = [world.step(forward(0.4)).events for _ in range(20)]
    assert sum(events["contacts"] for events in counted) == 1.0
    assert sum(events["hit_by_others"] for events in counted) == 0.0
    assert world.sketch().poses[1][:2] == (2.0, 3.0)
    assert pose(world).x_m == pytest.approx(2.0 - 0.26 - 0.18, abs=0.075)


def test_being_hit_is_counted_apart_from_own_contacts(make_world):
    """A prey that cannot turn and sees nothing drives into the learner that stands in its way."""
    prey = {"front_m": 0.0, "side_m": 0.0, "turn": 0.0, "forward": 0.4}
    world = make_world(scene(3, 3, others=[robot("prey", "red", 1.5, 3)]), **EXACT, prey=prey)
    world.reset(1)
    counted = [world.step(STOP).events for _ in range(40)]
    assert sum(events["hit_by_others"] for events in counted) >= 1.0
    assert sum(events["stalled_ticks"] for events in counted) == 0.0
    assert pose(world) == (3.0, 3.0, 0.0)


@pytest.mark.parametrize("heading_deg", range(0, 360, 30))
def test_no_speed_carries_the_robot_through_a_thin_wall(make_world, heading_deg):
    """A wall of 1 cm round a small yard; 3 m/s is 0.3 m a tick, less than the body is long."""
    thin = {
        f"{side}": [[x, y], [x + dx, y], [x + dx, y + dy], [x, y + dy]]
        for side, x, y, dx, dy in (
            ("left", 1.5, 1.5, 0.01, 3.0),
            ("right", 4.5, 1.5, 0.01, 3.0),
            ("below", 1.5, 1.5, 3.0, 0.01),
            ("above", 1.5, 4.5, 3.0, 0.01),
        )
    }
    world = make_world(scene(3, 3, heading_deg, islands=thin), **EXACT, full_speed_mps=3.0)
    world.reset(1)
    for turn in (0.0, 0.3, -0.5, 0.7) * 6:
        world.step(DriveAction(kind="forward", translation=1.0, rotation=turn, duration_s=0.5))
        x, y, _ = pose(world)
        assert 1.5 < x < 4.5
        assert 1.5 < y < 4.5


def test_the_heading_of_a_pose_counts_on_and_that_of_the_event_is_within_half_a_turn(make_world):
    world = make_world(scene(), **EXACT)
    world.reset(1)
    told = [world.step(DriveAction(kind="left", rotation=1.0, duration_s=1.0)).events["heading_rad"] for _ in range(8)]
    assert math.degrees(pose(world).heading_rad) == pytest.approx(8 * 65.0)
    assert np.degrees(told) == pytest.approx([65, 130, -165, -100, -35, 30, 95, 160])


@pytest.mark.parametrize("turns", range(-10, 11))
@pytest.mark.parametrize("direction_rad", [-math.pi + 1e-6, -1.0, 0.0, 1.0, math.pi])
def test_a_wrapped_angle_is_the_same_direction(turns, direction_rad):
    wrapped = wrap_rad(direction_rad + turns * math.tau)
    assert -math.pi < wrapped <= math.pi
    assert math.remainder(wrapped - direction_rad, math.tau) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("half_turns", [-1, 1])
def test_half_a_turn_is_told_as_plus_pi(half_turns):
    assert wrap_rad(half_turns * math.pi) == math.pi


def test_a_bump_is_felt_in_the_decision_in_which_it_is_reported_at_whichever_tick(make_world):
    """The report of the last push comes a tick late, in the first tick of the decision that backs off."""
    world = make_world(scene(5.7, 3), **{**EXACT, "ticks_per_decision": 2, "stall_latency": 1})
    world.reset(1)
    states = [world.step(forward(0.5)).state for _ in range(3)]
    assert states[-1].bumped
    backing = [world.step(BACK).state for _ in range(2)]
    assert [(False, True), (False, False)] == [(found.stalled, found.bumped) for found in backing]
    assert not world.reset(1).bumped
