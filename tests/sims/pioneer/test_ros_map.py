"""ROS maps against the polygons that they were drawn from."""

from __future__ import annotations

import re
import struct
import zlib
from collections.abc import Callable

import numpy as np
import pytest

from tests.sims.pioneer.scenes import EXACT, scene
from tests.sims.pioneer.test_scenes import within
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.sims.pioneer.images import read_grey
from tutorstudent.sims.pioneer.layout import load_layout
from tutorstudent.sims.pioneer.mesh import area
from tutorstudent.sims.pioneer.ros_map import find_outlines, read_ros_map

RESOLUTION = 0.02
MAP_KEYS = "Allowed: free_thresh, image, mode, negate, occupied_thresh, origin, resolution."


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


def png(pixels, filters=(0,), colour=0, depth=8):
    """Return a PNG; row i is written with filter `filters[i % len(filters)]`."""
    height, width = pixels.shape[:2]
    rows = pixels.reshape(height, -1).astype(int)
    step = rows.shape[1] // width
    padded = np.pad(rows, ((1, 0), (step, 0)))
    left, up, corner = padded[1:, :-step], padded[:-1, step:], padded[:-1, :-step]
    guess = left + up - corner
    off = [abs(guess - left), abs(guess - up), abs(guess - corner)]
    paeth = np.where((off[0] <= off[1]) & (off[0] <= off[2]), left, np.where(off[1] <= off[2], up, corner))
    guesses = (0 * rows, left, up, (left + up) // 2, paeth)
    raw = b"".join(
        bytes([filters[i % len(filters)]])
        + ((rows[i] - guesses[filters[i % len(filters)]][i]) % 256).astype(np.uint8).tobytes()
        for i in range(height)
    )
    header = struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(raw)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body)) for kind, body in chunks
    )


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


@pytest.mark.parametrize("filters", [(0,), (1,), (2,), (3,), (4,), (4, 3, 2, 1, 0)])
@pytest.mark.parametrize(("colour", "channels"), [(0, 1), (2, 3), (4, 2), (6, 4)])
def test_every_kind_of_png_row_is_read(tmp_path, filters, colour, channels):
    pixels = np.random.default_rng(3).integers(0, 256, (11, 7, channels), dtype=np.uint8)
    (tmp_path / "a.png").write_bytes(png(pixels, filters, colour))
    shades = pixels[:, :, :1] if channels < 3 else pixels[:, :, :3]
    assert read_grey(tmp_path / "a.png").tolist() == shades.mean(axis=2).astype(np.uint8).tolist()


@pytest.mark.parametrize("magic", ["P2", "P5"])
def test_both_kinds_of_pgm_are_read(tmp_path, magic):
    image = np.arange(12, dtype=np.uint8).reshape(3, 4)
    (tmp_path / "a.pgm").write_bytes(pgm(image, magic))
    assert read_grey(tmp_path / "a.pgm").tolist() == image.tolist()


GOOD = png(np.zeros((2, 2), dtype=np.uint8))


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "not a PGM or PNG image"),
        (b"GIF89a", "not a PGM or PNG image"),
        (b"P5 2 2", "not a PGM or PNG image"),
        (b"P5\n2 2\n255\n\x00", "cut short"),
        (b"P2\n2 2\n255\n0 0 0", "cut short"),
        (b"P2\n2 2\n10\n0 0 0 11", "values are too large"),
        (b"P5\n2 2\n65535\n" + bytes(8), "grey values up to 65535 are not supported"),
        (b"P5\n100000 100000\n255\n", "100000 x 100000 pixels is no size for a map"),
        (b"P5\n0 3\n255\n", "0 x 3 pixels is no size for a map"),
        (b"P5\n-2 -2\n255\n0000", "the header of a PGM has three whole numbers"),
        (GOOD.replace(b"x\x9c", b"y\x9c"), "cut short or damaged"),
        (png(np.zeros((2, 2))).replace(zlib.compress(bytes(6)), zlib.compress(b"\x09" + bytes(5))), "row filter 9"),
        (b"P2\n1 1\n255\nblack", "invalid literal"),
        (GOOD[:20], "cut short or damaged"),
        (GOOD[:-26], "cut short or damaged"),
        (png(np.zeros((2, 2)), colour=3), "colour type 3"),
        (png(np.zeros((2, 2)), depth=16), "bit depth 16"),
        (GOOD[:8] + GOOD[33:], "cut short or damaged"),
    ],
)
def test_a_broken_image_is_refused_with_what_is_supported(tmp_path, data, why):
    (tmp_path / "broken.png").write_bytes(data)
    with pytest.raises(PipelineError, match=re.escape(why)) as caught:
        read_grey(tmp_path / "broken.png")
    assert str(caught.value).startswith(f"{tmp_path / 'broken.png'}: ")
    assert "Maps are PGM (P2 or P5) or PNG (8 bit, grey or colour, not interlaced)." in str(caught.value)


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
        ({"mode": "raw"}, "mode: input should be 'trinary' or 'scale', found 'raw'."),
        ({"negate": 2}, "negate: input should be 0 or 1, found 2."),
        ({"free_thresh": 0.9}, ": free_thresh is above occupied_thresh."),
        (
            {"occupied_threshold": 0.5},
            f"occupied_threshold: unknown key (did you mean 'occupied_thresh'?). {MAP_KEYS}",
        ),
    ],
)
def test_a_broken_map_file_is_refused_with_file_and_key(write_map, change, sentence):
    path = write_map(pgm(np.zeros((2, 2), dtype=np.uint8)), **change)
    with pytest.raises(PipelineError, match=f"^{re.escape(str(path))}:") as caught:
        read_ros_map(path)
    assert sentence in str(caught.value)
