"""The blob sensor: bearing, range and width of coloured things (Thesis 3.3.1), by geometry and occlusion rays.

The camera stands on the rotation centre and looks ahead. What it could see of a thing is an angle, cut to the field of
view; that angle is divided into equal columns, one ray each, and the columns whose ray reaches the thing are what it
sees.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from tutorstudent.sims.pioneer.body import CENTRE_M, LENGTH_M, WIDTH_M, Pose, Rectangle
from tutorstudent.sims.pioneer.sonar import HEIGHT_M, INSET_M
from tutorstudent.sims.pioneer.types import Blob

SHORT_M = 0.01
"""An occlusion ray ends this far before the thing's surface, so that only others can stop it."""
FRONT_M = LENGTH_M / 2 + CENTRE_M
"""Distance from the rotation centre to the body's front."""

Point3 = tuple[float, float, float]


class View(NamedTuple):
    """What could be seen of one thing if nothing stood before it."""

    colour: str
    right_rad: float
    """Bearing of the first column's right edge."""
    column_rad: float
    surface_m: list[float]
    """Distance to the surface along the middle of each column, from right to left."""


class Sight(NamedTuple):
    """All views from a pose, with one ray for each column of each view, in their order."""

    views: list[View]
    starts: list[Point3]
    ends: list[Point3]


class _Placed(NamedTuple):
    """A rectangle in the camera's frame: centre forward and left, direction of its length."""

    forward_m: float
    left_m: float
    cos: float
    sin: float
    half_length_m: float
    half_width_m: float


class BlobCamera:
    """Geometry of the camera.

    Args:
        field_of_view_rad: Full opening angle, less than pi.
        range_m: How far it sees.
        columns: Rays for each thing.
    """

    def __init__(self, field_of_view_rad: float, range_m: float, columns: int) -> None:
        self.columns = columns
        self._half_rad = field_of_view_rad / 2
        self._cos, self._sin = math.cos(self._half_rad), math.sin(self._half_rad)
        self._range_m = range_m

    def look(self, pose: Pose, things: Iterable[Rectangle]) -> Sight:
        """Return the things that are in range and in the field of view, and the rays that tell what is hidden."""
        x, y, heading = pose
        cos, sin = math.cos(heading), math.sin(heading)
        sight = Sight([], [], [])
        for thing in things:
            dx, dy = thing.x_m - x, thing.y_m - y
            forward, left = dx * cos + dy * sin, dy * cos - dx * sin
            if self._may_see(forward, left, thing.half_length_m + thing.half_width_m):
                along, across = thing.cos * cos + thing.sin * sin, thing.sin * cos - thing.cos * sin
                placed = _Placed(forward, left, along, across, thing.half_length_m, thing.half_width_m)
                self._add(sight, thing.colour, placed, (x, y, cos, sin))
        return sight

    def make_blobs(self, sight: Sight, fractions: Sequence[float]) -> tuple[Blob, ...]:
        """Return what is seen, nearest first, from the travelled fractions of the rays, 1 for a free one."""
        found: list[Blob] = []
        columns = self.columns
        for at, view in enumerate(sight.views):
            first = at * columns
            seen = [i for i in range(columns) if fractions[first + i] >= 1.0]
            if seen:
                found.append(_make_blob(view, seen))
        found.sort(key=_read_range)
        return tuple(found)

    def _may_see(self, forward: float, left: float, radius: float) -> bool:
        """Return whether a disc reaches into the range and the wedge of the field of view."""
        reach = self._range_m + radius
        in_range = forward * forward + left * left <= reach * reach
        return in_range and abs(left) * self._cos - forward * self._sin <= radius

    def _add(self, sight: Sight, colour: str, thing: _Placed, camera: tuple[float, float, float, float]) -> None:
        right, left = _find_extent(thing)
        right, left = max(right, -self._half_rad), min(left, self._half_rad)
        if right >= left:
            return
        column = (left - right) / self.columns
        rays = [_make_ray(thing, right + (i + 0.5) * column, camera) for i in range(self.columns)]
        surface_m = [ray[0] for ray in rays]
        if min(surface_m) <= self._range_m:
            sight.views.append(View(colour, right, column, surface_m))
            sight.starts.extend(ray[1] for ray in rays)
            sight.ends.extend(ray[2] for ray in rays)


def _find_extent(thing: _Placed) -> tuple[float, float]:
    """Return the bearings of the thing's right and left edge; it is seen under less than half a turn."""
    x, y, cos, sin, length, width = thing
    ax, ay, bx, by = cos * length, sin * length, -sin * width, cos * width
    right = left = 0.0
    for i, j in ((ax + bx, ay + by), (ax - bx, ay - by), (-ax - bx, -ay - by), (bx - ax, by - ay)):
        off = math.atan2(x * (y + j) - y * (x + i), x * (x + i) + y * (y + j))
        if off < right:
            right = off
        elif off > left:
            left = off
    middle = math.atan2(y, x)
    return middle + right, middle + left


def _make_ray(
    thing: _Placed, bearing: float, camera: tuple[float, float, float, float]
) -> tuple[float, Point3, Point3]:
    """Return the distance to the thing's surface, and a ray from the robot's body to just before it."""
    x, y, cos, sin = camera
    ahead, aside = math.cos(bearing), math.sin(bearing)
    surface = _find_surface_m(thing, ahead, aside)
    near = FRONT_M / ahead if abs(aside) * FRONT_M <= ahead * WIDTH_M / 2 else WIDTH_M / 2 / abs(aside)
    near -= INSET_M
    far = max(surface - SHORT_M, near)
    dx, dy = ahead * cos - aside * sin, aside * cos + ahead * sin
    return surface, (x + near * dx, y + near * dy, HEIGHT_M), (x + far * dx, y + far * dy, HEIGHT_M)


def _find_surface_m(thing: _Placed, ahead: float, aside: float) -> float:
    """Return the distance from the camera to the thing's surface along a direction that meets it."""
    x, y, cos, sin, length, width = thing
    along, across = ahead * cos + aside * sin, aside * cos - ahead * sin
    near = 0.0
    if along != 0.0:
        near = (x * cos + y * sin) / along - length / abs(along)
    if across != 0.0:
        near = max(near, (y * cos - x * sin) / across - width / abs(across))
    return max(near, 0.0)


def _make_blob(view: View, seen: Sequence[int]) -> Blob:
    middle = view.right_rad + (sum(seen) / len(seen) + 0.5) * view.column_rad
    return Blob(view.colour, middle, min([view.surface_m[i] for i in seen]), len(seen) * view.column_rad)


def _read_range(blob: Blob) -> float:
    return blob.range_m
