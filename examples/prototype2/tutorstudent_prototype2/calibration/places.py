"""Where boxes can stand: free floor, away from walls, from each other and from where robots start."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Point = tuple[float, float]
Outline = Sequence[Point]

WALL_M = 0.9
APART_M = 2.5
FROM_STARTS_M = 2.0
"""Nearer than these, a box would block a passage, hide another box, or be found before the robot has moved."""


class Floor(NamedTuple):
    """Free space and what already stands in it, metres."""

    outlines: Sequence[Outline]
    """The outer wall, then the islands."""
    starts: Sequence[Point]
    """Where robots start."""
    side_m: float

    def move(self, places: Sequence[Point], changed: float, rng: np.random.Generator) -> list[Point]:
        """Return the places of boxes after each was moved with a probability to anywhere that is free.

        Places are in percent of the side, with one decimal.
        """
        found = list(places)
        for i in range(len(found)):
            if rng.random() < changed:
                found[i] = self._anywhere(found[:i] + found[i + 1 :], rng)
        return found

    def _anywhere(self, others: Sequence[Point], rng: np.random.Generator) -> Point:
        unit_m = self.side_m / 100
        while True:
            x, y = (round(float(value), 1) for value in rng.uniform(0, 100, size=2))
            apart = all(_distance_m((x * unit_m, y * unit_m), (a * unit_m, b * unit_m)) > APART_M for a, b in others)
            if apart and self.free((x * unit_m, y * unit_m)):
                return x, y

    def free(self, place: Point) -> bool:
        """Return whether a box can stand there."""
        arena, *islands = self.outlines
        return (
            inside(place, arena)
            and not any(inside(place, island) for island in islands)
            and all(to_outline_m(place, outline) > WALL_M for outline in self.outlines)
            and all(_distance_m(place, start) > FROM_STARTS_M for start in self.starts)
        )


def inside(place: Point, outline: Outline) -> bool:
    """Return whether a point lies in a polygon.

    >>> square = [(0, 0), (2, 0), (2, 2), (0, 2)]
    >>> inside((1, 1), square), inside((3, 1), square)
    (True, False)
    """
    x, y = place
    begin, end = _edges(outline)
    crosses = (begin[:, 1] > y) != (end[:, 1] > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        at_x = begin[:, 0] + (y - begin[:, 1]) / (end[:, 1] - begin[:, 1]) * (end[:, 0] - begin[:, 0])
    return bool(np.count_nonzero(crosses & (x < at_x)) % 2)


def to_outline_m(place: Point, outline: Outline) -> float:
    """Return the distance from a point to the nearest edge of a polygon.

    >>> to_outline_m((1, 0.5), [(0, 0), (2, 0), (2, 2), (0, 2)])
    0.5
    """
    begin, end = _edges(outline)
    along = end - begin
    reached = np.clip(((place - begin) * along).sum(axis=1) / np.maximum((along**2).sum(axis=1), 1e-12), 0.0, 1.0)
    return float(np.sqrt(((begin + reached[:, None] * along - place) ** 2).sum(axis=1)).min())


def _edges(outline: Outline) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    begin = np.asarray(outline, dtype=np.float64)
    return begin, np.roll(begin, -1, axis=0)


def _distance_m(one: Point, other: Point) -> float:
    return float(np.hypot(one[0] - other[0], one[1] - other[1]))
