"""Closed outlines: found round cells, and asked what is inside them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.roles.world import Point

Cells = NDArray[np.bool_]
Corner = tuple[int, int]
Edges = NDArray[np.float64]
"""Shape (n, 4): x and y of where each edge begins, x and y of where it ends."""


def make_edges(outlines: Iterable[Sequence[Point]]) -> Edges:
    """Return the edges of closed outlines."""
    loops = [np.array(outline, dtype=np.float64).reshape(-1, 2) for outline in outlines]
    edges = [np.hstack((loop, np.roll(loop, -1, axis=0))) for loop in loops]
    return np.concatenate(edges) if edges else np.zeros((0, 4))


def is_inside(point: Point, edges: Edges) -> bool:
    """Return whether a point lies inside closed outlines: a ray from it crosses them an odd number of times.

    So what lies in a hole of an outline is outside.

    >>> square, hole = [(0, 0), (3, 0), (3, 3), (0, 3)], [(1, 1), (1, 2), (2, 2), (2, 1)]
    >>> is_inside((1.5, 1.5), make_edges([square])), is_inside((1.5, 1.5), make_edges([square, hole]))
    (True, False)
    """
    x, y = point
    x0, y0, x1, y1 = edges[(edges[:, 1] > y) != (edges[:, 3] > y)].T
    crossings = np.count_nonzero(x < x0 + (y - y0) * (x1 - x0) / (y1 - y0))
    return bool(crossings % 2)


def count_corners(cells: Cells) -> int:
    """Return how many corners the outlines of the true cells have, without finding them."""
    return int(_count_at_points(np.pad(cells, 1)).sum(dtype=np.int64))


def find_outlines(cells: Cells) -> list[list[Corner]]:
    """Return the closed outlines of the true cells, each corner once, in cells; row 0 is the lowest.

    Outer outlines run counter-clockwise, holes clockwise. Cells that only share a corner are not joined.
    """
    padded = np.pad(cells, 1)
    counts = _count_at_points(padded)
    y, x = np.nonzero(counts)
    times = counts[y, x]
    y, x = np.repeat(y, times), np.repeat(x, times)
    # Row by row, every corner with an even number begins a horizontal edge, and the next corner ends it. With cells
    # above it, the outline runs along it to the right.
    begins = 2 * np.flatnonzero(padded[y + 1, x + 1][::2])
    ends = _pair_along_columns(x, y, padded[y, x + 1])
    corners = list(zip(x.tolist(), y.tolist(), strict=True))
    return [[corners[i] for i in loop] for loop in _follow_loops(begins.tolist(), ends)]


def _count_at_points(padded: Cells) -> NDArray[np.uint8]:
    """Return, for each point where four cells meet, how many corners outlines have there: none, one or two."""
    left, right = padded[:-1, :-1] ^ padded[1:, :-1], padded[:-1, 1:] ^ padded[1:, 1:]
    crossed = left & right & (padded[:-1, :-1] ^ padded[:-1, 1:])
    counts: NDArray[np.uint8] = (left ^ right).astype(np.uint8)
    counts[crossed] = 2
    return counts


def _pair_along_columns(x: NDArray[np.intp], y: NDArray[np.intp], below_right: Cells) -> list[int]:
    """Return, for each corner, the number of the corner at the other end of its vertical edge.

    Where two corners share a point, the first has the edge to the left, and the edge up if the cell at the lower right
    is true; otherwise the edge down.
    """
    second = np.zeros(len(x), dtype=bool)
    second[1:] = (x[1:] == x[:-1]) & (y[1:] == y[:-1])
    order = np.lexsort((second ^ below_right, y, x))
    ends = np.empty(len(x), dtype=np.intp)
    ends[order] = order.reshape(-1, 2)[:, ::-1].ravel()
    found: list[int] = ends.tolist()
    return found


def _follow_loops(begins: Sequence[int], ends: Sequence[int]) -> Iterator[list[int]]:
    """Yield the numbers of the corners of every outline, along horizontal and vertical edges in turn."""
    seen: set[int] = set()
    for first in begins:
        if first in seen:
            continue
        loop: list[int] = []
        here = first
        while not loop or here != first:
            loop += (here, here ^ 1)
            here = ends[here ^ 1]
        seen.update(loop)
        yield loop
