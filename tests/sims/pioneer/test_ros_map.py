"""ROS maps against the polygons that they were drawn from."""

from __future__ import annotations

import io
import re
from collections.abc import Callable

import numpy as np
import pytest
from PIL import Image

from tests.sims.pioneer.scenes import EXACT, STOP, box, scene
from tests.sims.pioneer.test_scenes import within
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.sims.pioneer import ros_map
from tutorstudent.sims.pioneer.layout import load_layout
from tutorstudent.sims.pioneer.mesh import area
from tutorstudent.sims.pioneer.outlines import count_corners, find_outlines
from tutorstudent.sims.pioneer.ros_map import read_ros_map

RESOLUTION = 0.02


def drawn(layout, side_m):
    """Return the islands as a map: black on white, top row first."""
    at = np.arange(RESOLUTION / 2, side_m, RESOLUTION)
    points = np.stack(np.meshgrid(at, at), axis=-1).reshape(-1, 2)
    solid = np.zeros(len(points), dtype=bool)
    for island in layout.islands:
        solid |= within(points, island)
    return np.where(solid, 0, 254).astype(np.uint8).reshape(len(at), len(at))[::-1]


def pgm(grey, magic="P5"):
    header = f"{magic}\n# a comment\n{grey.shape[1]} {grey.shape[0]}\n255\n".encode()
    return header + (grey.tobytes() if magic == "P5" else " ".join(map(str, grey.ravel())).encode())


def png(pixels):
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "PNG")
    return file.getvalue()


@pytest.fixture
def write_map(tmp_path, write_yaml) -> Callable[..., str]:
    """Return a function that writes an image and its YAML and returns the scene's `walls`."""

    def write(image, name="map.pgm", **changes):
        if image is not None:
            (tmp_path / name).write_bytes(image)
        spec = {"image": name, "resolution": RESOLUTION, "origin": [0.0, 0.0, 0.0], "negate": 0}
        spec |= {"occupied_thresh": 0.65, "free_thresh": 0.196}
        return write_yaml(spec | changes)

    return write


@pytest.mark.parametrize("write_image", [pgm, png])
def test_a_robot_reads_the_same_ranges_in_a_map_as_among_the_polygons_it_shows(make_world, write_map, write_image):
    layout = load_layout("cave-box", 10.0)
    walls = {"ros_map": write_map(write_image(drawn(layout, 10.0))).name}
    arena = [[0, 0], [10, 0], [10, 10], [0, 10]]
    islands = {str(i): [list(point) for point in island] for i, island in enumerate(layout.islands)}
    close = total = 0
    for x, y, heading in ((1, 1, 45), (5, 2, 10), (1, 5, 90), (9, 8.5, 200), (3.7, 6, 300)):
        exact = make_world(scene(x, y, heading, arena=arena, islands=islands), **EXACT).reset(1).sonar_m
        mapped = make_world(scene(x, y, heading, walls=walls), **EXACT).reset(1).sonar_m
        close += int(np.sum(np.abs(exact - mapped) < 3 * RESOLUTION))
        total += 16
    assert close >= total - 2  # a ray along a slanted wall may meet a step of it


def test_the_outlines_of_cells_are_closed_and_hold_exactly_the_cells():
    rng = np.random.default_rng(5)
    for _ in range(30):
        cells = rng.random((9, 12)) < 0.45
        loops = find_outlines(cells)
        assert sum(area(loop) for loop in loops) == cells.sum()
        centres = np.stack(np.meshgrid(np.arange(12) + 0.5, np.arange(9) + 0.5), axis=-1).reshape(-1, 2)
        odd = np.zeros(len(centres), dtype=bool)
        for loop in loops:
            odd ^= within(centres, loop)
        assert odd.reshape(cells.shape).tolist() == cells.tolist()


def test_a_ring_has_an_outer_outline_and_a_hole():
    cells = np.ones((3, 3), dtype=bool)
    cells[1, 1] = False
    assert sorted(area(loop) for loop in find_outlines(cells)) == [-1.0, 9.0]


def test_cells_that_share_a_corner_are_two_outlines():
    assert [area(loop) for loop in find_outlines(np.eye(2, dtype=bool))] == [1.0, 1.0]


def test_the_lower_left_pixel_lies_at_the_origin_which_may_be_turned(write_map):
    image = np.full((4, 6), 254, dtype=np.uint8)
    image[3, 0] = 0
    path = write_map(pgm(image), resolution=0.5, origin=[-1.0, 2.0, 0.0])
    arena, (pixel,) = read_ros_map(path)
    assert arena == [(-1.0, 2.0), (2.0, 2.0), (2.0, 4.0), (-1.0, 4.0)]
    assert sorted(pixel) == [(-1.0, 2.0), (-1.0, 2.5), (-0.5, 2.0), (-0.5, 2.5)]
    turned, _ = read_ros_map(write_map(pgm(image), resolution=0.5, origin=[0.0, 0.0, np.pi / 2]))
    np.testing.assert_allclose(turned, [(0, 0), (0, 3), (-2, 3), (-2, 0)], atol=1e-12)


def test_unknown_cells_are_free_and_negate_turns_black_and_white(write_map):
    image = np.full((3, 5), 254, dtype=np.uint8)
    image[1, 1], image[1, 3] = 0, 205
    assert len(read_ros_map(write_map(pgm(image)))[1]) == 1
    assert sum(area(loop) for loop in read_ros_map(write_map(pgm(image), negate=1, resolution=1.0))[1]) == 14


def test_an_image_that_is_missing(write_map):
    path = write_map(None, name="nowhere.pgm")
    with pytest.raises(PipelineError) as caught:
        read_ros_map(path)
    assert re.fullmatch(
        rf"{re.escape(str(path))}:\d+:1: image: there is no file {re.escape(str(path.parent))}/nowhere\.pgm; "
        r"give the path of one, from the folder of this file\.",
        str(caught.value),
    )


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"resolution": 0}, "resolution: input should be greater than 0, found 0."),
        ({"origin": [0, 0]}, "origin.2: this is required, but it is missing."),
        ({"mode": "grey"}, "mode: input should be 'trinary', 'scale' or 'raw', found 'grey'."),
        ({"negate": 2}, "negate: input should be 0 or 1, found 2."),
        ({"free_thresh": 0.9}, ": free_thresh is above occupied_thresh."),
        ({"mode": 3}, "mode: input should be 'trinary', 'scale' or 'raw', found 3."),
        ({"negate": "perhaps"}, "negate: input should be 0 or 1, found 'perhaps'."),
    ],
)
def test_a_broken_map_file_is_refused_with_file_and_key(write_map, change, sentence):
    path = write_map(pgm(np.zeros((2, 2), dtype=np.uint8)), **change)
    with pytest.raises(PipelineError, match=f"^{re.escape(str(path))}:") as caught:
        read_ros_map(path)
    assert sentence in str(caught.value)


def ring(side=60, thick=2):
    """Return a square room with a closed wall of black pixels round it, and white outside."""
    image = np.full((side, side), 254, dtype=np.uint8)
    image[5:-5, 5:-5] = 0
    image[5 + thick : -5 - thick, 5 + thick : -5 - thick] = 254
    return image


def mapped(path, x, y):
    return scene(x, y, walls={"ros_map": path.name})


def test_a_start_in_a_room_with_a_closed_wall_is_free(make_world, write_map):
    path = write_map(pgm(ring()), resolution=0.1)
    ranges = make_world(mapped(path, 3.0, 3.0), **EXACT).reset(1).sonar_m
    assert ranges[0] == pytest.approx(6.0 - 0.7 - 3.13, abs=0.001)  # the left sonar stands 0.13 m to the left


def test_a_pillar_in_a_room_in_a_wall_is_solid_again(make_world, write_map):
    image = ring()
    image[20:40, 20:40] = 0
    path = write_map(pgm(image), resolution=0.1)
    make_world(mapped(path, 1.3, 3.0)).reset(1)
    with pytest.raises(PipelineError, match="that is inside an island; move it"):
        make_world(mapped(path, 3.0, 3.0)).reset(1)


def test_a_start_in_the_middle_of_a_thick_wall_is_refused(make_world, write_map):
    path = write_map(pgm(ring(100, 30)), resolution=0.1)
    with pytest.raises(PipelineError, match="that is inside an island; move it"):
        make_world(mapped(path, 2.0, 5.0)).reset(1)


def test_overlapping_islands_of_a_scene_are_solid_where_they_overlap(make_world):
    islands = {"a": [[1, 1], [4, 1], [4, 5], [1, 5]], "b": [[2, 1], [5, 1], [5, 5], [2, 5]]}
    with pytest.raises(PipelineError, match="that is inside an island; move it"):
        make_world(scene(3.0, 3.0, islands=islands)).reset(1)


def room(rng):
    """Return a room with a closed wall, pillars, and a start that is 0.5 m away from all of them."""
    cells = ring(80, int(rng.integers(1, 4))) == 0
    for _ in range(6):
        y, x = rng.integers(8, 70, 2)
        cells[y : y + 4, x : x + 4] = True
    rows, columns = np.nonzero(cells)
    while True:
        x, y = rng.uniform(1.5, 6.5, 2)
        if np.hypot(columns * 0.1 + 0.05 - x, rows * 0.1 + 0.05 - y).min() > 0.5:
            return cells, x, y


@pytest.mark.parametrize("seed", range(8))
def test_every_free_place_in_a_random_room_is_a_start(make_world, write_map, seed):
    cells, x, y = room(np.random.default_rng(seed))
    path = write_map(pgm(np.where(cells, 0, 254).astype(np.uint8)[::-1]), resolution=0.1)
    make_world(mapped(path, float(x), float(y))).reset(1)


def occupied(path):
    """Return the area of what is occupied, in pixels of 1 m."""
    return sum(area(loop) for loop in read_ros_map(path)[1])


SHADES = np.array([[0, 60, 100, 101, 205, 255]], dtype=np.uint8)


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({}, 2),
        ({"mode": "scale"}, 2),
        ({"mode": "Scale"}, 2),
        ({"mode": "raw"}, 1),  # 100 percent; 101 and more are unknown, 60 is not above 65
        ({"mode": "raw", "occupied_thresh": 0.5}, 2),
        ({"negate": 1}, 2),
        *(({"negate": word}, 2) for word in ("no", "off", "false", False, "yes", "ON", True)),
        ({"occupied_thresh": 0.59}, 4),
        ({"occupied_thresh": 0.59, "negate": "no"}, 4),
        ({"occupied_thresh": 0.59, "negate": "yes"}, 2),
        ({"map_type": "occupancy", "made by": "a program"}, 2),
        ({"occupied_threshold": 0.1}, 2),
    ],
)
def test_what_is_occupied(write_map, changes, expected):
    assert occupied(write_map(pgm(SHADES), resolution=1.0, **changes)) == expected


@pytest.mark.parametrize(
    ("changes", "expected"),
    [({"mode": "trinary"}, 2), ({"mode": "scale"}, 1), ({"mode": "scale", "negate": 1}, 1)],
)
def test_transparent_pixels_are_unknown_in_scale_and_a_dark_colour_in_trinary(write_map, changes, expected):
    black, white = [0, 0, 0], [255, 255, 255]
    pixels = np.array([[[*black, 255], [*black, 0], [*white, 255], [*white, 0]]], dtype=np.uint8)
    assert occupied(write_map(png(pixels), name="map.png", resolution=1.0, **changes)) == expected


def test_a_key_that_resembles_a_missing_one_is_refused(write_map, tmp_path):
    path = write_map(pgm(SHADES))
    path.write_text(path.read_text().replace("occupied_thresh:", "occupied_threshold:"))
    with pytest.raises(PipelineError) as caught:
        read_ros_map(path)
    assert re.fullmatch(
        rf"{re.escape(str(path))}:\d+:1: occupied_threshold: this key is unknown, and 'occupied_thresh' is missing; "
        r"did you mean that\?",
        str(caught.value),
    )


def test_tabs_may_stand_wherever_they_do_not_indent(write_map):
    path = write_map(pgm(SHADES))
    path.write_text("image:\tmap.pgm\nresolution: \t 1.0\norigin:\t[0.0,\t0.0, 0.0]\t# lower left\nnegate:\t0\t\n")
    assert occupied(path) == 2


def test_a_mistake_behind_a_tab_has_its_place(write_map):
    path = write_map(pgm(SHADES))
    path.write_text("image:\tmap.pgm\nresolution:\t-1\norigin: [0, 0, 0]\n")
    with pytest.raises(PipelineError, match=r":2:1: resolution: input should be greater than 0, found -1\."):
        read_ros_map(path)


@pytest.mark.parametrize("content", ["", "[1, 2]\n", "map.pgm\n"])
def test_a_file_that_is_no_mapping_is_refused(write_map, content):
    path = write_map(pgm(SHADES))
    path.write_text(content)
    with pytest.raises(PipelineError, match="input should be a mapping of keys and values"):
        read_ros_map(path)


def test_a_checkerboard_is_refused_before_its_outlines_are_followed(write_map, monkeypatch):
    monkeypatch.setattr(ros_map, "find_outlines", None)
    board = np.indices((2000, 2000)).sum(axis=0) % 2
    path = write_map(pgm((board * 255).astype(np.uint8)))
    with pytest.raises(PipelineError) as caught:
        read_ros_map(path)
    assert str(caught.value) == (
        f"{path.parent / 'map.pgm'}: the outlines of what is occupied have 8,000,000 corners; 60,000 are allowed. "
        "Remove speckles from the image, or save it with fewer pixels and a larger 'resolution'."
    )


def test_the_corners_that_are_counted_are_the_corners_that_are_found():
    rng = np.random.default_rng(6)
    for _ in range(50):
        cells = rng.random((9, 12)) < rng.random()
        assert sum(map(len, find_outlines(cells))) == count_corners(cells)


def test_a_map_with_nearly_as_many_corners_as_are_allowed_can_be_driven_in(make_world, write_map):
    """More than one picture of pybullet's can hold."""
    image = np.full((700, 700), 254, dtype=np.uint8)
    image[::6, ::6] = 0
    image[::30, 3::30] = 0
    image[340:360, 340:360] = 254
    world = make_world(mapped(write_map(pgm(image), resolution=0.1), 35.0, 35.0), **EXACT)
    world.reset(1)
    assert len(world.step(STOP).state.sonar_m) == 16


def test_walls_and_boxes_with_too_many_corners_together_are_refused(make_world, write_map):
    image = np.full((700, 700), 254, dtype=np.uint8)
    image[::5, ::7] = 0
    path = write_map(pgm(image), resolution=0.1)
    boxes = [box("grey", 1.0, 1.0)] * 2000
    with pytest.raises(
        PipelineError, match=r"walls and boxes have 64,008 corners together; 60,000 are allowed\. Leave"
    ):
        make_world(mapped(path, 35.0, 35.0) | {"boxes": boxes}).reset(1)
