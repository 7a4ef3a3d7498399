"""Drawings as SVG inside the page: sharp at any width, in the page's own type and colours."""

from __future__ import annotations

import io
import re
from collections.abc import Mapping
from html import escape
from typing import Any

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tutorstudent.study.pictures.palette import FAINT, INK

STYLE: Any = {
    "svg.fonttype": "none",
    "svg.hashsalt": "tutorstudent",
    "font.family": "sans-serif",
    "font.size": 9.0,
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": FAINT,
    "axes.linewidth": 0.8,
    "axes.facecolor": "none",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": 9.5,
    "axes.titlelocation": "left",
    "axes.titley": 1.0,
    "grid.color": FAINT,
    "figure.facecolor": "none",
    "xtick.color": FAINT,
    "ytick.color": FAINT,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "xtick.labelsize": 8.0,
    "ytick.labelsize": 8.0,
}
PIXEL = 1 / 72
"""In inches: an SVG of matplotlib counts 72 to the inch."""
TOP_PX, RIGHT_PX = 20, 10
_METADATA = {"Creator": None, "Date": None, "Format": None, "Type": None}


def make_sheet(
    width_px: float, height_px: float, *, left_px: float, bottom_px: float, right_px: float = RIGHT_PX
) -> tuple[Figure, Axes]:
    """Return an empty drawing with margins for labels; the axes of drawings of one size are in line."""
    figure = Figure(figsize=(width_px * PIXEL, height_px * PIXEL))
    left, bottom = left_px / width_px, bottom_px / height_px
    return figure, figure.add_axes((left, bottom, 1 - left - right_px / width_px, 1 - bottom - TOP_PX / height_px))


def make_svg(figure: Figure, alt: str, stand_ins: Mapping[str, str], raster_dpi: int = 150) -> str:
    """Return a drawing as an ``<svg>`` element with stand-in colours replaced; `alt` says what it shows."""
    buffer = io.StringIO()
    with mpl.rc_context(STYLE):
        figure.savefig(buffer, format="svg", dpi=raster_dpi, metadata=_METADATA)
    text = buffer.getvalue()
    text = text[text.index("<svg") :]
    text = re.sub(r' id="[^"]*_\d+"', "", text)  # several drawings in one page would repeat them
    text = re.sub(r"#(?:fe|01)[0-9a-f]{4}\b", lambda found: stand_ins.get(found[0], found[0]), text)
    return text.replace("<svg ", f'<svg role="img" aria-label="{escape(alt)}" ', 1)
