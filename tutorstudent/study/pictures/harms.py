"""Where it collided: the world's drawing with every harmed decision of every run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from tutorstudent.core.roles.world import Sketch
from tutorstudent.core.running.arrays import Arrays
from tutorstudent.study.numbers.curves import read_points
from tutorstudent.study.numbers.traces import Trace
from tutorstudent.study.pictures.maps import draw_world, split_way
from tutorstudent.study.pictures.palette import HARM, WAY, Palette
from tutorstudent.study.pictures.svg import STYLE, make_sheet, make_svg

Points = NDArray[np.float64]
SIZE_PX, RASTER_DPI = 240, 130


class Harms(NamedTuple):
    """What a map of one variant shows."""

    harmed: Points
    """Where each harmed decision ended, shape (harmed, 2), metres."""
    contacts: Points
    """The same where contacts began."""


def find_harms(traces: Sequence[Trace]) -> Harms | None:
    """Return where all runs of a variant were harmed; None if the world does not say."""
    there = [trace for trace in traces if trace.harm_places is not None]
    if not there:
        return None
    nothing = np.zeros((0, 2))
    return Harms(
        np.concatenate([nothing, *(trace.harm_places for trace in there if trace.harm_places is not None)]),
        np.concatenate([nothing, *(trace.contact_places for trace in there if trace.contact_places is not None)]),
    )


def draw_harm_map(
    title: str, sketch: Sketch, traces: Sequence[Trace], first: Arrays | None, palette: Palette
) -> str | None:
    """Return an SVG of where a variant was harmed; None if the world does not say or cannot draw itself."""
    found = find_harms(traces)
    if found is None or sketch == Sketch():
        return None
    with mpl.rc_context(STYLE):
        figure, axes = make_sheet(SIZE_PX, SIZE_PX, left_px=26, bottom_px=34)
        if first is not None:
            _draw_way(axes, first)
        _draw_harms(axes, found)
        draw_world(axes, sketch)
        axes.set_title(title, color=palette.find_stand_in(title), fontweight="bold")
        alt = (
            f"Map of where {title} was harmed, all {len(traces)} runs: {len(found.harmed)} decisions, "
            f"{len(found.contacts)} contacts."
        )
        return make_svg(figure, alt, palette.list_stand_ins(), RASTER_DPI)


def _draw_way(axes: Axes, first: Arrays) -> None:
    where = read_points(first)
    if where is not None:
        x, y = split_way(where, first).T
        axes.plot(x, y, color=WAY, linewidth=0.6, antialiased=False, rasterized=True, zorder=0.5)


def _draw_harms(axes: Axes, found: Harms) -> None:
    x, y = found.harmed.T
    axes.plot(
        x,
        y,
        "o",
        color=HARM,
        markersize=4.2,
        markeredgewidth=0,
        alpha=_choose_alpha(len(x)),
        rasterized=True,
        zorder=0.6,
    )
    x, y = found.contacts.T
    axes.plot(
        x,
        y,
        "o",
        markersize=7.0,
        markerfacecolor="none",
        markeredgecolor=HARM,
        markeredgewidth=0.8,
        alpha=min(1.0, 1.5 * _choose_alpha(len(x))),
        rasterized=True,
        zorder=0.7,
    )


def _choose_alpha(marks: int) -> float:
    """Return how opaque a mark is: the more of them, the less, so that crowded places stand out."""
    return float(np.clip(6 / np.sqrt(max(marks, 1)), 0.08, 0.6))
