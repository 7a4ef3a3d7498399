"""What happened over the decisions: for each variant a small panel with every run, all on one scale."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes

from tutorstudent.study.curves import Curve
from tutorstudent.study.palette import INK, Palette
from tutorstudent.study.scales import LINEAR_UP_TO, LONG_LABEL, is_long_tailed, long_ticks
from tutorstudent.study.svg import STYLE, sheet, svg

WIDTH_PX, HEIGHT_PX = 240, 170


class Bundle(NamedTuple):
    """One measure over the decisions of every run, by variant."""

    title: str
    at: Curve
    """In decisions: where the points of every curve stand, shape (points,)."""
    last: str
    """What the last point is about."""
    curves: Mapping[str, Sequence[Curve]]
    """By variant, in the order of the tables; a curve has shape (points,)."""
    reference: str
    """Variant whose mean is drawn into every panel; empty for none."""


def panels(bundle: Bundle, palette: Palette) -> list[str]:
    """Return an SVG for each variant that has runs."""
    tops = [float(curve.max()) for curves in bundle.curves.values() for curve in curves]
    scale = _Scale(max(1.0, *tops, 1.0), is_long_tailed(tops))
    with mpl.rc_context(STYLE):
        return [_panel(bundle, name, scale, palette) for name, curves in bundle.curves.items() if curves]


class _Scale(NamedTuple):
    """One for all panels of a bundle."""

    top: float
    is_long: bool


def _panel(bundle: Bundle, name: str, scale: _Scale, palette: Palette) -> str:
    figure, axes = sheet(WIDTH_PX, HEIGHT_PX, left_px=40 if scale.is_long else 28, bottom_px=20)
    curves = bundle.curves[name]
    for curve in curves:
        axes.plot(bundle.at, curve, color=palette.drawn(name), linewidth=0.7, alpha=0.55)
    axes.plot(bundle.at, np.mean(curves, axis=0), color=palette.drawn(name), linewidth=2.0)
    reference = bundle.curves.get(bundle.reference)
    if reference and name != bundle.reference:
        axes.plot(bundle.at, np.mean(reference, axis=0), color=INK, linewidth=1.1, linestyle=(0, (3, 2)))
    axes.set_title(name, color=palette.drawn(name), fontweight="bold")
    _across(axes, bundle.at)
    _upward(axes, scale)
    ends = ", ".join(f"{curve[-1]:.4g}" for curve in curves)
    return svg(figure, f"{bundle.title} over decisions, {name}. {bundle.last}: {ends}.", palette.stand_ins())


def _across(axes: Axes, at: Curve) -> None:
    axes.set_xlim(0, at[-1] + at[0])  # the middles of bins begin half a bin after 0 and end as much before the end
    axes.locator_params(axis="x", nbins=4, integer=True)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value / 1000:g}k" if value >= 1000 else f"{value:g}")


def _upward(axes: Axes, scale: _Scale) -> None:
    axes.grid(axis="y", linewidth=0.5)
    if scale.is_long:
        axes.set_yscale("symlog", linthresh=LINEAR_UP_TO)
        axes.set_yticks(long_ticks(scale.top, (5, 10)))
        axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
        axes.set_ylabel(LONG_LABEL, fontsize=7.5)
    else:
        axes.locator_params(axis="y", nbins=5, integer=True)
    axes.set_ylim(0, scale.top * 1.04)
