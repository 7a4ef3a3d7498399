"""The ring of 16 sonars: single rays of 5 m (Thesis 4.1; poses of Stage 1.3 and Pyro).

A ray starts inside the robot's own body, which it does not meet from there, and the range is counted from the sonar. It
does not start at the sonar itself: the front ones stand before the body, and may stand in a wall.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from tutorstudent.sims.pioneer.body import Pose, edge_m

Floats = NDArray[np.float64]

SONARS: tuple[tuple[float, float, float], ...] = (
    (0.115, 0.130, 90.0),
    (0.155, 0.115, 50.0),
    (0.190, 0.080, 30.0),
    (0.210, 0.025, 10.0),
    (0.210, -0.025, -10.0),
    (0.190, -0.080, -30.0),
    (0.155, -0.115, -50.0),
    (0.115, -0.130, -90.0),
    (-0.115, -0.130, -90.0),
    (-0.155, -0.115, -130.0),
    (-0.190, -0.080, -150.0),
    (-0.210, -0.025, -170.0),
    (-0.210, 0.025, 170.0),
    (-0.190, 0.080, 150.0),
    (-0.155, 0.115, 130.0),
    (-0.115, 0.130, 90.0),
)
"""x (m, forward), y (m, left), yaw (degrees, counter-clockwise) of each sonar."""

INSET_M = 0.03
"""A ray starts this far inside the body; more than bodies under force ever press into a wall."""
HEIGHT_M = 0.1
"""Height of the rays."""
BLOCK = 256
"""Reads for which noise is drawn at once."""


class SonarRing:
    """Rays and ranges of some of the sonars, for robots that are sensed together.

    Args:
        sonars: Which of the 16, in the order of the ranges.
        range_m: Largest range.
        robots: Number of robots.
    """

    def __init__(self, sonars: Sequence[int], range_m: float, robots: int = 1) -> None:
        x, y, degrees = np.array([SONARS[i] for i in sonars]).T
        yaw = np.deg2rad(degrees)
        self._range_m = range_m
        self._skip = np.array([_edge(*SONARS[i]) - INSET_M for i in sonars])
        self._span = range_m - self._skip
        self._starts = _make_homogeneous(x + self._skip * np.cos(yaw), y + self._skip * np.sin(yaw))
        self._ends = _make_homogeneous(x + range_m * np.cos(yaw), y + range_m * np.sin(yaw))
        self._frames = np.zeros((robots, 3, 3))
        self._frames[:, 2, 2] = HEIGHT_M
        self._from, self._to = np.zeros((2, robots, len(sonars), 3))

    def make_rays(self, poses: Sequence[Pose]) -> tuple[Floats, Floats]:
        """Return start and end points, each of shape (robots x sonars, 3); the arrays are used again."""
        for frame, (x, y, heading) in zip(self._frames, poses, strict=True):
            cos, sin = math.cos(heading), math.sin(heading)
            frame[0, 0] = frame[1, 1] = cos
            frame[0, 1] = sin
            frame[1, 0] = -sin
            frame[2, 0] = x
            frame[2, 1] = y
        np.matmul(self._starts, self._frames, out=self._from)
        np.matmul(self._ends, self._frames, out=self._to)
        return self._from.reshape(-1, 3), self._to.reshape(-1, 3)

    def ranges_m(self, fractions: Sequence[float]) -> Floats:
        """Return ranges of shape (robots, sonars) from the fractions of the rays that were travelled, 1 for no echo."""
        ranges: Floats = np.array(fractions).reshape(self._from.shape[:2])
        ranges *= self._span
        ranges += self._skip
        np.maximum(ranges, 0.0, out=ranges)
        return ranges


class ReadNoise:
    """Read noise of the rings of some robots: each range is off by a uniform share, and never above the largest range.

    Choice: Pyro redraws the noise at each read; a read beyond the largest range is the largest range
    (docs/fidelity.md).

    Args:
        noise: Largest share, 0.05 for 5 %.
        sonars: Number of sonars of a robot.
        range_m: Largest range.
        rngs: Each ring's own random numbers.
    """

    def __init__(self, noise: float, sonars: int, range_m: float, rngs: Sequence[np.random.Generator]) -> None:
        self._noise = noise
        self._shape = (BLOCK, sonars)
        self._range_m = range_m
        self._rngs = tuple(rngs)
        self._factors: Iterator[Floats] = iter(())

    def read(self, ranges_m: Floats) -> Floats:
        """Return the ranges, shape (robots, sonars), as they are read this time."""
        factors = next(self._factors, None)
        if factors is None:
            drawn = [rng.uniform(-1.0, 1.0, self._shape) for rng in self._rngs]
            self._factors = iter(1.0 + self._noise * np.stack(drawn, axis=1))
            factors = next(self._factors)
        read = ranges_m * factors
        return np.minimum(read, self._range_m, out=read)


def _make_homogeneous(x: Floats, y: Floats) -> Floats:
    return np.column_stack((x, y, np.ones_like(x)))


def _edge(x_m: float, y_m: float, yaw_deg: float) -> float:
    yaw = math.radians(yaw_deg)
    return edge_m(x_m, y_m, math.cos(yaw), math.sin(yaw))
