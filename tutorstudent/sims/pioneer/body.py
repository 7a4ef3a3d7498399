"""The Pioneer 2 DX's body as the simulator of the thesis had it, and plane geometry for it.

A rectangle of 0.44 m x 0.33 m whose centre lies 4 cm behind the rotation centre (Stage 1.3 ``pioneer.inc``). A pose is
the pose of the rotation centre.
"""

from __future__ import annotations

import math
from typing import NamedTuple

LENGTH_M = 0.44
WIDTH_M = 0.33
HEIGHT_M = 0.22
CENTRE_M = -0.04
"""Position of the body's centre on the robot's x axis."""
REACH_M = math.hypot(LENGTH_M / 2 - CENTRE_M, WIDTH_M / 2)
"""Distance from the rotation centre to the body's farthest corner."""


class Pose(NamedTuple):
    """Where the rotation centre is and where the robot looks: metres; radians counter-clockwise from +x."""

    x_m: float
    y_m: float
    heading_rad: float


class Rectangle(NamedTuple):
    """A coloured rectangle on the floor; ``cos`` and ``sin`` are those of its heading."""

    colour: str
    x_m: float
    y_m: float
    cos: float
    sin: float
    half_length_m: float
    half_width_m: float

    @property
    def heading_rad(self) -> float:
        """Direction of its length, counter-clockwise from +x."""
        return math.atan2(self.sin, self.cos)

    def corners(self) -> list[tuple[float, float]]:
        """Return the four corners, counter-clockwise."""
        signs = ((1, 1), (-1, 1), (-1, -1), (1, -1))
        return [self.point(i * self.half_length_m, j * self.half_width_m) for i, j in signs]

    def point(self, forward_m: float, left_m: float) -> tuple[float, float]:
        """Return the point that lies so far forward and to the left of the centre."""
        x = self.x_m + forward_m * self.cos - left_m * self.sin
        return (x, self.y_m + forward_m * self.sin + left_m * self.cos)

    def distance_m(self, x_m: float, y_m: float) -> float:
        """Return the distance from a point to the rectangle; 0 inside."""
        dx, dy = x_m - self.x_m, y_m - self.y_m
        forward = abs(dx * self.cos + dy * self.sin) - self.half_length_m
        left = abs(dy * self.cos - dx * self.sin) - self.half_width_m
        return math.hypot(max(forward, 0.0), max(left, 0.0))


def footprint(pose: Pose, colour: str) -> Rectangle:
    """Return the body at a pose."""
    cos, sin = math.cos(pose.heading_rad), math.sin(pose.heading_rad)
    return Rectangle(colour, pose.x_m + CENTRE_M * cos, pose.y_m + CENTRE_M * sin, cos, sin, LENGTH_M / 2, WIDTH_M / 2)


def edge_m(x_m: float, y_m: float, cos: float, sin: float) -> float:
    """Return how far from (x, y), along the direction (cos, sin), a line leaves the body; all in the robot's frame.

    Negative where the point lies beyond the body already, as the front sonars do.
    """
    along = _find_exit(x_m - CENTRE_M, cos, LENGTH_M / 2)
    across = _find_exit(y_m, sin, WIDTH_M / 2)
    return min(along, across)


def _find_exit(offset: float, slope: float, half: float) -> float:
    if abs(slope) < 1e-12:
        return math.inf
    return (math.copysign(half, slope) - offset) / slope
