"""What a film is drawn on: the world from above in pixels."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.path import Path as Outline
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from tutorstudent.core.world import Point, Sketch
from tutorstudent.study.palette import FLOOR, MAP_COLOURS, WALL

WIDTH_PX, HEAD_PX, MARGIN_PX = 480, 46, 10
FINER = 2
"""Frames are drawn this many times larger and made smaller, so that lines are smooth."""
HIGHEST_PX = 640


class View(NamedTuple):
    """Where metres stand on a frame, counted in fine pixels."""

    fine_px_per_m: float
    left_m: float
    top_m: float
    size: tuple[int, int]
    """Of the fine frame."""

    def at(self, x_m: float, y_m: float) -> Point:
        """Return the place of a point."""
        margin = FINER * MARGIN_PX
        x = margin + (x_m - self.left_m) * self.fine_px_per_m
        return x, margin + FINER * HEAD_PX + (self.top_m - y_m) * self.fine_px_per_m


def view(sketch: Sketch, way: NDArray[np.float64]) -> View:
    """Return a view that holds the world and the way through it, shape (n, 2), metres."""
    points = np.array([point for outline, _ in sketch.polygons for point in outline], dtype=np.float64).reshape(-1, 2)
    discs = [(x + side * radius, y + side * radius) for (x, y), radius, _ in sketch.discs for side in (-1, 1)]
    every = np.concatenate([points, np.reshape(discs, (-1, 2)), way])
    (left, bottom), (right, top) = np.nanmin(every, axis=0), np.nanmax(every, axis=0)
    width_m, height_m = max(right - left, 1e-3), max(top - bottom, 1e-3)
    room = WIDTH_PX - 2 * MARGIN_PX
    scale = min(room / width_m, (HIGHEST_PX - 2 * MARGIN_PX) / height_m)
    height_px = math.ceil(height_m * scale) + 2 * MARGIN_PX + HEAD_PX
    spare_m = (room / scale - width_m) / 2
    size = (FINER * WIDTH_PX, FINER * height_px)
    return View(FINER * scale, float(left) - spare_m, float(top), size)


def stage(sketch: Sketch, seen: View) -> Image.Image:
    """Return a fine frame with the world alone; robots, which do not stay where they begin, are outlines."""
    image = Image.new("RGB", seen.size, FLOOR)
    draw = ImageDraw.Draw(image)
    draw.rectangle((0, 0, seen.size[0], FINER * HEAD_PX), fill="white")
    for outline, colour in sketch.polygons:
        _draw_outline(draw, [seen.at(*point) for point in outline], colour, moves=_is_robot(outline, sketch))
    for (x_m, y_m), radius_m, colour in sketch.discs:
        (x, y), radius = seen.at(x_m, y_m), radius_m * seen.fine_px_per_m
        draw.ellipse((x - radius, y - radius, x + radius, y + radius), fill=MAP_COLOURS.get(colour, WALL))
    return image


def _draw_outline(draw: ImageDraw.ImageDraw, points: Sequence[Point], colour: str, *, moves: bool) -> None:
    body = MAP_COLOURS.get(colour)
    if body and not moves:
        draw.polygon(points, fill=body)
    else:
        draw.line([*points, points[0]], fill=body or WALL, width=FINER if moves else FINER + 1, joint="curve")


def _is_robot(outline: Sequence[Point], sketch: Sketch) -> bool:
    # The outline of a whole arena holds poses too; a robot's is no larger than a metre or so.
    size_m = np.ptp(np.asarray(outline), axis=0).max()
    path = Outline(np.asarray(outline))
    return bool(size_m < 1.5 and any(path.contains_point((x, y)) for x, y, _, _ in sketch.poses))
