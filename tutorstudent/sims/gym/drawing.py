"""Sketches as pixels, for `render`: outlines only, no drawing library."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.roles.world import Point, Sketch

SIDE = 400
"""Pixels of the picture's side."""
BORDER = 8
ARROW_M = 0.4
COLOURS: dict[str, tuple[int, int, int]] = {
    "red": (204, 51, 51),
    "blue": (51, 85, 204),
    "green": (34, 136, 68),
    "grey": (136, 136, 136),
    "black": (0, 0, 0),
}

Line = tuple[Sequence[Point], str]


def draw_picture(sketch: Sketch) -> NDArray[np.uint8]:
    """Return a sketch as an image, shape (SIDE, SIDE, 3), x to the right and y up; white where there is nothing."""
    image = np.full((SIDE, SIDE, 3), 255, dtype=np.uint8)
    lines = list(_find_lines(sketch))
    if not lines:
        return image
    points = np.array([point for line, _ in lines for point in line])
    low, extent = points.min(axis=0), max(float(np.ptp(points, axis=0).max()), 1e-9)
    scale = (SIDE - 1 - 2 * BORDER) / extent
    for line, colour in lines:
        _draw(image, (np.array(line) - low) * scale + BORDER, COLOURS.get(colour, COLOURS["black"]))
    return image


def _find_lines(sketch: Sketch) -> Iterator[Line]:
    for outline, colour in sketch.polygons:
        if len(outline):
            yield [*outline, outline[0]], colour
    for (x, y), radius, colour in sketch.discs:
        turns = [2 * math.pi * i / 32 for i in range(33)]
        yield [(x + radius * math.cos(turn), y + radius * math.sin(turn)) for turn in turns], colour
    for x, y, heading, colour in sketch.poses:
        yield [(x, y), (x + ARROW_M * math.cos(heading), y + ARROW_M * math.sin(heading))], colour


def _draw(image: NDArray[np.uint8], pixels: NDArray[np.float64], colour: tuple[int, int, int]) -> None:
    for start, end in itertools.pairwise(pixels):
        steps = int(np.abs(end - start).max()) + 2
        along = np.rint(start + (end - start) * np.linspace(0, 1, steps)[:, None]).astype(int)
        image[SIDE - 1 - along[:, 1], along[:, 0]] = colour
