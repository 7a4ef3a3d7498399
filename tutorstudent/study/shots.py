"""The frames of a film: the learner from above, its way by level, where it collided, and what was counted."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import NamedTuple

import numpy as np
from matplotlib.font_manager import findfont
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from tutorstudent.core.recording import Arrays
from tutorstudent.core.world import Sketch
from tutorstudent.study.curves import Curve, counted, event, harmed, places, total
from tutorstudent.study.maps import HIGHEST_LEVEL, level_scale
from tutorstudent.study.palette import HARM, MAP_COLOURS
from tutorstudent.study.screen import FINER, MARGIN_PX, View, stage, view

BODY_M, BODY_PX = 0.2, 5
"""Radius of the disc that stands for the learner, and the least that can be seen."""
LETTERS_PX = 13


class Shot(NamedTuple):
    """What a film shows, decision by decision."""

    title: str
    places: NDArray[np.float64]
    """Shape (decisions, 2), metres."""
    headings_rad: Curve | None
    levels: NDArray[np.int_]
    colours: Sequence[str]
    """Of each decision's level."""
    harmed: NDArray[np.bool_]
    trial_ended: NDArray[np.bool_]
    counts: Mapping[str, Curve]
    """By title: how often it had happened."""


def shot(title: str, arrays: Arrays, counters: Mapping[str, str], harm: str) -> Shot | None:
    """Return what a film of a run shows; None if the world does not say where the robot is."""
    where = places(arrays)
    if where is None:
        return None
    scale, levels = level_scale(), np.minimum(arrays["resulting_level"], HIGHEST_LEVEL)
    found = {name: counted(arrays, name, situation) for name, situation in counters.items()}
    counts = {name: total(values) for name, values in found.items() if values is not None}
    hurt = harmed(arrays)
    return Shot(
        title,
        where,
        event(arrays, "heading_rad"),
        arrays["resulting_level"],
        [scale[level] for level in levels],
        hurt,
        arrays["trial_ended"].astype(bool),
        counts | {harm: total(hurt)},
    )


def frames(shown: Shot, sketch: Sketch, first: int, count: int) -> Iterator[Image.Image]:
    """Yield about `count` frames, from decision `first` (counted from 0) to the end of the run."""
    seen = view(sketch, shown.places)
    canvas = stage(sketch, seen)
    step = math.ceil((len(shown.levels) - first) / count)
    for begin in range(first, len(shown.levels), step):
        end = min(begin + step, len(shown.levels))
        for decision in range(begin, end):
            _add(ImageDraw.Draw(canvas), shown, seen, decision, is_first=decision == first)
        frame = canvas.copy()
        _draw_learner(ImageDraw.Draw(frame), shown, seen, end - 1)
        _write(ImageDraw.Draw(frame), shown, end - 1)
        yield frame.reduce(FINER)


def _add(draw: ImageDraw.ImageDraw, shown: Shot, seen: View, decision: int, *, is_first: bool) -> None:
    x, y = seen.at(*shown.places[decision])
    if not is_first and not shown.trial_ended[decision - 1]:
        draw.line([seen.at(*shown.places[decision - 1]), (x, y)], fill=shown.colours[decision], width=FINER + 1)
    if shown.harmed[decision]:
        reach = 4.5 * FINER
        draw.ellipse((x - reach, y - reach, x + reach, y + reach), outline=HARM, width=FINER + 1)


def _draw_learner(draw: ImageDraw.ImageDraw, shown: Shot, seen: View, decision: int) -> None:
    x, y = seen.at(*shown.places[decision])
    reach = max(BODY_M * seen.fine_px_per_m, BODY_PX * FINER)
    draw.ellipse((x - reach, y - reach, x + reach, y + reach), fill=MAP_COLOURS["green"])
    if shown.headings_rad is not None:
        heading = shown.headings_rad[decision]
        tip = (x + 1.5 * reach * math.cos(heading), y - 1.5 * reach * math.sin(heading))
        draw.line([(x, y), tip], fill="black", width=FINER + 1)


def _write(draw: ImageDraw.ImageDraw, shown: Shot, decision: int) -> None:
    """Write two lines above the picture: what it is and when, and what was counted by then."""
    left, right, first, second = FINER * MARGIN_PX, draw.im.size[0] - FINER * MARGIN_PX, FINER * 5, FINER * 24
    counted = "   ".join(f"{name} {counts[decision]:.0f}" for name, counts in shown.counts.items())
    draw.text((left, first), shown.title, font=_font("bold"), fill="black")
    draw.text((right, first), f"decision {decision + 1:,}", font=_font("normal"), fill="black", anchor="ra")
    draw.text((left, second), counted, font=_font("normal"), fill="black")
    level, room = f"level {shown.levels[decision]}", FINER * 2
    reach = _font("normal").getlength(level) + 3 * room
    swatch = (right - reach - FINER * LETTERS_PX, second + room, right - reach, second + FINER * LETTERS_PX + room)
    draw.rectangle(swatch, fill=shown.colours[decision])
    draw.text((right, second), level, font=_font("normal"), fill="black", anchor="ra")


@cache
def _font(weight: str) -> ImageFont.FreeTypeFont:
    return ImageFont.truetype(findfont(f"DejaVu Sans:{weight}"), FINER * LETTERS_PX)
