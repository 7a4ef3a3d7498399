"""The held-out scene: a map that is made again to the last byte, and a scene in which everything runs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tutorstudent_prototype2.heldout import NAMES, SCENE
from tutorstudent_prototype2.pipelines import load
from tutorstudent_prototype2.rasterize import CELLS, NAME, SCENES, cave, inside, write_map


def test_the_committed_map_is_the_one_that_is_written(tmp_path: Path) -> None:
    write_map(tmp_path)
    for suffix in ("pgm", "yaml"):
        assert (SCENES / f"{NAME}.{suffix}").read_bytes() == (tmp_path / f"{NAME}.{suffix}").read_bytes()


def test_cells_whose_centre_lies_in_a_rectangle_are_inside() -> None:
    found = inside([(10.4, 20.6), (13.6, 20.6), (13.6, 22.4), (10.4, 22.4)])
    expected = np.zeros((CELLS, CELLS), dtype=bool)
    expected[21:22, 10:14] = True  # centres at 10.5 to 13.5, and at 21.5
    assert expected.tolist() == found.tolist()


def test_a_concave_polygon_leaves_its_notch_free() -> None:
    found = inside([(0, 0), (30, 0), (30, 30), (15, 5), (0, 30)])
    assert [True, True, True, False] == [bool(found[y, x]) for y, x in ((1, 1), (20, 2), (20, 27), (20, 15))]


def test_the_area_of_the_islands_is_that_of_the_polygons() -> None:
    square = [(10.3, 10.3), (60.7, 10.3), (60.7, 90.1), (10.3, 90.1)]
    assert 50.4 * 79.8 == pytest.approx(inside(square).sum(), rel=0.02)
    assert 0.15 < cave().mean() < 0.35


@pytest.mark.parametrize("name", NAMES)
def test_everything_runs_there_unchanged(name: str) -> None:
    with load(name, str(SCENE)).replaced({"decisions": 30, "on_incident": "raise"}).built() as (engine, world, _):
        state = world.reset(0)
        engine.reset()
        way = 0.0
        for _ in range(30):
            step = world.step(engine.step(state))
            state, way = step.state, way + step.events["distance_m"]
        assert 0.2 < way
        assert not step.events["collided"]


def test_the_scene_is_a_cave_of_12_m_with_boxes_and_robots_in_it() -> None:
    with load("prototype2", str(SCENE), {}).built() as (_, world, _observers):
        world.reset(0)
        sketch = world.sketch()
    corners = np.array([point for outline, _ in sketch.polygons for point in outline])
    assert (0.0, 12.0) == (round(corners.min(), 6), round(corners.max(), 6))
    assert 4 == len(sketch.poses)
    assert [1.2, 1.2] == pytest.approx(sketch.poses[0][:2])
