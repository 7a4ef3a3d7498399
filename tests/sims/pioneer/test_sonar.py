"""Sonar ranges against closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.sims.pioneer.scenes import EXACT, STOP, robot, scene
from tutorstudent.sims.pioneer.sonar import SONARS, ReadNoise

HEADINGS = (0.0, 7.0, 45.0, 101.0, 180.0, 263.0, 359.0)


def rays(x, y, heading_deg):
    """Yield origin and unit direction of each sonar of a robot at a pose, by the published table alone."""
    turn = math.radians(heading_deg)
    for forward, left, yaw in SONARS:
        origin = (
            x + forward * math.cos(turn) - left * math.sin(turn),
            y + forward * math.sin(turn) + left * math.cos(turn),
        )
        yield origin, (math.cos(turn + math.radians(yaw)), math.sin(turn + math.radians(yaw)))


def to_circle(origin, direction, radius):
    along = origin[0] * direction[0] + origin[1] * direction[1]
    return -along + math.sqrt(along**2 - origin[0] ** 2 - origin[1] ** 2 + radius**2)


def to_square(origin, direction, side):
    reaches = []
    for at, step in zip(origin, direction, strict=True):
        if step > 1e-12:
            reaches.append((side - at) / step)
        elif step < -1e-12:
            reaches.append(-at / step)
    return min(reaches)


def test_the_ring_is_symmetric_and_looks_as_the_state_says():
    for front, mirror in enumerate(reversed(range(8))):
        assert SONARS[front][0] == SONARS[mirror][0]
        assert SONARS[front][1] == -SONARS[mirror][1]
        assert SONARS[front][2] == -SONARS[mirror][2]
    assert SONARS[0][2] == 90.0
    assert [SONARS[3][2], SONARS[4][2]] == [10.0, -10.0]
    assert SONARS[7][2] == -90.0


@pytest.mark.parametrize("heading_deg", HEADINGS)
@pytest.mark.parametrize("radius", [0.4, 1.975, 4.0])
def test_in_the_middle_of_a_circle_every_sonar_reads_its_distance_to_it(make_world, heading_deg, radius):
    arena = {"centre": [0.0, 0.0], "radius": radius}
    state = make_world(scene(0.0, 0.0, heading_deg, arena=arena), **EXACT).reset(1)
    expected = [to_circle(origin, direction, radius) for origin, direction in rays(0.0, 0.0, heading_deg)]
    np.testing.assert_allclose(state.sonar_m, expected, atol=1e-3)


@pytest.mark.parametrize("heading_deg", HEADINGS)
@pytest.mark.parametrize(("x", "y"), [(3.0, 3.0), (0.5, 3.3), (5.2, 0.8)])
def test_at_straight_walls_every_sonar_reads_the_distance_along_its_direction(make_world, heading_deg, x, y):
    state = make_world(scene(x, y, heading_deg), **EXACT).reset(1)
    expected = [min(5.0, to_square(origin, direction, 6.0)) for origin, direction in rays(x, y, heading_deg)]
    np.testing.assert_allclose(state.sonar_m, expected, atol=1e-4)


@pytest.mark.parametrize("heading_deg", range(0, 360, 24))
def test_no_sonar_ever_meets_its_own_robot(make_world, heading_deg):
    arena = [[-20, -20], [20, -20], [20, 20], [-20, 20]]
    assert make_world(scene(0.3, -0.4, heading_deg, arena=arena), **EXACT).reset(1).sonar_m.tolist() == [5.0] * 16


def test_a_robot_is_met_at_its_body_whose_centre_is_behind_its_rotation_centre(make_world):
    """A robot 1 m ahead that looks the same way: its tail is 0.26 m behind its rotation centre."""
    world = make_world(scene(1.0, 3.0, others=[robot("prey", "red", 2.0, 3.0)]), **EXACT)
    ahead = (1.0 - 0.26 - 0.210) / math.cos(math.radians(10.0))
    assert world.reset(1).sonar_m[3:5] == pytest.approx([ahead, ahead], abs=1e-4)


def test_a_wall_hides_what_is_behind_it(make_world):
    thin = {"thin": [[2.0, 1.0], [2.01, 1.0], [2.01, 5.0], [2.0, 5.0]]}
    state = make_world(scene(1.0, 3.0, islands=thin), **EXACT).reset(1)
    expected = (1.0 - 0.210) / math.cos(math.radians(10.0))
    assert state.sonar_m[3] == pytest.approx(expected, abs=1e-4)


def test_a_front_sonar_that_stands_in_the_wall_reads_zero_and_not_what_is_behind_it(make_world):
    """The front sonars stand 3 cm before the body; the body is 1 cm from the wall."""
    state = make_world(scene(6.0 - 0.18 - 0.01, 3.0), **EXACT).reset(1)
    assert state.sonar_m[3:5].tolist() == [0.0, 0.0]


def test_the_range_ends_where_the_option_says(make_world):
    arena = {"centre": [0.0, 0.0], "radius": 4.0}
    world = make_world(scene(0.0, 0.0, arena=arena), **EXACT, sonar_range_m=2.5)
    assert world.reset(1).sonar_m.tolist() == [2.5] * 16


def test_read_noise_is_a_fresh_uniform_share_at_each_read_and_never_exceeds_the_range(make_world):
    arena = {"centre": [0.0, 0.0], "radius": 3.0}
    exact = make_world(scene(0.0, 0.0, arena=arena), **EXACT).reset(1).sonar_m
    world = make_world(scene(0.0, 0.0, arena=arena), **EXACT | {"sonar_noise": 0.05})
    world.reset(1)
    shares = np.array([world.step(STOP).state.sonar_m / exact - 1.0 for _ in range(400)])
    assert np.abs(shares).max() <= 0.05
    assert np.abs(shares.mean()) < 0.002
    assert shares.std() == pytest.approx(0.05 / math.sqrt(3.0), rel=0.05)
    assert len(np.unique(shares[:, 0])) == 400


def test_noise_never_lifts_a_reading_above_the_largest_range():
    noise = ReadNoise(0.5, 3, 5.0, [np.random.default_rng(0)])
    reads = np.array([noise.read(np.array([[5.0, 4.0, 0.0]]))[0] for _ in range(600)])
    assert reads.max() == 5.0
    assert reads[:, 2].tolist() == [0.0] * 600
