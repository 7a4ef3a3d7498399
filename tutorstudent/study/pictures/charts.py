"""Small charts of curves, written as SVG without any library: a page has hundreds of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from html import escape
from typing import NamedTuple

import numpy as np
from matplotlib.ticker import MaxNLocator

from tutorstudent.study.numbers.curves import Curve
from tutorstudent.study.pictures.scales import LONG_LABEL, find_long_share, is_long_tailed, make_long_ticks

WIDTH_PX, HEIGHT_PX, LEFT_PX, RIGHT_PX, TOP_PX, BOTTOM_PX = 240, 170, 28, 10, 20, 20
LABEL_PX = 12
"""Wider on the left where the scale has to be explained."""
STEPS = [1, 2, 2.5, 5, 10]


class Axis(NamedTuple):
    """One scale, the same for all charts of a row."""

    limit: float
    """It reaches from 0, or from what is below, to here."""
    ticks: tuple[tuple[float, str], ...]
    """Values and how they are written."""
    share: Callable[[Curve], Curve]
    """How far along values stand, 0 to 1 at the limit."""
    label: str = ""


def make_decision_axis(decisions: float) -> Axis:
    """Return the scale of decisions."""
    ticks = MaxNLocator(4, integer=True, steps=STEPS).tick_values(0, decisions)
    labelled = tuple(
        (tick, f"{tick / 1000:g}k" if tick >= 1000 else f"{tick:g}") for tick in ticks if 0 <= tick <= decisions
    )
    return Axis(decisions, labelled, lambda values: values / decisions)


def make_value_axis(highest: Sequence[float], lowest: float = 0.0, least: float = 1.0) -> Axis:
    """Return a scale for curves: linear, or logarithmic where a few are far above the rest.

    Args:
        highest: Highest value of each curve.
        lowest: Lowest of all curves; the scale begins at 0 or below.
        least: The scale reaches at least so far, so that small values look small.
    """
    top, bottom = max([least, *highest]), min(0.0, lowest)
    limit = top + 0.04 * (top - bottom)
    if is_long_tailed(highest) and not bottom:
        return Axis(
            limit,
            _make_ticks(make_long_ticks(top, (5, 10))),
            lambda values: find_long_share(values, limit),
            LONG_LABEL,
        )
    ticks = MaxNLocator(5, integer=least >= 1, steps=STEPS).tick_values(bottom, top)
    labelled = _make_ticks([tick for tick in ticks if bottom <= tick <= limit])
    return Axis(limit, labelled, lambda values: (values - bottom) / (limit - bottom))


def _make_ticks(ticks: Sequence[float]) -> tuple[tuple[float, str], ...]:
    return tuple((float(tick), f"{tick:g}") for tick in ticks)


class Chart:
    """Curves over decisions. The page's style sheet says what they look like.

    >>> chart = Chart(make_decision_axis(10.0), make_value_axis([4.0]))
    >>> chart.add_curve(np.array([0.0, 10.0]), np.array([0.0, 4.0]), "run", "red")
    >>> '<path class="run" style="stroke:red" d="M28 150L230 25"/>' in chart.make_svg("2A", "red", "What it shows")
    True
    """

    def __init__(self, along: Axis, up: Axis) -> None:
        self._along, self._up = along, up
        self._left_px = LEFT_PX + (LABEL_PX if up.label else 0)
        self._curves: list[str] = []

    def add_curve(self, at: Curve, values: Curve, kind: str, colour: str) -> None:
        """Add a curve, points that are NaN left out; `kind` is its class in the style sheet, `colour` a CSS one."""
        there = np.isfinite(values)
        if not there.any():
            return
        xs, ys = self._x(at[there]), self._y(values[there])
        points = "L".join(f"{x:.4g} {y:.4g}" for x, y in zip(xs, ys, strict=True))
        self._curves.append(f'<path class="{kind}" style="stroke:{colour}" d="M{points}"/>')

    def make_svg(self, title: str, colour: str, alt: str) -> str:
        """Return the chart as an element; `alt` says what it shows."""
        return (
            f'<svg role="img" aria-label="{escape(alt)}" class="chart" viewBox="0 0 {WIDTH_PX} {HEIGHT_PX}">'
            f'<text class="title" style="fill:{colour}" x="{self._left_px}" y="14">{escape(title)}</text>'
            f"{self._draw_scales()}{''.join(self._curves)}</svg>"
        )

    def _draw_scales(self) -> str:
        bottom, right = HEIGHT_PX - BOTTOM_PX, WIDTH_PX - RIGHT_PX
        xs = self._x(np.array([tick for tick, _ in self._along.ticks]))
        ys = self._y(np.array([tick for tick, _ in self._up.ticks]))
        grid = "".join(f"M{self._left_px} {y:.4g}H{right}" for y in ys)
        marks = "".join(f"M{x:.4g} {bottom}v3.5" for x in xs)
        under = zip(xs, self._along.ticks, strict=True)
        beside = zip(ys, self._up.ticks, strict=True)
        return (
            f'<path class="grid" d="{grid}"/>'
            f'<path class="axis" d="M{self._left_px} {TOP_PX}V{bottom}H{right}{marks}"/>'
            + "".join(f'<text class="under" x="{x:.4g}" y="{bottom + 13}">{text}</text>' for x, (_, text) in under)
            + "".join(
                f'<text class="beside" x="{self._left_px - 5}" y="{y + 3:.4g}">{text}</text>' for y, (_, text) in beside
            )
            + self._make_explanation()
        )

    def _make_explanation(self) -> str:
        middle = (TOP_PX + HEIGHT_PX - BOTTOM_PX) / 2
        text = f'<text class="along" transform="translate(9 {middle:g}) rotate(-90)">{escape(self._up.label)}</text>'
        return text if self._up.label else ""

    def _x(self, decisions: Curve) -> Curve:
        return self._left_px + self._along.share(decisions) * (WIDTH_PX - RIGHT_PX - self._left_px)

    def _y(self, values: Curve) -> Curve:
        bottom = HEIGHT_PX - BOTTOM_PX
        return bottom - self._up.share(values) * (bottom - TOP_PX)
