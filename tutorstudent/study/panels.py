"""What happened over the decisions: for each variant a small panel with every run, all on one scale."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes

from tutorstudent.study.curves import Curve, thinned
from tutorstudent.study.palette import INK, Palette
from tutorstudent.study.svg import STYLE, sheet, svg

WIDTH_PX, HEIGHT_PX = 240, 170


class Bundle(NamedTuple):
    """One measure over the decisions of every run, by variant."""

    title: str
    curves: Mapping[str, Sequence[Curve]]
    """By variant, in the order of the tables; a curve has shape (decisions,)."""
    reference: str
    """Variant whose mean is drawn into every panel; empty for none."""


def panels(bundle: Bundle, palette: Palette) -> list[str]:
    """Return an SVG for each variant that has runs."""
    top = max((float(curve.max()) for curves in bundle.curves.values() for curve in curves), default=1.0)
    with mpl.rc_context(STYLE):
        return [_panel(bundle, name, top, palette) for name, curves in bundle.curves.items() if curves]


def _panel(bundle: Bundle, name: str, top: float, palette: Palette) -> str:
    figure, axes = sheet(WIDTH_PX, HEIGHT_PX, left_px=28, bottom_px=20)
    curves = bundle.curves[name]
    at = thinned(min(len(curve) for curve in curves))
    decisions = at + 1
    for curve in curves:
        axes.plot(decisions, curve[at], color=palette.drawn(name), linewidth=0.7, alpha=0.55)
    axes.plot(decisions, _mean(curves, at), color=palette.drawn(name), linewidth=2.0)
    reference = bundle.curves.get(bundle.reference)
    if reference and name != bundle.reference:
        axes.plot(decisions, _mean(reference, at), color=INK, linewidth=1.1, linestyle=(0, (3, 2)))
    axes.set_title(name, color=palette.drawn(name), fontweight="bold")
    axes.set_ylim(0, max(top, 1.0) * 1.04)
    axes.set_xlim(0, float(decisions[-1]))
    _ticks(axes)
    ends = ", ".join(f"{curve[-1]:.4g}" for curve in curves)
    return svg(figure, f"{bundle.title} over decisions, {name}. At the end of each run: {ends}.", palette.stand_ins())


def _mean(curves: Sequence[Curve], at: Curve) -> Curve:
    shortest = min(len(curve) for curve in curves)
    return np.asarray(np.mean([curve[at[at < shortest]] for curve in curves], axis=0), dtype=np.float64)


def _ticks(axes: Axes) -> None:
    axes.locator_params(axis="x", nbins=4)
    axes.locator_params(axis="y", nbins=5)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value / 1000:g}k" if value >= 1000 else f"{value:g}")
    axes.grid(axis="y", linewidth=0.5, alpha=0.5)
