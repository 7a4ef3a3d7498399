"""What was gained against what it cost: every run of an environment in one picture."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes

from tutorstudent.study.numbers.gains import PER, Gains, Row
from tutorstudent.study.pictures.labels import Box, Point, place_labels
from tutorstudent.study.pictures.palette import INK, Palette
from tutorstudent.study.pictures.scales import LINEAR_UP_TO, LONG_LABEL, make_long_ticks
from tutorstudent.study.pictures.svg import STYLE, make_sheet, make_svg

WIDTH_PX, HEIGHT_PX, RIGHT_PX = 720, 430, 48
LETTER_PX, LINE_PX = 5.9, 11.0
BUDGET = 0.001 * PER
"""A bound to hold results against: the thesis's, collisions in less than 0.1 % of the decisions (Thesis 4.4)."""
DASHED = (0, (3, 2))
DISC, RING = 6.0, 12.0


def draw_scatter(gains: Gains, palette: Palette, controls: Collection[str]) -> str:
    """Return an SVG: a small mark for each run, a large one with its name for the mean; controls are rings."""
    with mpl.rc_context(STYLE):
        figure, axes = make_sheet(WIDTH_PX, HEIGHT_PX, left_px=48, bottom_px=36, right_px=RIGHT_PX)
        _scale_across(axes, gains)
        _scale_upward(axes, gains)
        for name, row in gains.rows.items():
            _draw_runs(axes, row, palette.find_stand_in(name))
            _draw_mean(axes, row, palette.find_stand_in(name), ring=name in controls)
        _draw_names(axes, gains, palette)
        return make_svg(figure, _describe(gains), palette.list_stand_ins())


def _scale_across(axes: Axes, gains: Gains) -> None:
    top = max([BUDGET, *(run.harm for row in gains.rows.values() for run in row.runs)])
    axes.set_xscale("symlog", linthresh=LINEAR_UP_TO)
    axes.set_xticks(make_long_ticks(top * 1.5, (2, 5, 10)))
    axes.minorticks_off()
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:,.0f}")
    axes.set_xlim(-0.6, top * 1.6)
    axes.set_xlabel(f"{gains.harm} decisions in {PER:,} ({LONG_LABEL})", loc="left")  # a narrow screen shows the left
    axes.axvline(BUDGET, color=INK, linewidth=1.0, linestyle=DASHED)
    axes.annotate(
        "0.1\N{NO-BREAK SPACE}%", (BUDGET, 1), (3, -9), xycoords=("data", "axes fraction"), textcoords="offset points"
    )


def _scale_upward(axes: Axes, gains: Gains) -> None:
    every = [0.0, *(run.gain for row in gains.rows.values() for run in row.runs)]
    room = 0.07 * (max(every) - min(every)) or 1.0
    axes.set_ylim(min(every) - room, max(every) + room)
    axes.locator_params(axis="y", nbins=7, integer=True)
    axes.yaxis.set_major_formatter(lambda value, _: _add_sign(value))
    axes.set_title(f"{gains.goal}, more than {gains.reference} with the same seed", color=INK)
    axes.grid(axis="y", linewidth=0.5)
    axes.axhline(0.0, color=INK, linewidth=0.8)
    if gains.has_percent:
        _add_percent(axes, gains.reference_mean / 100)


def _add_percent(axes: Axes, unit: float) -> None:
    """Repeat the scale on the right in percent of what the tutor alone achieves."""

    def to_percent(gain: Any) -> Any:
        return gain / unit

    def to_count(share: Any) -> Any:
        return share * unit

    right = axes.secondary_yaxis("right", functions=(to_percent, to_count))
    right.locator_params(axis="y", nbins=7)
    right.yaxis.set_major_formatter(lambda value, _: f"{_add_sign(value)} %")
    right.spines["right"].set_visible(False)


def _add_sign(value: float) -> str:
    return f"{value:+,.6g}".replace("-", "\N{MINUS SIGN}") if abs(value) > 1e-9 else "0"


def _draw_runs(axes: Axes, row: Row, colour: str) -> None:
    harm, gain = zip(*row.runs, strict=True)
    axes.plot(harm, gain, "o", color=colour, markersize=4.0, alpha=0.6, markeredgewidth=0)


def _draw_mean(axes: Axes, row: Row, colour: str, *, ring: bool) -> None:
    for ends in _make_bars(row):
        axes.plot(*zip(*ends, strict=True), color=colour, linewidth=1.0, alpha=0.5)
    # A ring and a smaller disc are both seen where a control comes to the same as a learner.
    size, fill, zorder = (RING, "none", 5) if ring else (DISC, colour, 4)
    style: Any = {"markersize": size, "markerfacecolor": fill, "markeredgecolor": colour, "zorder": zorder}
    axes.plot(*row.mean, "o", markeredgewidth=2, **style)


def _make_bars(row: Row) -> list[list[Point]]:
    """Return the two lines that reach a standard deviation from the mean; there is no harm below 0."""
    (harm, gain), sd = row.mean, row.sd
    return [
        [(max(0.0, harm - sd.harm), gain), (harm + sd.harm, gain)],
        [(harm, gain - sd.gain), (harm, gain + sd.gain)],
    ]


def _draw_names(axes: Axes, gains: Gains, palette: Palette) -> None:
    marks = _move_to_paper(axes, [row.mean for row in gains.rows.values()])
    corners = _move_to_paper(axes, zip(axes.get_xlim(), axes.get_ylim(), strict=True))
    sizes = [(LETTER_PX * len(name) + 2, LINE_PX) for name in gains.rows]
    boxes = place_labels(marks, sizes, Box(*corners[0], *corners[1]), _find_obstacles(axes, gains))
    for (name, row), mark, box in zip(gains.rows.items(), marks, boxes, strict=True):
        colour = palette.find_stand_in(name)
        axes.annotate(
            name,
            row.mean,
            ((box.left + box.right) / 2 - mark[0], (box.bottom + box.top) / 2 - mark[1]),
            textcoords="offset points",
            ha="center",
            va="center_baseline",
            fontweight="bold",
            color=colour,
            arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.6, "shrinkA": 0, "shrinkB": 5},
        )


def _find_obstacles(axes: Axes, gains: Gains) -> list[Point]:
    """Return what names should not hide: runs, and points every few pixels along the lines."""
    found = _move_to_paper(axes, [run for row in gains.rows.values() for run in row.runs])
    lines = [_move_to_paper(axes, ends) for row in gains.rows.values() for ends in _make_bars(row)]
    x_lim, y_lim = axes.get_xlim(), axes.get_ylim()
    lines += [_move_to_paper(axes, [(BUDGET, y) for y in y_lim]), _move_to_paper(axes, [(x, 0.0) for x in x_lim])]
    for begin, end in lines:
        count = int(np.hypot(end[0] - begin[0], end[1] - begin[1]) / 6) + 1
        found += list(zip(np.linspace(begin[0], end[0], count), np.linspace(begin[1], end[1], count), strict=True))
    return found


def _move_to_paper(axes: Axes, points: Iterable[Sequence[float]]) -> list[Point]:
    """Return points of the picture's scales as points of the drawing."""
    drawn = axes.transData.transform(np.reshape(list(points), (-1, 2))) * 72 / axes.figure.dpi
    return [(float(x), float(y)) for x, y in drawn]


def _describe(gains: Gains) -> str:
    means = "; ".join(f"{name}: {row.mean.gain:+.4g} at {row.mean.harm:.4g}" for name, row in gains.rows.items())
    return f"Gain in {gains.goal} over {gains.reference} against {gains.harm} decisions in {PER:,}, means. {means}."
