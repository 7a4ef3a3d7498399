"""The three drives do what they are told, within what each promises, and pass no walls."""

from __future__ import annotations

import math

import pytest

from tests.sims.pioneer.scenes import EXACT, STOP, forward, pose, robot, scene
from tutorstudent.sims.pioneer.types import DriveAction

DRIVES = ["kinematic", "planar", "wheeled"]
WAY = {"kinematic": 1e-9, "planar": 1e-6, "wheeled": 0.04}
"""Allowed share by which a way may be off."""
TURN = {"kinematic": 1e-9, "planar": 1e-6, "wheeled": 0.05}
"""Allowed share by which a turn may be off."""
DRIFT = {"kinematic": 1e-9, "planar": 1e-6, "wheeled": 0.02}
"""Allowed metres or radians of unwanted motion."""

pytestmark = pytest.mark.parametrize("drive", DRIVES)


def ready(make_world, content, drive, **options):
    world = make_world(content, drive=drive, **EXACT, **options)
    world.reset(1)
    return world


@pytest.mark.parametrize("translation", [0.3, -0.3, 1.0])
def test_it_drives_straight_as_far_as_told(make_world, drive, translation):
    world = ready(make_world, scene(3, 3, 30), drive)
    kind = "forward" if translation > 0 else "backward"
    for _ in range(3):
        world.step(DriveAction(kind=kind, translation=translation, duration_s=0.5))
    world.step(STOP)
    x, y, heading = pose(world)
    way = (x - 3) * math.cos(math.radians(30)) + (y - 3) * math.sin(math.radians(30))
    aside = (y - 3) * math.cos(math.radians(30)) - (x - 3) * math.sin(math.radians(30))
    assert way == pytest.approx(translation * 0.9 * 1.5, rel=WAY[drive], abs=0.01)
    assert aside == pytest.approx(0.0, abs=DRIFT[drive])
    assert heading == pytest.approx(math.radians(30), abs=DRIFT[drive])


@pytest.mark.parametrize("rotation", [0.5, -0.5])
def test_it_turns_on_the_spot_as_far_as_told(make_world, drive, rotation):
    world = ready(make_world, scene(3, 3), drive)
    kind = "left" if rotation > 0 else "right"
    for _ in range(4):
        world.step(DriveAction(kind=kind, rotation=rotation, duration_s=1.0))
    world.step(STOP)
    x, y, heading = pose(world)
    assert math.degrees(heading) == pytest.approx(rotation * 65 * 4, rel=TURN[drive])
    assert math.hypot(x - 3, y - 3) == pytest.approx(0.0, abs=DRIFT[drive])


def test_it_stands_when_told_to_stop(make_world, drive):
    world = ready(make_world, scene(3, 3), drive)
    world.step(forward(0.5, 1.0))
    world.step(STOP)
    before = pose(world)
    events = [world.step(STOP).events for _ in range(10)]
    assert pose(world) == pytest.approx(before, abs=0.005)
    assert sum(event["stalled_ticks"] for event in events) == 0.0


def test_a_robot_that_drives_into_a_wall_stalls_before_it(make_world, drive):
    """Head on, at full speed, for 3 s."""
    world = ready(make_world, scene(4.5, 3), drive)
    events = [world.step(forward(1.0)).events for _ in range(15)]
    assert 6.0 - 0.18 - pose(world).x_m == pytest.approx(0.0, abs=0.1)
    assert pose(world).x_m + 0.18 < 6.01
    assert events[-1]["stalled_ticks"] == 2.0
    assert sum(event["contacts"] for event in events) == 1.0
    assert max(event["contact_speed_mps"] for event in events) == pytest.approx(0.9)
    assert sum(event["stalled_ticks"] for event in events) >= 10.0


@pytest.mark.parametrize("heading_deg", [5, 50, 130, 200, 290])
def test_no_drive_passes_a_wall(make_world, drive, heading_deg):
    """A yard of 1.6 m among walls of 2 cm, at full speed and turning, for 8 s."""
    thin = {
        "left": [[2.2, 2.2], [2.22, 2.2], [2.22, 3.8], [2.2, 3.8]],
        "right": [[3.78, 2.2], [3.8, 2.2], [3.8, 3.8], [3.78, 3.8]],
        "below": [[2.2, 2.2], [3.8, 2.2], [3.8, 2.22], [2.2, 2.22]],
        "above": [[2.2, 3.78], [3.8, 3.78], [3.8, 3.8], [2.2, 3.8]],
    }
    world = ready(make_world, scene(3, 3, heading_deg, islands=thin), drive, physics_hz=240)
    for turn in (0.0, 0.4, -0.4, 0.1):
        world.step(DriveAction(kind="forward", translation=1.0, rotation=turn, duration_s=2.0))
        x, y, _ = pose(world)
        assert 2.2 < x < 3.8
        assert 2.2 < y < 3.8


def test_robots_stop_each_other(make_world, drive):
    """A learner drives at a prey that stands still; it comes as near as the two bodies allow."""
    still = {"forward": 0.0, "turn": 0.0}
    world = ready(make_world, scene(1, 3, others=[robot("prey", "red", 5, 3, 180)]), drive, prey=still)
    counted = [world.step(forward(0.6)).events for _ in range(40)]
    assert sum(event["contacts"] for event in counted) >= 1.0
    gap = world.sketch().poses[1][0] - pose(world).x_m
    assert gap >= 2 * 0.18 - 0.02


def test_a_turned_tick_keeps_the_heading_counting_on(make_world, drive):
    world = ready(make_world, scene(3, 3), drive)
    for _ in range(7):
        world.step(DriveAction(kind="left", rotation=1.0, duration_s=1.0))
    assert math.degrees(pose(world).heading_rad) == pytest.approx(7 * 65, rel=0.05)
