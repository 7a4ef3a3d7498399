"""Pure pursuit (Coulter 1992): the arc that leads to a point of the path some way ahead."""

from __future__ import annotations

import math
from collections.abc import Sequence

from tutorstudent_controllers.planner.state import Point, Pose


def progress(path: Sequence[Point], pose: Pose, since: int) -> int:
    """Return the index of the path's nearest point, not before `since`."""
    return min(range(since, len(path)), key=lambda i: math.dist(path[i], (pose.x_m, pose.y_m)))


def target(path: Sequence[Point], at: int, ahead_m: float) -> Point:
    """Return the first point of the path that is `ahead_m` of way beyond index `at`; the last where it ends before."""
    way_m = 0.0
    for i in range(at, len(path) - 1):
        way_m += math.dist(path[i], path[i + 1])
        if way_m >= ahead_m:
            return path[i + 1]
    return path[-1]


def curvature_pm(distance_m: float, bearing_rad: float) -> float:
    """Return the curvature of the arc to a point, 1/m, left positive.

    >>> curvature_pm(2.0, 0.0)
    0.0
    >>> round(curvature_pm(2.0, math.pi / 2), 6)  # a half circle of radius 1 m
    1.0
    """
    return 2 * math.sin(bearing_rad) / distance_m
