"""Draws the cave at another size as a ROS `map_server` map: ``python -m tutorstudent_prototype2.rasterize``.

The islands of the shipped cave, 12 m instead of 15 m, as cells of 5 cm: staircases where there were straight walls. A
cell is occupied if its centre lies in an island; the edge of a map is a wall already.
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from ruamel.yaml import YAML

SIDE_M = 12.0
CELL_M = 0.05
CELLS = round(SIDE_M / CELL_M)
OCCUPIED, FREE = 0, 254
"""Grey values as map_server writes them."""
SCENES = Path(__file__).parent / "scenes"
NAME = "cave-12m-map"

Corners = Sequence[tuple[float, float]]
Cells = NDArray[np.bool_]


def write_map(folder: Path) -> None:
    """Write the map's image and YAML into a folder; the same bytes every time."""
    grey = np.where(cave()[::-1], OCCUPIED, FREE).astype(np.uint8)
    (folder / f"{NAME}.pgm").write_bytes(f"P5\n{CELLS} {CELLS}\n255\n".encode() + grey.tobytes())
    (folder / f"{NAME}.yaml").write_text(
        f"# Written by python -m tutorstudent_prototype2.rasterize: the shipped cave at {SIDE_M:g} m.\n"
        f"image: {NAME}.pgm\nresolution: {CELL_M:g}\norigin: [0, 0, 0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
        encoding="utf-8",
    )


def cave() -> Cells:
    """Return which cells are occupied, shape (CELLS, CELLS), the lowest row first."""
    walls = files("tutorstudent.sims.pioneer").joinpath("scenes", "maps", "cave.yaml")
    islands = YAML(typ="safe", pure=True).load(walls.read_text(encoding="utf-8"))["islands"]
    occupied = np.zeros((CELLS, CELLS), dtype=np.bool_)
    for corners in islands.values():
        occupied |= inside([(x / 100 * CELLS, y / 100 * CELLS) for x, y in corners])
    return occupied


def inside(corners: Corners) -> Cells:
    """Return which cells have their centre in a polygon, whose corners are given in cells.

    A centre is inside if a ray from it to the right crosses the outline an odd number of times.
    """
    y, x = np.mgrid[0:CELLS, 0:CELLS] + 0.5
    odd = np.zeros((CELLS, CELLS), dtype=np.bool_)
    for (x0, y0), (x1, y1) in zip(corners, [*corners[1:], corners[0]], strict=True):
        if y0 != y1:
            crosses = (y0 > y) != (y1 > y)
            odd ^= crosses & (x < x0 + (y - y0) * (x1 - x0) / (y1 - y0))
    return odd


if __name__ == "__main__":
    write_map(SCENES)
