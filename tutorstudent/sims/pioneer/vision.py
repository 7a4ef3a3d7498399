"""The blob sensor: bearing, range and width of coloured things (Thesis 3.3.1), by geometry and occlusion rays.

The camera stands on the rotation centre and looks ahead. What it could see of a thing is an angle, cut to the field of
view; that angle is divided into equal columns, one ray each, and the columns whose ray reaches the thing are what it
sees.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from tutorstudent.sims.pioneer.body import Pose, Rectangle, edge_m
from tutorstudent.sims.pioneer.sonar import HEIGHT_M, SKIN_M
from tutorstudent.sims.pioneer.types import Blob

SHORT_M = 0.01
"""An occlusion ray ends this far before the thing's surface, so that only others can stop it."""

Point3 = tuple[float, float, float]


class View(NamedTuple):
    """What could be seen of one thing if nothing stood before it."""

    colour: str
    right_rad: float
    """Bearing of the first column's right edge."""
    column_rad: float
    surface_m: tuple[float, ...]
    """Distance to the surface along the middle of each column, from right to left."""


class BlobCamera:
    """Geometry of the camera.

    Args:
        field_of_view_rad: Full opening angle.
        range_m: How far it sees.
        columns: Rays for each thing.
    """

    def __init__(self, field_of_view_rad: float, range_m: float, columns: int) -> None:
        self._half_rad = field_of_view_rad / 2
        self._range_m = range_m
        self.columns = columns

    def views(self, pose: Pose, things: Iterable[Rectangle]) -> list[View]:
        """Return the things that are in range and in the field of view."""
        return [view for thing in things if (view := self._view(pose, thing)) is not None]

    def rays(self, pose: Pose, views: Iterable[View]) -> tuple[list[Point3], list[Point3]]:
        """Return start and end points of one ray for each column of each view."""
        starts: list[Point3] = []
        ends: list[Point3] = []
        for view in views:
            for i, surface in enumerate(view.surface_m):
                bearing = view.right_rad + (i + 0.5) * view.column_rad
                near = edge_m(0.0, 0.0, math.cos(bearing), math.sin(bearing)) + SKIN_M
                starts.append(_point(pose, bearing, near))
                ends.append(_point(pose, bearing, max(surface - SHORT_M, near + SKIN_M)))
        return starts, ends

    def blobs(self, views: Iterable[View], fractions: Sequence[float]) -> tuple[Blob, ...]:
        """Return what is seen, nearest first, from the travelled fractions of the rays, 1 for a free one."""
        found: list[Blob] = []
        at = 0
        for view in views:
            seen = [i for i in range(self.columns) if fractions[at + i] >= 1.0]
            at += self.columns
            if seen:
                found.append(_blob(view, seen))
        found.sort(key=_range)
        return tuple(found)

    def _view(self, pose: Pose, thing: Rectangle) -> View | None:
        dx, dy = thing.x_m - pose.x_m, thing.y_m - pose.y_m
        radius = thing.half_length_m + thing.half_width_m
        reach = self._range_m + radius
        if dx * dx + dy * dy > reach * reach:
            return None
        middle = math.remainder(math.atan2(dy, dx) - pose.heading_rad, math.tau)
        right, left = _extent(dx, dy, thing)
        right, left = max(middle + right, -self._half_rad), min(middle + left, self._half_rad)
        if right >= left:
            return None
        column = (left - right) / self.columns
        bearings = [right + (i + 0.5) * column for i in range(self.columns)]
        surface = tuple(_surface_m(dx, dy, thing, pose.heading_rad + bearing) for bearing in bearings)
        return View(thing.colour, right, column, surface) if min(surface) <= self._range_m else None


def _extent(dx: float, dy: float, thing: Rectangle) -> tuple[float, float]:
    """Return the bearings of the thing's right and left edge from that of its centre, seen from the origin."""
    right = left = 0.0
    along_x, along_y = thing.cos * thing.half_length_m, thing.sin * thing.half_length_m
    across_x, across_y = -thing.sin * thing.half_width_m, thing.cos * thing.half_width_m
    for i, j in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        x = dx + i * along_x + j * across_x
        y = dy + i * along_y + j * across_y
        bearing = math.atan2(dx * y - dy * x, dx * x + dy * y)
        right, left = min(right, bearing), max(left, bearing)
    return right, left


def _surface_m(dx: float, dy: float, thing: Rectangle, direction: float) -> float:
    """Return the distance from the origin to the thing's surface along a direction that meets it."""
    cos, sin = math.cos(direction), math.sin(direction)
    near = 0.0
    for offset, slope, half in (
        (dx * thing.cos + dy * thing.sin, cos * thing.cos + sin * thing.sin, thing.half_length_m),
        (dy * thing.cos - dx * thing.sin, sin * thing.cos - cos * thing.sin, thing.half_width_m),
    ):
        if abs(slope) > 1e-12:
            near = max(near, offset / slope - half / abs(slope))
    return near


def _point(pose: Pose, bearing: float, distance: float) -> Point3:
    direction = pose.heading_rad + bearing
    return (pose.x_m + distance * math.cos(direction), pose.y_m + distance * math.sin(direction), HEIGHT_M)


def _blob(view: View, seen: Sequence[int]) -> Blob:
    middle = view.right_rad + (sum(seen) / len(seen) + 0.5) * view.column_rad
    return Blob(view.colour, middle, min(view.surface_m[i] for i in seen), len(seen) * view.column_rad)


def _range(blob: Blob) -> float:
    return blob.range_m
