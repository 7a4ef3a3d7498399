"""Contact with walls and robots against an independent, exact test in the plane."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.sims.pioneer.test_scenes import segments
from tutorstudent.sims.pioneer.body import CENTRE_M, LENGTH_M, WIDTH_M, Pose, edge_m, footprint
from tutorstudent.sims.pioneer.bullet import CLEARANCE_M, Bullet, load_pybullet
from tutorstudent.sims.pioneer.layout import load_layout
from tutorstudent.sims.pioneer.motion import FREE, WALLS, KinematicDrive
from tutorstudent.sims.pioneer.stage import Stage
from tutorstudent.sims.pioneer.types import DriveAction

ACCURACY_M = 0.001
"""Bullet's contact distances are this exact: meshes and boxes have small margins."""


@pytest.fixture
def stage():
    client = Bullet(load_pybullet())
    yield Stage(client, load_layout("cave-predator-prey-box", 10.0)), client
    client.close()


def corners(pose):
    """Return the body's corners, computed from the published numbers with complex numbers."""
    turn = complex(math.cos(pose.heading_rad), math.sin(pose.heading_rad))
    ends = [complex(CENTRE_M + i * LENGTH_M / 2, j * WIDTH_M / 2) for i, j in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    return np.array([complex(pose.x_m, pose.y_m) + end * turn for end in ends])


def point_to_segment(points, a, b):
    along = b - a
    share = np.clip(((points[:, None] - a) * along.conj()).real / np.abs(along) ** 2, 0, 1)
    return np.abs(points[:, None] - a - share * along).min()


def crossing(a, b, c, d):
    """Return whether any of the segments ab crosses any of cd."""

    def side(p, q, r):
        return np.sign(((q - p).conj() * (r - p)).imag)

    a, b = a[:, None], b[:, None]
    return bool(np.any((side(a, b, c) != side(a, b, d)) & (side(c, d, a) != side(c, d, b))))


def gap(body, starts, ends):
    """Return the distance between a closed outline and some segments; 0 where they cross."""
    if crossing(body, np.roll(body, -1), starts, ends):
        return 0.0
    corners_first = np.concatenate([starts, ends])
    return min(point_to_segment(body, starts, ends), point_to_segment(corners_first, body, np.roll(body, -1)))


def test_walls_are_touched_exactly_where_the_plane_says(stage):
    """1500 poses over the cave; where the exact gap is within the accuracy of the clearance, either will do."""
    scene, client = stage
    layout = load_layout("cave-predator-prey-box", 10.0)
    sides = segments(layout) @ [1, 1j]
    rng = np.random.default_rng(8)
    decided = touched = 0
    for x, y, heading in rng.uniform((0, 0, -math.pi), (10, 10, math.pi), (1500, 3)):
        pose = Pose(x, y, heading)
        exact = gap(corners(pose), sides[:, 0], sides[:, 1])
        if abs(exact - CLEARANCE_M) < ACCURACY_M:
            continue
        client.place(scene.shapes.bodies[0], pose)
        assert client.touch(scene.shapes.bodies[0], scene.walls) == (exact < CLEARANCE_M)
        decided += 1
        touched += exact < CLEARANCE_M
    assert decided > 1450
    assert touched > 200


def test_robots_touch_each_other_exactly_where_the_plane_says(stage):
    scene, client = stage
    first, second = scene.shapes.bodies[:2]
    rng = np.random.default_rng(9)
    touched = 0
    for x, y, turn, other in rng.uniform((-0.6, -0.6, -4, -4), (0.6, 0.6, 4, 4), (1500, 4)):
        here, there = Pose(5.0, 2.0, turn), Pose(5.0 + x, 2.0 + y, other)
        body = corners(there)
        exact = gap(corners(here), body, np.roll(body, -1))
        if abs(exact - CLEARANCE_M) < ACCURACY_M:
            continue
        client.place(first, here)
        client.place(second, there)
        overlap = exact < CLEARANCE_M
        assert client.touch(first, second) == overlap
        touched += overlap
    assert touched > 500


@pytest.mark.parametrize("name", ["chase-avoid", "cave-predator-prey-box"])
def test_whatever_is_commanded_no_robot_ever_overlaps_anything(make_world, name):
    """200 random actions, up to full speed and for up to a second, against the exact gap in the plane."""
    world = make_world(name)
    world.reset(6)
    sides = segments(load_layout(name)) @ [1, 1j]
    rng = np.random.default_rng(7)
    for translation, rotation, duration_s in rng.uniform((-1, -1, 0), (1, 1, 1), (200, 3)):
        action = DriveAction(kind="forward", translation=translation, rotation=rotation, duration_s=duration_s)
        state = world.step(action).state
        assert np.all((state.sonar_m >= 0.0) & (state.sonar_m <= 5.0))
        bodies = [corners(Pose(x, y, heading)) for x, y, heading, _ in world.sketch().poses]
        for i, body in enumerate(bodies):
            assert gap(body, sides[:, 0], sides[:, 1]) > 0.0
            assert all(gap(body, other, np.roll(other, -1)) > 0.0 for other in bodies[i + 1 :])


def test_a_drive_says_what_stopped_a_robot(stage):
    scene, client = stage
    poses = [Pose(5.0, 1.0, 0.0), Pose(5.5, 1.0, 0.0), Pose(5.0, 0.25, -math.pi / 2), Pose(9.0, 8.0, 0.0)]
    drive = KinematicDrive(client, scene.walls, scene.shapes, poses, 0.1)
    assert drive.tick([(0.9, 0.0), (0.5, 0.0), (1.5, 0.0), (0.9, 0.0)]) == [1, FREE, WALLS, FREE]
    assert drive.poses[0] == poses[0]
    assert drive.poses[2] == poses[2]
    assert drive.tick([(0.3, 0.0), (0.0, 0.0), (0.0, 0.0), (0.0, 0.0)])[0] == FREE


@pytest.mark.parametrize("bearing_deg", range(0, 360, 15))
def test_a_line_from_the_rotation_centre_leaves_the_body_at_its_edge(bearing_deg):
    bearing = math.radians(bearing_deg)
    way = edge_m(0.0, 0.0, math.cos(bearing), math.sin(bearing))
    body = footprint(Pose(0.0, 0.0, 0.0), "green")
    assert body.distance_m((way - 1e-6) * math.cos(bearing), (way - 1e-6) * math.sin(bearing)) == 0.0
    assert body.distance_m((way + 1e-3) * math.cos(bearing), (way + 1e-3) * math.sin(bearing)) > 0.0
