"""Where the robot went: the world's drawing with one run's way, coloured by amplification level."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import Colormap, LinearSegmentedColormap, Normalize, to_hex
from matplotlib.patches import Circle, Polygon
from numpy.typing import NDArray

from tutorstudent.core.roles.world import Sketch
from tutorstudent.core.running.arrays import Arrays
from tutorstudent.study.numbers.curves import read_points
from tutorstudent.study.pictures.palette import FLOOR, MAP_COLOURS, WALL, Palette
from tutorstudent.study.pictures.svg import STYLE, make_sheet, make_svg

SIZE_PX = 300
COLOURED_LEVELS = 8
"""The thesis's highest level; higher ones have its colour."""


def draw_way_map(title: str, sketch: Sketch, arrays: Arrays, palette: Palette) -> str | None:
    """Return an SVG of one run's way; None if the world does not say where the robot is."""
    where = read_points(arrays)
    if where is None:
        return None
    with mpl.rc_context(STYLE):
        figure, axes = make_sheet(SIZE_PX, SIZE_PX, left_px=26, bottom_px=34)
        draw_way(axes, sketch, arrays, where)
        axes.set_title(title, color=palette.find_stand_in(title), fontweight="bold")
        mean_level = float(arrays["resulting_level"].mean())
        alt = f"Map of the way of {title}, coloured by amplification level; the mean level is {mean_level:.1f}."
        return make_svg(figure, alt, palette.list_stand_ins())


def draw_way(axes: Axes, sketch: Sketch, arrays: Arrays, points: NDArray[np.float64]) -> None:
    """Draw the world and the way through `points`, shape (decisions, 2), in metres, coloured by level."""
    axes.add_collection(_make_way(points, arrays))
    draw_world(axes, sketch)


def draw_world(axes: Axes, sketch: Sketch) -> None:
    """Draw the world round what is there already, in metres, one scale for both directions."""
    axes.set_facecolor(FLOOR)
    _draw(axes, sketch)
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.set_xlabel("m")


def split_way(points: NDArray[np.float64], arrays: Arrays) -> NDArray[np.float64]:
    """Return the way through `points`, shape (n, 2), as one line with a gap (NaN) wherever a trial ended.

    >>> split_way(np.array([[0.0, 0.0], [1.0, 0.0]]), {"trial_ended": np.array([1, 0])}).tolist()
    [[0.0, 0.0], [nan, nan], [1.0, 0.0]]
    """
    return np.insert(points, np.flatnonzero(arrays["trial_ended"][:-1]) + 1, np.nan, axis=0)


def make_level_colours() -> Colormap:
    """Return the colours of levels 0 to 8: dark to bright, for colour-blind readers too."""
    plasma = mpl.colormaps["plasma"]
    return LinearSegmentedColormap.from_list("level", [plasma(share) for share in np.linspace(0.0, 0.82, 9)])


def list_level_colours() -> list[str]:
    """Return a colour for each level, for the page's legend."""
    return [to_hex(make_level_colours()(level / COLOURED_LEVELS)) for level in range(COLOURED_LEVELS + 1)]


def _make_way(points: NDArray[np.float64], arrays: Arrays) -> LineCollection:
    # Nothing leads from the end of one trial to the beginning of the next.
    steps = np.stack([points[:-1], points[1:]], axis=1)
    together = ~arrays["trial_ended"][:-1].astype(bool)
    way = LineCollection(
        list(steps[together]),
        cmap=make_level_colours(),
        norm=Normalize(0, COLOURED_LEVELS),
        linewidths=1.0,
        alpha=0.8,
        capstyle="round",
        rasterized=True,
        zorder=3,
    )
    way.set_array(arrays["resulting_level"][1:][together])
    return way


def _draw(axes: Axes, sketch: Sketch) -> None:
    for points, colour in sketch.polygons:
        _draw_outline(axes, points, colour)
    for centre, radius, colour in sketch.discs:
        axes.add_patch(Circle(centre, radius, color=MAP_COLOURS.get(colour, WALL)))
    for x, y, heading, colour in sketch.poses:
        tip = (x + 0.35 * np.cos(heading), y + 0.35 * np.sin(heading))
        axes.plot([x, tip[0]], [y, tip[1]], color=MAP_COLOURS.get(colour, WALL), linewidth=1.5)
        axes.plot([x], [y], "o", color=MAP_COLOURS.get(colour, WALL), markersize=4)


def _draw_outline(axes: Axes, points: Sequence[tuple[float, float]], colour: str) -> None:
    body = MAP_COLOURS.get(colour)
    axes.add_patch(Polygon(list(points), facecolor=body or "none", edgecolor=body or WALL, linewidth=1.2, alpha=0.7))
