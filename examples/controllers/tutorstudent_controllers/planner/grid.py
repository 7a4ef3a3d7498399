"""An occupancy grid of outlines, grown by the robot's size."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

import tutorstudent as ts
from tutorstudent_controllers.planner.state import Outlines, Point

Cell = tuple[int, int]


class Grid:
    """Which cells the robot's middle may be in. Only edges are drawn: nothing leads through them.

    Args:
        outlines: What stands where, metres.
        cell_m: Side of a cell.
        keep_m: How far the robot's middle keeps from every edge.

    Raises:
        ContractError: There is no free cell.
    """

    def __init__(self, outlines: Outlines, cell_m: float, keep_m: float) -> None:
        corners = np.array([corner for outline in outlines for corner in outline])
        self._cell_m = cell_m
        self._low_m = corners.min(axis=0)
        rows, columns = np.ceil((corners.max(axis=0) - self._low_m) / cell_m).astype(int) + 1
        edges = np.zeros((rows, columns), dtype=bool)
        for outline in outlines:
            points = np.concatenate([_along(a, b, cell_m / 2) for a, b in _sides(outline)])
            edges[tuple(((points - self._low_m) // cell_m).astype(int).T)] = True
        self.free = ~_grow(edges, keep_m / cell_m)
        """Shape (cells along x, cells along y)."""
        if not self.free.any():
            raise ts.ContractError(f"the map has no place that is {keep_m} m away from everything; lower keep_m.")

    def cell(self, point: Point) -> Cell:
        """Return the cell of a point; of one outside, the nearest."""
        found = ((np.array(point) - self._low_m) // self._cell_m).astype(int)
        i, j = np.clip(found, 0, np.array(self.free.shape) - 1)
        return int(i), int(j)

    def middle(self, cell: Cell) -> Point:
        """Return the middle of a cell, metres."""
        x_m, y_m = self._low_m + (np.array(cell) + 0.5) * self._cell_m
        return float(x_m), float(y_m)

    def nearest_free(self, cell: Cell) -> Cell:
        """Return the free cell that is nearest to a cell: itself where it is free."""
        free = np.argwhere(self.free)
        i, j = free[np.argmin(((free - np.array(cell)) ** 2).sum(axis=1))]
        return int(i), int(j)

    def sees(self, a: Point, b: Point) -> bool:
        """Return whether the straight way from one point to another leads through free cells only."""
        return all(self.free[self.cell((x, y))] for x, y in _along(a, b, self._cell_m / 2).tolist())


def _sides(outline: Sequence[Point]) -> list[tuple[Point, Point]]:
    return list(zip(outline, [*outline[1:], outline[0]], strict=True))


def _along(a: Point, b: Point, step_m: float) -> NDArray[np.float64]:
    steps = max(1, math.ceil(math.dist(a, b) / step_m))
    share = np.linspace(0.0, 1.0, steps + 1)[:, None]
    points: NDArray[np.float64] = np.array(a) + share * (np.array(b) - np.array(a))
    return points


def _grow(marked: NDArray[np.bool_], radius: float) -> NDArray[np.bool_]:
    """Return which cells lie within a radius, in cells, of a marked one."""
    reach = math.ceil(radius)
    wide = np.pad(marked, reach)
    grown = np.zeros_like(marked)
    rows, columns = marked.shape
    for i in range(2 * reach + 1):
        for j in range(2 * reach + 1):
            if math.hypot(i - reach, j - reach) <= radius:
                grown |= wide[i : i + rows, j : j + columns]
    return grown
