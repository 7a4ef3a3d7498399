"""Shipped scenes: they load, what they hold is the thesis's, and a robot can get everywhere."""

from __future__ import annotations

import math
from collections import Counter

import numpy as np
import pytest
from scipy import ndimage

from tests.sims.pioneer.scenes import EXACT, box, scene
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.sims.pioneer.layout import load_layout
from tutorstudent.sims.pioneer.mesh import area
from tutorstudent.sims.pioneer.scene_files import list_scenes

SCENES = ["cave-box", "cave-predator-prey", "cave-predator-prey-box", "chase-avoid"]
CAVES = SCENES[:3]
CELL_M = 0.05


def segments(layout):
    """Return the sides of everything solid, shape (n, 2, 2)."""
    outlines = [layout.arena, *layout.islands, *(item.corners() for item in layout.boxes)]
    sides = [(a, b) for outline in outlines for a, b in zip(outline, [*outline[1:], outline[0]], strict=True)]
    return np.array(sides)


def distances(points, sides):
    """Return the distance from each point to the nearest side."""
    a, along = sides[:, 0], sides[:, 1] - sides[:, 0]
    least = np.full(len(points), np.inf)
    for start, way in zip(a, along, strict=True):
        share = np.clip(((points - start) @ way) / (way @ way), 0.0, 1.0)
        least = np.minimum(least, np.hypot(*(points - start - share[:, None] * way).T))
    return least


def within(points, outline):
    """Return which points lie inside a closed outline, by counting crossings to the right."""
    x, y = points.T
    odd = np.zeros(len(points), dtype=bool)
    for (x0, y0), (x1, y1) in zip(outline, [*outline[1:], outline[0]], strict=True):
        if y0 != y1:
            odd ^= ((y0 > y) != (y1 > y)) & (x < x0 + (y - y0) * (x1 - x0) / (y1 - y0))
    return odd


def free_cells(layout, radius_m):
    """Return the cells, by row and column, where a disc fits: an independent check on a grid."""
    low, high = np.min(layout.arena, axis=0), np.max(layout.arena, axis=0)
    x, y = (np.arange(a + CELL_M / 2, b, CELL_M) for a, b in zip(low, high, strict=True))
    points = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    free = within(points, layout.arena)
    for solid in (*layout.islands, *(item.corners() for item in layout.boxes)):
        free &= ~within(points, solid)
    free[free] = distances(points[free], segments(layout)) > radius_m
    return free.reshape(len(y), len(x))


def test_the_four_environments_of_the_thesis_are_shipped():
    assert list_scenes() == SCENES


@pytest.mark.parametrize(
    ("name", "boxes", "robots"),
    [
        ("chase-avoid", {}, {"learner": 1, "prey": 1, "predator": 1}),
        ("cave-box", {"red": 3, "blue": 3}, {"learner": 1}),
        ("cave-predator-prey", {}, {"learner": 1, "prey": 2, "predator": 1}),
        ("cave-predator-prey-box", {"red": 3, "blue": 3}, {"learner": 1, "prey": 2, "predator": 1}),
    ],
)
def test_each_environment_holds_what_the_thesis_says(name, boxes, robots):
    """Thesis 4.3.2 to 4.3.5: attractors are red, repulsers are blue."""
    layout = load_layout(name)
    assert Counter(item.colour for item in layout.boxes) == boxes
    assert Counter(robot.controller for robot in layout.robots) == robots
    colours = {"prey": "red", "predator": "blue", "learner": "green"}
    assert all(robot.colour == colours[robot.controller] for robot in layout.robots)


@pytest.mark.parametrize("name", SCENES)
def test_every_start_is_free_and_the_world_runs(make_world, name):
    world = make_world(name)
    world.reset(1)
    assert len(world.sketch().poses) == len(load_layout(name).robots)


@pytest.mark.parametrize("side_m", [10.0, 15.0, 16.0])
@pytest.mark.parametrize("name", ["cave-box", "cave-predator-prey"])
def test_the_free_space_of_a_cave_is_one_piece_for_a_disc_of_35_centimetres(name, side_m):
    free = free_cells(load_layout(name, side_m), 0.35)
    labels, _ = ndimage.label(free, structure=np.ones((3, 3)))
    _, *sizes = np.sort(np.bincount(labels.flat)[1:])[::-1]
    assert sum(sizes) <= 1  # at 10 m the disc also fits, within a cell, between a box and the corner island
    assert free.sum() * CELL_M**2 > 0.3 * side_m**2


def test_the_rink_is_a_circle_of_nearly_four_metres():
    arena = np.array(load_layout("chase-avoid").arena)
    radii = np.hypot(*(arena - (2.015, 2.02)).T)
    assert radii == pytest.approx(np.full(128, 1.975), abs=1e-3)


def test_the_cave_has_seven_islands_that_cover_nearly_a_quarter():
    layout = load_layout("cave-box", 10.0)
    assert len(layout.islands) == 7
    assert sum(abs(area(island)) for island in layout.islands) == pytest.approx(23.6, abs=1.0)


def test_the_narrowest_passage_of_the_cave_is_as_wide_as_it_should_be():
    """Between the peninsula and the lower middle island: 45 of 500 pixels."""
    islands = load_layout("cave-box", 10.0).islands
    sides = np.array([(a, b) for a, b in zip(islands[3], [*islands[3][1:], islands[3][0]], strict=True)])
    ends = np.array(islands[5])
    along = np.concatenate([ends + (np.roll(ends, -1, axis=0) - ends) * share for share in np.linspace(0, 1, 50)])
    assert distances(along, sides).min() == pytest.approx(0.90, abs=0.05)


@pytest.mark.parametrize("name", CAVES)
def test_a_cave_can_be_scaled(name):
    small, large = load_layout(name, 10.0), load_layout(name)
    assert np.array(large.arena) == pytest.approx(1.5 * np.array(small.arena))
    assert [tuple(start)[:2] for start in large.starts] == [
        pytest.approx((1.5 * start.x_m, 1.5 * start.y_m)) for start in small.starts
    ]


def test_boxes_can_be_given_another_size():
    assert {item.half_length_m for item in load_layout("cave-box").boxes} == {0.15}
    assert {item.half_length_m for item in load_layout("cave-box", box_side_m=1.0).boxes} == {0.5}


def test_the_boxes_of_a_scene_can_be_moved_in_their_order_and_in_the_scene_s_units():
    places = [(10.0 * i, 50.0) for i in range(6)]
    moved, own = load_layout("cave-box", box_places=places).boxes, load_layout("cave-box").boxes

    assert [1.5 * i for i in range(6)] == pytest.approx([box.x_m for box in moved])
    assert {7.5} == {box.y_m for box in moved}
    assert [box.colour for box in own] == [box.colour for box in moved]


def test_a_scene_without_boxes_stays_as_it_is_wherever_boxes_are_moved_to():
    assert () == load_layout("chase-avoid", box_places=[(1.0, 1.0)]).boxes


def test_moving_boxes_wants_a_place_for_each():
    with pytest.raises(PipelineError, match=r"'box_places' has 1 places, but .*cave-box.yaml has 6 boxes; give one"):
        load_layout("cave-box", box_places=[(1.0, 1.0)])


def test_a_scene_in_metres_cannot_be_scaled(make_world):
    with pytest.raises(PipelineError, match=r"'side_m' scales scenes in percent, but .*chase-avoid\.yaml is in metres"):
        make_world("chase-avoid", side_m=10.0).reset(1)


def test_a_turned_box_is_solid_where_it_stands(make_world):
    """A box of 1 m turned by 45 degrees points a corner at the robot."""
    content = scene(2, 3, boxes=[box("grey", 4, 3, 1.0, 45)])
    state = make_world(content, **EXACT).reset(1)
    assert state.sonar_m[3] * math.cos(math.radians(10)) > 2 - math.sqrt(0.5) - 0.21
    assert state.sonar_m[3] < 2 - math.sqrt(0.5) + 0.1


def test_sketch_draws_walls_boxes_and_robots_in_metres(make_world):
    world = make_world("cave-predator-prey-box")
    world.reset(1)
    sketch = world.sketch()
    assert Counter(colour for _, colour in sketch.polygons) == {"black": 8, "red": 5, "blue": 4, "green": 1}
    assert sketch.poses[0] == pytest.approx((1.5, 1.5, math.pi / 4, "green"))
    outer = np.array(sketch.polygons[0][0])
    assert (outer.min(), outer.max()) == (0.0, 15.0)
