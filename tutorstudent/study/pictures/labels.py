"""Puts names beside their marks so that they do not hide each other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Point = tuple[float, float]
_DIRECTIONS = 16
_DISTANCES = (4.0, 10.0, 18.0, 28.0, 40.0, 54.0, 70.0, 90.0)


class Box(NamedTuple):
    """A rectangle on the drawing."""

    left: float
    bottom: float
    right: float
    top: float

    def measure_overlap(self, other: Box) -> float:
        """Return the area that both cover."""
        width = min(self.right, other.right) - max(self.left, other.left)
        height = min(self.top, other.top) - max(self.bottom, other.bottom)
        return max(0.0, width) * max(0.0, height)


def place_labels(marks: Sequence[Point], sizes: Sequence[Point], within: Box, dots: Sequence[Point] = ()) -> list[Box]:
    """Return a box for the name of each mark, one after the other: the cheapest of many places round the mark.

    Another name or mark below it is dearest, then standing outside, then distance and the dots that it hides.

    Args:
        marks: The marks, in points.
        sizes: Width and height of the names.
        within: Where names should stand.
        dots: Small marks that had better stay visible.
    """
    boxes: list[Box] = []
    around = [Box(x - 5, y - 5, x + 5, y + 5) for x, y in marks]
    small = np.reshape(np.array(dots, dtype=np.float64), (-1, 2))
    for mark, size in zip(marks, sizes, strict=True):
        candidates = _make_candidates(mark, size)
        costs = [_measure_cost(box, distance, [*boxes, *around], within, small) for box, distance in candidates]
        boxes.append(candidates[int(np.argmin(costs))][0])
    return boxes


def _make_candidates(mark: Point, size: Point) -> list[tuple[Box, float]]:
    found = []
    for distance in _DISTANCES:
        for turn in np.arange(_DIRECTIONS) * 2 * np.pi / _DIRECTIONS:
            # The nearest point of the box is this far from the mark, whichever the direction.
            x = mark[0] + np.cos(turn) * (distance + 5) + (np.cos(turn) - 1) / 2 * size[0]
            y = mark[1] + np.sin(turn) * (distance + 5) + (np.sin(turn) - 1) / 2 * size[1]
            found.append((Box(float(x), float(y), float(x + size[0]), float(y + size[1])), distance))
    return found


def _measure_cost(box: Box, distance: float, taken: Sequence[Box], within: Box, dots: NDArray[np.float64]) -> float:
    x, y = dots.T
    hidden = int(((box.left < x) & (x < box.right) & (box.bottom < y) & (y < box.top)).sum())
    outside = (box.right - box.left) * (box.top - box.bottom) - box.measure_overlap(within)
    return 100 * sum(map(box.measure_overlap, taken)) + 50 * outside + distance + 3 * hidden
