"""A* (Hart, Nilsson and Raphael 1968) over a grid, eight neighbours each."""

from __future__ import annotations

import heapq
import math

import numpy as np
from numpy.typing import NDArray

from tutorstudent_controllers.planner.grid import Cell

STEPS = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1) if (i, j) != (0, 0)]


def shortest_path(free: NDArray[np.bool_], start: Cell, goal: Cell) -> list[Cell]:
    """Return the cells of a shortest way through free cells, start and goal among them; empty where there is none.

    >>> shortest_path(np.ones((3, 3), dtype=bool), (0, 0), (2, 2))
    [(0, 0), (1, 1), (2, 2)]
    """
    came: dict[Cell, Cell] = {}
    cost = {start: 0.0}
    queue = [(_estimate(start, goal), start)]
    closed: set[Cell] = set()
    while queue:
        _, cell = heapq.heappop(queue)
        if cell == goal:
            return _trace(came, goal)
        if cell in closed:
            continue
        closed.add(cell)
        for step in STEPS:
            there = (cell[0] + step[0], cell[1] + step[1])
            if not _is_free(free, there):
                continue
            total = cost[cell] + math.hypot(*step)
            if total < cost.get(there, math.inf):
                cost[there], came[there] = total, cell
                heapq.heappush(queue, (total + _estimate(there, goal), there))
    return []


def _is_free(free: NDArray[np.bool_], cell: Cell) -> bool:
    i, j = cell
    return 0 <= i < free.shape[0] and 0 <= j < free.shape[1] and bool(free[i, j])


def _estimate(cell: Cell, goal: Cell) -> float:
    near, far = sorted((abs(cell[0] - goal[0]), abs(cell[1] - goal[1])))
    return math.sqrt(2) * near + (far - near)


def _trace(came: dict[Cell, Cell], goal: Cell) -> list[Cell]:
    path = [goal]
    while path[-1] in came:
        path.append(came[path[-1]])
    return path[::-1]
