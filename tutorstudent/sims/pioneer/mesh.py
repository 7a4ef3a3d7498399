"""Walls as one mesh: vertical faces along closed outlines."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from tutorstudent.core.roles.world import Point

Vertex = tuple[float, float, float]

HEIGHT_M = 0.5
"""Height of walls and boxes; everything that senses does so below it."""
RING_M = 0.2
"""Thickness of the wall round an arena."""
CIRCLE_SIDES = 128
MOST_CORNERS = 60_000
"""Of all outlines of a scene: pybullet takes 131,072 vertices in a mesh, and a corner has two."""
MOST_FACADES = 16_000
"""Sides that are drawn with one mesh; each has eight vertices."""


class Mesh(NamedTuple):
    """Triangles: three indices each. Normals only where a renderer needs them."""

    vertices: Sequence[Vertex]
    indices: Sequence[int]
    normals: Sequence[Vertex] = ()


def make_prisms(outlines: Iterable[Sequence[Point]]) -> Mesh:
    """Return upright faces along closed outlines, one quad for each side."""
    vertices: list[Vertex] = []
    indices: list[int] = []
    for outline in outlines:
        first, count = len(vertices), len(outline)
        for x, y in outline:
            vertices += [(x, y, 0.0), (x, y, HEIGHT_M)]
        for side in range(count):
            a, b = first + 2 * side, first + 2 * ((side + 1) % count)
            indices += [a, b, b + 1, a, b + 1, a + 1]
    return Mesh(vertices, indices)


def make_facades(outlines: Iterable[Sequence[Point]]) -> Iterator[Mesh]:
    """Yield the same faces for a renderer: flat, and seen from both sides."""
    sides = ((a, b) for outline in outlines for a, b in zip(outline, [*outline[1:], outline[0]], strict=True))
    while some := list(itertools.islice(sides, MOST_FACADES)):
        yield _make_facade(some)


def _make_facade(sides: Iterable[tuple[Point, Point]]) -> Mesh:
    vertices: list[Vertex] = []
    indices: list[int] = []
    normals: list[Vertex] = []
    for (x, y), (u, v) in sides:
        length = math.hypot(u - x, v - y) or 1.0
        for side in (1.0, -1.0):
            first = len(vertices)
            vertices += [(x, y, 0.0), (u, v, 0.0), (u, v, HEIGHT_M), (x, y, HEIGHT_M)]
            normals += [(side * (v - y) / length, side * (x - u) / length, 0.0)] * 4
            corners = (0, 1, 2, 0, 2, 3) if side > 0 else (0, 2, 1, 0, 3, 2)
            indices += [first + corner for corner in corners]
    return Mesh(vertices, indices, normals)


def make_circle(x_m: float, y_m: float, radius_m: float) -> list[Point]:
    """Return a regular polygon whose sides keep the circle's radius on average, counter-clockwise."""
    step = math.tau / CIRCLE_SIDES
    corner_m = radius_m * 2.0 / (1.0 + math.cos(step / 2))
    angles = (i * step for i in range(CIRCLE_SIDES))
    return [(x_m + corner_m * math.cos(angle), y_m + corner_m * math.sin(angle)) for angle in angles]


def thicken(outline: Sequence[Point]) -> list[Point]:
    """Return the outer outline of a wall that stands round `outline`, `RING_M` thick at its corners or more."""
    turn = math.copysign(1.0, area(outline))
    count = len(outline)
    return [_move_outward(outline[i - 1], outline[i], outline[(i + 1) % count], turn) for i in range(count)]


def area(outline: Sequence[Point]) -> float:
    """Return the signed area of a closed outline: positive if it runs counter-clockwise.

    >>> area([(0, 0), (2, 0), (2, 1), (0, 1)])
    2.0
    """
    following = [*outline[1:], outline[0]]
    return sum(x * v - u * y for (x, y), (u, v) in zip(outline, following, strict=True)) / 2


def _move_outward(before: Point, here: Point, after: Point, turn: float) -> Point:
    ahead = math.atan2(after[1] - here[1], after[0] - here[0])
    behind = math.atan2(here[1] - before[1], here[0] - before[0])
    half = math.remainder(ahead - behind, math.tau) / 2
    distance = RING_M / max(math.cos(half), 0.1)
    normal = behind + half - turn * math.pi / 2
    return (here[0] + distance * math.cos(normal), here[1] + distance * math.sin(normal))
