"""What happened over the decisions: for each variant a small panel with every run, all on one scale."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from tutorstudent.study.numbers.curves import Curve
from tutorstudent.study.pictures.charts import Axis, Chart, make_decision_axis, make_value_axis
from tutorstudent.study.pictures.palette import Palette


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
    is_count: bool = True
    """Whether less than 1 is next to nothing."""


def draw_panels(bundle: Bundle, palette: Palette) -> list[str]:
    """Return an SVG for each variant that has runs."""
    ends = [
        (float(np.nanmin(curve)), float(np.nanmax(curve)))
        for curves in bundle.curves.values()
        for curve in curves
        if np.isfinite(curve).any()
    ]
    least = 1.0 if bundle.is_count else 1e-9
    up = make_value_axis([high for _, high in ends], min((low for low, _ in ends), default=0.0), least)
    # The middles of bins begin half a bin after 0 and end as much before the end.
    along = make_decision_axis(float(bundle.at[-1] + bundle.at[0]))
    return [_draw_panel(bundle, name, (along, up), palette) for name, curves in bundle.curves.items() if curves]


def _draw_panel(bundle: Bundle, name: str, axes: tuple[Axis, Axis], palette: Palette) -> str:
    chart = Chart(*axes)
    curves = bundle.curves[name]
    for curve in curves:
        chart.add_curve(bundle.at, curve, "run", palette.find_css(name))
    chart.add_curve(bundle.at, _mean(curves), "mean", palette.find_css(name))
    reference = bundle.curves.get(bundle.reference)
    if reference and name != bundle.reference:
        chart.add_curve(bundle.at, _mean(reference), "reference", "var(--ink)")
    ends = ", ".join(f"{curve[-1]:.4g}" for curve in curves)
    alt = f"{bundle.title} over decisions, {name}. {bundle.last}: {ends}."
    return chart.make_svg(name, palette.find_css(name), alt)


def _mean(curves: Sequence[Curve]) -> Curve:
    """Return the mean of several curves, shape (points,), of those that have a number there; NaN where none has."""
    there = np.isfinite(curves)
    counts = there.sum(axis=0)
    sums: Curve = np.where(there, curves, 0.0).sum(axis=0)
    return sums / np.where(counts > 0, counts, np.nan)
