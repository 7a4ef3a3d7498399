"""Occupancy maps as ROS's map_server writes them: a YAML file beside a PGM or PNG image."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, model_validator

from tutorstudent.core.files.yamlfile import read_yaml
from tutorstudent.core.roles.world import Point
from tutorstudent.sims.pioneer.checking import validate
from tutorstudent.sims.pioneer.images import read_grey
from tutorstudent.sims.pioneer.scene import Spec
from tutorstudent.sims.pioneer.scene_files import find_beside

Cells = NDArray[np.bool_]
Corner = tuple[int, int]


class RosMapFile(Spec):
    """The YAML file of a map; the names are map_server's."""

    image: str
    resolution: float = Field(gt=0, description="m per pixel")
    origin: tuple[float, float, float] = Field(description="x (m), y (m), yaw (rad) of the lower left corner")
    negate: Literal[0, 1] = 0
    occupied_thresh: float = Field(0.65, ge=0, le=1)
    free_thresh: float = Field(0.196, ge=0, le=1)
    mode: Literal["trinary", "scale"] = "trinary"

    @model_validator(mode="after")
    def _check_order(self) -> RosMapFile:
        if self.free_thresh > self.occupied_thresh:
            raise ValueError("free_thresh is above occupied_thresh")
        return self


def read_ros_map(path: Path) -> tuple[list[Point], list[list[Point]]]:
    """Return the outline of the whole map and the outlines of what is occupied, in metres.

    Occupied is what is darker than ``occupied_thresh``; unknown cells are free. Choice: the map's edge is a wall.
    """
    document = read_yaml(path)
    spec = validate(RosMapFile, document)
    grey = read_grey(find_beside(document, ("image",), spec.image))
    shade = grey / 255.0 if spec.negate else 1.0 - grey / 255.0
    cells = (shade > spec.occupied_thresh)[::-1]
    height, width = cells.shape
    whole = [(0, 0), (width, 0), (width, height), (0, height)]
    return _make_metres(whole, spec), [_make_metres(loop, spec) for loop in find_outlines(cells)]


def find_outlines(cells: Cells) -> list[list[Corner]]:
    """Return the closed outlines of the true cells, each corner once, in cells; row 0 is the lowest.

    Outer outlines run counter-clockwise, holes clockwise. Cells that only share a corner are not joined.
    """
    following = _find_edges(cells)
    loops = []
    while following:
        loop = list(_follow_loop(following))
        loops.append([here for before, here, after in _walk_round(loop) if _bends(before, here, after)])
    return loops


def _find_edges(cells: Cells) -> dict[Corner, list[Corner]]:
    """Return, for each corner, where the outline goes from there, the occupied cell on its left."""
    padded = np.pad(cells, 1)
    inner = padded[1:-1, 1:-1]
    sides = (
        (padded[:-2, 1:-1], (0, 0), (1, 0)),
        (padded[1:-1, 2:], (1, 0), (1, 1)),
        (padded[2:, 1:-1], (1, 1), (0, 1)),
        (padded[1:-1, :-2], (0, 1), (0, 0)),
    )
    following: dict[Corner, list[Corner]] = {}
    for neighbour, (a, b), (c, d) in sides:
        for y, x in np.argwhere(inner & ~neighbour).tolist():
            following.setdefault((x + a, y + b), []).append((x + c, y + d))
    return following


def _follow_loop(following: dict[Corner, list[Corner]]) -> Iterator[Corner]:
    """Take one closed outline out of the edges; where two meet, turn left so as to stay with the same cell."""
    first = here = next(iter(following))
    before = here
    while True:
        choices = following[here]
        after = max(choices, key=lambda corner: _cross(before, here, corner))
        choices.remove(after)
        if not choices:
            del following[here]
        yield here
        before, here = here, after
        if here == first:
            return


def _walk_round(loop: list[Corner]) -> Iterator[tuple[Corner, Corner, Corner]]:
    for i, here in enumerate(loop):
        yield loop[i - 1], here, loop[(i + 1) % len(loop)]


def _bends(before: Corner, here: Corner, after: Corner) -> bool:
    return _cross(before, here, after) != 0


def _cross(before: Corner, here: Corner, after: Corner) -> int:
    return (here[0] - before[0]) * (after[1] - here[1]) - (here[1] - before[1]) * (after[0] - here[0])


def _make_metres(corners: list[Corner], spec: RosMapFile) -> list[Point]:
    x0, y0, yaw = spec.origin
    cos, sin = math.cos(yaw) * spec.resolution, math.sin(yaw) * spec.resolution
    return [(x0 + x * cos - y * sin, y0 + x * sin + y * cos) for x, y in corners]
