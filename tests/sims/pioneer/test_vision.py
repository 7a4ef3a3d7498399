"""The blob sensor against closed forms, and the two cameras against each other."""

from __future__ import annotations

import math

import pytest

from tests.sims.pioneer.scenes import EXACT, box, forward, robot, scene
from tutorstudent.sims.pioneer.body import Pose, Rectangle
from tutorstudent.sims.pioneer.vision import BlobCamera


def look(make_world, content, **options):
    return make_world(content, **EXACT | options).reset(1).blobs


@pytest.mark.parametrize("bearing_deg", [-50, -20, 0, 35, 55])
@pytest.mark.parametrize("heading_deg", [0, 90, 200])
def test_a_box_is_seen_at_its_bearing_range_and_width(make_world, bearing_deg, heading_deg):
    """A box of 0.3 m that turns a side to the robot, 2 m away: width 2 atan(0.15 / 1.85)."""
    direction = math.radians(heading_deg + bearing_deg)
    at = (3 + 2 * math.cos(direction), 3 + 2 * math.sin(direction))
    content = scene(3, 3, heading_deg, boxes=[box("red", *at, heading_deg=heading_deg + bearing_deg)])
    (blob,) = look(make_world, content, camera_columns=5)
    assert blob.colour == "red"
    assert blob.bearing_rad == pytest.approx(math.radians(bearing_deg), abs=1e-9)
    assert blob.range_m == pytest.approx(1.85, abs=1e-6)
    assert blob.width_rad == pytest.approx(2 * math.atan(0.15 / 1.85), abs=1e-9)


def test_a_half_hidden_box_shows_its_visible_half(make_world):
    """A wall 1 m ahead covers everything to the right of the line of sight to the box's middle."""
    wall = {"wall": [[1.95, 3.0], [2.0, 3.0], [2.0, 2.0], [1.95, 2.0]]}
    (blob,) = look(make_world, scene(1, 3, boxes=[box("blue", 3, 3)], islands=wall), camera_columns=40)
    full = 2 * math.atan(0.15 / 1.85)
    assert blob.width_rad == pytest.approx(full / 2, abs=full / 40)
    assert blob.bearing_rad == pytest.approx(full / 4, abs=full / 40)
    assert blob.range_m == pytest.approx(1.85, abs=1e-3)


@pytest.mark.parametrize("camera", ["geometry", "rendered"])
def test_a_box_behind_a_wall_is_not_seen(make_world, camera):
    wall = {"wall": [[2.0, 2.0], [2.05, 2.0], [2.05, 4.0], [2.0, 4.0]]}
    assert look(make_world, scene(1, 3, boxes=[box("red", 3, 3)], islands=wall), camera=camera) == ()


@pytest.mark.parametrize("camera", ["geometry", "rendered"])
def test_a_box_outside_the_field_of_view_is_not_seen(make_world, camera):
    content = scene(3, 3, boxes=[box("red", 3, 5), box("red", 1, 3), box("blue", 3, 1)])
    assert look(make_world, content, camera=camera) == ()


def test_at_the_edge_of_the_view_only_the_part_inside_counts(make_world):
    """The box's middle lies on the left edge of the view of 60 degrees."""
    at = (1 + 2 * math.cos(math.radians(30)), 3 + 2 * math.sin(math.radians(30)))
    (blob,) = look(make_world, scene(1, 3, boxes=[box("red", *at, heading_deg=30)]), camera_fov_deg=60)
    half = math.atan(0.15 / 1.85)
    assert blob.width_rad == pytest.approx(half, abs=1e-9)
    assert blob.bearing_rad == pytest.approx(math.radians(30) - half / 2, abs=1e-9)


@pytest.mark.parametrize("camera", ["geometry", "rendered"])
def test_what_is_out_of_range_is_not_seen(make_world, camera):
    content = scene(1, 3, boxes=[box("red", 5, 3)])
    assert look(make_world, content, camera=camera, camera_range_m=3.8) == ()
    assert len(look(make_world, content, camera=camera, camera_range_m=3.9)) == 1


def test_only_red_and_blue_are_reported_and_the_nearest_comes_first(make_world):
    boxes = [box("red", 5, 3.5), box("yellow", 3, 3), box("green", 3, 2), box("blue", 4, 4)]
    assert [blob.colour for blob in look(make_world, scene(1, 3.5, boxes=boxes))] == ["blue", "red"]


def test_a_box_of_another_colour_hides_what_is_behind_it(make_world):
    assert look(make_world, scene(1, 3, boxes=[box("yellow", 2, 3), box("red", 4, 3, 0.1)])) == ()


@pytest.mark.parametrize("camera", ["geometry", "rendered"])
def test_a_robot_is_seen_at_its_body(make_world, camera):
    """A prey 2 m ahead that looks the same way turns 0.33 m of tail, at 1.74 m, to the learner."""
    content = scene(1, 3, others=[robot("prey", "red", 3, 3)])
    (blob,) = look(make_world, content, camera=camera)
    assert blob.bearing_rad == pytest.approx(0.0, abs=0.02)
    assert blob.range_m == pytest.approx(1.74, abs=0.01)
    assert blob.width_rad == pytest.approx(2 * math.atan(0.165 / 1.74), abs=0.02)


def test_robots_hide_each_other(make_world):
    others = [robot("predator", "blue", 2.5, 3, 90), robot("prey", "red", 4, 3)]
    assert [blob.colour for blob in look(make_world, scene(1, 3, others=others))] == ["blue"]


def test_a_box_is_seen_from_so_near_that_the_camera_almost_touches_it(make_world):
    (blob,) = look(make_world, scene(3, 3, boxes=[box("red", 3.34, 3)]))
    assert blob.range_m == pytest.approx(0.19, abs=1e-3)


def test_both_cameras_see_the_same(make_world):
    options = {"camera_range_m": 30.0, "camera_columns": 64}
    worlds = [make_world("cave-box", camera=camera, **options) for camera in ("geometry", "rendered")]
    for world in worlds:
        world.reset(1)
    compared = 0
    for _ in range(60):
        rays, image = (world.step(forward(0.5)).state.blobs for world in worlds)
        for one in (blob for blob in rays if blob.width_rad > 0.04):
            same = [
                other
                for other in image
                if other.colour == one.colour
                and other.bearing_rad == pytest.approx(one.bearing_rad, abs=0.02)
                and other.range_m == pytest.approx(one.range_m, abs=0.05)
                and other.width_rad == pytest.approx(one.width_rad, abs=0.03)
            ]
            assert len(same) == 1
            compared += 1
    assert compared > 40


def test_a_thing_all_round_a_corner_of_the_view_keeps_finite_numbers():
    camera = BlobCamera(math.radians(170), 8.0, 3)
    for turn in range(0, 360, 15):
        thing = Rectangle("red", 0.0, 0.6, math.cos(math.radians(turn)), math.sin(math.radians(turn)), 0.5, 0.05)
        for view in camera.look(Pose(0.0, 0.0, math.radians(turn)), [thing]).views:
            assert all(0.0 <= surface <= 8.0 for surface in view.surface_m)
            assert 0.0 < view.column_rad * 3 <= math.radians(170)
