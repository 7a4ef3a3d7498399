"""Ticks, latencies, speeds: how time runs."""

from __future__ import annotations

import math

import pytest

from tests.sims.pioneer.scenes import EXACT, STOP, forward, pose, scene
from tutorstudent.sims.pioneer.types import DriveAction


@pytest.mark.parametrize(
    ("duration_s", "ticks_per_decision", "ticks"),
    [
        (0.0, 2, 2),
        (0.0, 1, 1),
        (0.1, 1, 1),
        (0.14, 1, 1),
        (0.16, 1, 2),
        (0.2, 3, 3),
        (0.44, 2, 4),
        (0.5, 2, 5),
        (1.0, 2, 10),
        (0.3, 7, 7),
    ],
)
def test_a_command_is_held_for_its_duration_and_at_least_a_decision(make_world, duration_s, ticks_per_decision, ticks):
    world = make_world(scene(), **EXACT, ticks_per_decision=ticks_per_decision)
    world.reset(1)
    assert world.count_ticks(duration_s) == ticks
    events = world.step(forward(0.1, duration_s)).events
    assert events["time_s"] == pytest.approx(0.1 * ticks)
    assert events["distance_m"] == pytest.approx(0.09 * 0.1 * ticks)


def test_the_length_of_a_tick_is_an_option(make_world):
    world = make_world(scene(), **EXACT, tick_s=0.05)
    world.reset(1)
    assert world.step(forward(0.1, 0.2)).events["time_s"] == pytest.approx(0.2)
    assert world.count_ticks(0.2) == 4


def test_full_speed_is_nine_decimetres_and_sixty_five_degrees_a_second(make_world):
    world = make_world(scene(1, 3), **EXACT)
    world.reset(1)
    world.step(forward(1.0, 1.0))
    assert pose(world)[:2] == pytest.approx((1.9, 3.0))
    world.step(DriveAction(kind="left", rotation=1.0, duration_s=1.0))
    assert math.degrees(pose(world).heading_rad) == pytest.approx(65.0)
    world.step(DriveAction(kind="right", rotation=-1.0, duration_s=2.0))
    assert math.degrees(pose(world).heading_rad) == pytest.approx(-65.0)


def test_a_tick_goes_along_the_old_heading_and_then_turns(make_world):
    """Euler's step, as in the thesis's simulator."""
    world = make_world(scene(3, 3, 90), **EXACT, ticks_per_decision=1)
    world.reset(1)
    world.step(DriveAction(kind="forward", translation=0.5, rotation=0.5))
    x, y, heading = pose(world)
    assert (x, y) == pytest.approx((3.0, 3.045))
    assert math.degrees(heading) == pytest.approx(93.25)


@pytest.mark.parametrize("latency", [0, 1, 2, 3, 5, 8])
@pytest.mark.parametrize("ticks_per_decision", [1, 2, 3])
def test_what_the_learner_reads_is_exactly_as_old_as_the_latency(make_world, latency, ticks_per_decision):
    """Driving at a wall, the range ahead tells the tick at which it was taken."""
    options = EXACT | {"sensor_latency": latency, "ticks_per_decision": ticks_per_decision}
    world = make_world(scene(1, 3), **options)
    first = world.reset(1)
    per_tick = 0.009 / math.cos(math.radians(10.0))
    for decision in range(1, 9):
        state = world.step(forward(0.1)).state
        age = max(0, decision * ticks_per_decision - latency)
        assert first.sonar_m[3] - state.sonar_m[3] == pytest.approx(age * per_tick, abs=1e-5)


def test_latency_does_not_depend_on_how_long_decisions_are(make_world):
    world = make_world(scene(1, 3), **EXACT | {"sensor_latency": 3})
    first = world.reset(1)
    per_tick = 0.009 / math.cos(math.radians(10.0))
    ticks = 0
    for duration_s in (0.0, 0.5, 0.3, 0.0, 1.0, 0.4):
        ticks += world.count_ticks(duration_s)
        state = world.step(forward(0.1, duration_s)).state
        assert first.sonar_m[3] - state.sonar_m[3] == pytest.approx(max(0, ticks - 3) * per_tick, abs=1e-5)


def test_blobs_are_as_old_as_ranges(make_world):
    boxes = [{"colour": "red", "x": 5, "y": 3, "side_m": 0.3}]
    world = make_world(scene(1, 3, boxes=boxes), **EXACT | {"sensor_latency": 3, "ticks_per_decision": 1})
    first = world.reset(1).blobs[0].range_m
    seen = [first - world.step(forward(0.1)).state.blobs[0].range_m for _ in range(6)]
    assert seen == pytest.approx([0.0, 0.0, 0.0, 0.009, 0.018, 0.027], abs=1e-6)


def test_looking_back_leaves_the_robots_where_they_are(make_world):
    """Sensing the past puts bodies back in time; the next step must not collide with where they were."""
    worlds = [make_world("chase-avoid", sensor_latency=latency) for latency in (0, 4)]
    for world in worlds:
        world.reset(3)
    for _ in range(60):
        here, there = (world.step(forward(0.2)).events for world in worlds)
        assert here == there


@pytest.mark.parametrize("stall_latency", [0, 1, 2, 4])
def test_the_stall_flag_is_exactly_as_old_as_its_own_latency(make_world, stall_latency):
    options = EXACT | {"stall_latency": stall_latency, "sensor_latency": 7, "ticks_per_decision": 1}
    world = make_world(scene(5.5, 3), **options)
    assert world.reset(1).stalled is False
    really, reported = [], []
    for action in [forward(0.8)] * 9 + [STOP] * 9:
        step = world.step(action)
        really.append(step.events["stalled_ticks"] == 1.0)
        reported.append(step.state.stalled)
    assert True in really
    assert reported == [False] * stall_latency + really[: len(really) - stall_latency]
