"""Every run as a dot: the end of each run for each variant and control."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes

from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.pictures.scales import LINEAR_UP_TO, LONG_LABEL, is_long_tailed, make_long_ticks
from tutorstudent.study.pictures.svg import STYLE, make_sheet, make_svg

WIDTH_PX, ROW_PX, MARGIN_PX, LETTER_PX = 330, 24, 56, 4.9


def draw_strip(title: str, values: Mapping[str, Sequence[float]], palette: Palette) -> str:
    """Return an SVG with a row for each variant, a dot for each run and a bar at the median.

    Where a few numbers are far above the others the scale is logarithmic beyond 10; the axis says so.
    """
    with mpl.rc_context(STYLE):
        left_px = min(LETTER_PX * max(len(name) for name in values) + 18, WIDTH_PX / 2)
        figure, axes = make_sheet(WIDTH_PX, MARGIN_PX + ROW_PX * len(values), left_px=left_px, bottom_px=32)
        for row, (name, numbers) in enumerate(values.items()):
            _draw_row(axes, row, numbers, palette.find_stand_in(name))
        axes.set_yticks(range(len(values)), list(values))
        axes.set_ylim(len(values) - 0.4, -0.6)
        axes.tick_params(axis="y", length=0, pad=8)  # dots at 0 stand across the axis
        axes.grid(axis="x", linewidth=0.5)
        _draw_scale(axes, title, [number for numbers in values.values() for number in numbers])
        return make_svg(figure, f"{title}, every run. {_describe(values)}.", palette.list_stand_ins())


def _draw_row(axes: Axes, row: int, numbers: Sequence[float], colour: str) -> None:
    # Dots of equal value would hide each other; neighbours in the list are moved apart, the same way every time.
    heights = row + 0.28 * np.sin(np.arange(len(numbers)) * 2.4)
    axes.plot(numbers, heights, "o", color=colour, markersize=5, alpha=0.75, markeredgewidth=0, clip_on=False)
    if numbers:
        middle = float(np.median(numbers))
        axes.plot([middle, middle], [row - 0.38, row + 0.38], color=colour, linewidth=2.2)


def _draw_scale(axes: Axes, title: str, numbers: Sequence[float]) -> None:
    axes.set_xlabel(title)
    highest = max(numbers, default=1.0)
    axes.locator_params(axis="x", integer=True)
    if is_long_tailed(numbers):
        axes.set_xscale("symlog", linthresh=LINEAR_UP_TO)
        axes.set_xticks(make_long_ticks(highest, (2, 5, 10)))
        axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        axes.set_xlabel(f"{title} ({LONG_LABEL})")
    axes.set_xlim(min(0.0, *numbers, 0.0), max(highest, 1.0) * 1.03)


def _describe(values: Mapping[str, Sequence[float]]) -> str:
    return "; ".join(f"{name}: {', '.join(f'{number:.4g}' for number in numbers)}" for name, numbers in values.items())
