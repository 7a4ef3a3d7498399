"""The frames of a film: the learner from above, its way by level, where it collided, and what was counted."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import NamedTuple

import numpy as np
from matplotlib.font_manager import findfont
from matplotlib.path import Path as Outline
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from tutorstudent.core.roles.world import Point, Sketch
from tutorstudent.core.running.arrays import Arrays
from tutorstudent.study.numbers.curves import Curve, count_by_decision, find_harm, read_event, read_points, sum_up
from tutorstudent.study.pictures.maps import COLOURED_LEVELS, list_level_colours
from tutorstudent.study.pictures.palette import FLOOR, HARM, MAP_COLOURS, WALL

BODY_M, BODY_PX = 0.2, 5
"""Radius of the disc that stands for the learner, and the least that can be seen."""
LETTERS_PX = 13


class Shot(NamedTuple):
    """What a film shows, decision by decision."""

    title: str
    points: NDArray[np.float64]
    """Shape (decisions, 2), metres."""
    headings_rad: Curve | None
    levels: NDArray[np.int_]
    colours: Sequence[str]
    """Of each decision's level."""
    harmed: NDArray[np.bool_]
    trial_ended: NDArray[np.bool_]
    counts: Mapping[str, Curve]
    """By title: how often it had happened."""


def make_shot(title: str, arrays: Arrays, counters: Mapping[str, str], harm: str) -> Shot | None:
    """Return what a film of a run shows; None if the world does not say where the robot is."""
    where = read_points(arrays)
    if where is None:
        return None
    scale, levels = list_level_colours(), np.minimum(arrays["resulting_level"], COLOURED_LEVELS)
    found = {name: count_by_decision(arrays, name, situation) for name, situation in counters.items()}
    counts = {name: sum_up(values) for name, values in found.items() if values is not None}
    hurt = find_harm(arrays)
    return Shot(
        title,
        where,
        read_event(arrays, "heading_rad"),
        arrays["resulting_level"],
        [scale[level] for level in levels],
        hurt,
        arrays["trial_ended"].astype(bool),
        counts | {harm: sum_up(hurt)},
    )


def draw_frames(shot: Shot, sketch: Sketch, first: int, count: int) -> Iterator[Image.Image]:
    """Yield about `count` frames, from decision `first` (counted from 0) to the end of the run."""
    seen = make_view(sketch, shot.points)
    canvas = draw_stage(sketch, seen)
    step = math.ceil((len(shot.levels) - first) / count)
    for begin in range(first, len(shot.levels), step):
        end = min(begin + step, len(shot.levels))
        for decision in range(begin, end):
            _add(ImageDraw.Draw(canvas), shot, seen, decision, is_first=decision == first)
        frame = canvas.copy()
        _draw_learner(ImageDraw.Draw(frame), shot, seen, end - 1)
        _write(ImageDraw.Draw(frame), shot, end - 1)
        yield frame.reduce(FINER)


def _add(draw: ImageDraw.ImageDraw, shot: Shot, seen: View, decision: int, *, is_first: bool) -> None:
    x, y = seen.to_pixels(*shot.points[decision])
    if not is_first and not shot.trial_ended[decision - 1]:
        draw.line([seen.to_pixels(*shot.points[decision - 1]), (x, y)], fill=shot.colours[decision], width=FINER + 1)
    if shot.harmed[decision]:
        reach = 4.5 * FINER
        draw.ellipse((x - reach, y - reach, x + reach, y + reach), outline=HARM, width=FINER + 1)


def _draw_learner(draw: ImageDraw.ImageDraw, shot: Shot, seen: View, decision: int) -> None:
    x, y = seen.to_pixels(*shot.points[decision])
    reach = max(BODY_M * seen.fine_px_per_m, BODY_PX * FINER)
    draw.ellipse((x - reach, y - reach, x + reach, y + reach), fill=MAP_COLOURS["green"])
    if shot.headings_rad is not None:
        heading = shot.headings_rad[decision]
        tip = (x + 1.5 * reach * math.cos(heading), y - 1.5 * reach * math.sin(heading))
        draw.line([(x, y), tip], fill="black", width=FINER + 1)


def _write(draw: ImageDraw.ImageDraw, shot: Shot, decision: int) -> None:
    """Write two lines above the picture: what it is and when, and what was counted by then."""
    left, right, first, second = FINER * MARGIN_PX, draw.im.size[0] - FINER * MARGIN_PX, FINER * 5, FINER * 24
    counted = "   ".join(f"{name} {counts[decision]:.0f}" for name, counts in shot.counts.items())
    draw.text((left, first), shot.title, font=_load_font("bold"), fill="black")
    draw.text((right, first), f"decision {decision + 1:,}", font=_load_font("normal"), fill="black", anchor="ra")
    draw.text((left, second), counted, font=_load_font("normal"), fill="black")
    level, room = f"level {shot.levels[decision]}", FINER * 2
    reach = _load_font("normal").getlength(level) + 3 * room
    swatch = (right - reach - FINER * LETTERS_PX, second + room, right - reach, second + FINER * LETTERS_PX + room)
    draw.rectangle(swatch, fill=shot.colours[decision])
    draw.text((right, second), level, font=_load_font("normal"), fill="black", anchor="ra")


@cache
def _load_font(weight: str) -> ImageFont.FreeTypeFont:
    return ImageFont.truetype(findfont(f"DejaVu Sans:{weight}"), FINER * LETTERS_PX)


WIDTH_PX, HEAD_PX, MARGIN_PX = 480, 46, 10
FINER = 2
"""Frames are drawn this many times larger and made smaller, so that lines are smooth."""
HIGHEST_PX = 640


class View(NamedTuple):
    """Where metres stand on a frame, counted in fine pixels."""

    fine_px_per_m: float
    left_m: float
    top_m: float
    size: tuple[int, int]
    """Of the fine frame."""

    def to_pixels(self, x_m: float, y_m: float) -> Point:
        """Return a point of the world in pixels."""
        margin = FINER * MARGIN_PX
        x = margin + (x_m - self.left_m) * self.fine_px_per_m
        return x, margin + FINER * HEAD_PX + (self.top_m - y_m) * self.fine_px_per_m


def make_view(sketch: Sketch, way: NDArray[np.float64]) -> View:
    """Return a view that holds the world and the way through it, shape (n, 2), metres."""
    points = np.array([point for outline, _ in sketch.polygons for point in outline], dtype=np.float64).reshape(-1, 2)
    discs = [(x + side * radius, y + side * radius) for (x, y), radius, _ in sketch.discs for side in (-1, 1)]
    every = np.concatenate([points, np.reshape(discs, (-1, 2)), way])
    (left, bottom), (right, top) = np.nanmin(every, axis=0), np.nanmax(every, axis=0)
    width_m, height_m = max(right - left, 1e-3), max(top - bottom, 1e-3)
    room = WIDTH_PX - 2 * MARGIN_PX
    scale = min(room / width_m, (HIGHEST_PX - 2 * MARGIN_PX) / height_m)
    height_px = math.ceil(height_m * scale) + 2 * MARGIN_PX + HEAD_PX
    spare_m = (room / scale - width_m) / 2
    size = (FINER * WIDTH_PX, FINER * height_px)
    return View(FINER * scale, float(left) - spare_m, float(top), size)


def draw_stage(sketch: Sketch, seen: View) -> Image.Image:
    """Return a fine frame with the world alone; robots, which do not stay where they begin, are outlines."""
    image = Image.new("RGB", seen.size, FLOOR)
    draw = ImageDraw.Draw(image)
    draw.rectangle((0, 0, seen.size[0], FINER * HEAD_PX), fill="white")
    for outline, colour in sketch.polygons:
        _draw_outline(draw, [seen.to_pixels(*point) for point in outline], colour, moves=_is_robot(outline, sketch))
    for (x_m, y_m), radius_m, colour in sketch.discs:
        (x, y), radius = seen.to_pixels(x_m, y_m), radius_m * seen.fine_px_per_m
        draw.ellipse((x - radius, y - radius, x + radius, y + radius), fill=MAP_COLOURS.get(colour, WALL))
    return image


def _draw_outline(draw: ImageDraw.ImageDraw, points: Sequence[Point], colour: str, *, moves: bool) -> None:
    body = MAP_COLOURS.get(colour)
    if body and not moves:
        draw.polygon(points, fill=body)
    else:
        draw.line([*points, points[0]], fill=body or WALL, width=FINER if moves else FINER + 1, joint="curve")


def _is_robot(outline: Sequence[Point], sketch: Sketch) -> bool:
    # The outline of a whole arena holds poses too; a robot's is no larger than a metre or so.
    size_m = np.ptp(np.asarray(outline), axis=0).max()
    path = Outline(np.asarray(outline))
    return bool(size_m < 1.5 and any(path.contains_point((x, y)) for x, y, _, _ in sketch.poses))
