"""A short film of the end of a run, as a GIF, which every browser shows."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from PIL import Image, ImageColor

from tutorstudent.core.roles.world import Sketch
from tutorstudent.core.running.arrays import Arrays
from tutorstudent.study.numbers.curves import read_event
from tutorstudent.study.pictures.maps import list_level_colours
from tutorstudent.study.pictures.palette import FLOOR, HARM, MAP_COLOURS, WALL
from tutorstudent.study.pictures.shots import draw_frames, make_shot

DECISIONS = 1_200
"""A film shows this many decisions, the last of the run; all of a shorter run. Choice: see docs/fidelity.md."""
FRAMES, FRAME_MS, LAST_MS = 150, 80, 2_000
SHARES = (1.0, 0.75, 0.5, 0.25)


class Film(NamedTuple):
    """A film, and a still picture for where nothing should move."""

    gif: bytes
    still: bytes
    """The last frame, PNG."""
    size: tuple[int, int]
    """Width and height, px."""
    first: int
    """The decisions that it shows, counted from 1."""
    last: int
    duration_s: float
    """Without the time for which the last frame stays."""
    time_lapse: float | None
    """Simulated seconds in one of the film; None if the world has no clock."""


def make_film(title: str, sketch: Sketch, arrays: Arrays, counters: Mapping[str, str], harm: str) -> Film | None:
    """Return a film of the end of a run; None if the world does not say where the robot is.

    Args:
        title: Stands above it.
        sketch: The world.
        arrays: Every decision.
        counters: What is counted, and the situation whose entries that is.
        harm: What harmed decisions are called.
    """
    shot = make_shot(title, arrays, counters, harm)
    if shot is None:
        return None
    last = len(shot.levels)
    first = max(0, last - DECISIONS)
    taken = _reduce_colours(list(draw_frames(shot, sketch, first, FRAMES)))
    clock = read_event(arrays, "time_s")
    duration_s = len(taken) * FRAME_MS / 1000
    time_lapse = None if clock is None else float(clock[first:].sum()) / duration_s
    return Film(_make_gif(taken), _make_png(taken[-1]), taken[-1].size, first + 1, last, duration_s, time_lapse)


def _reduce_colours(taken: Sequence[Image.Image]) -> list[Image.Image]:
    # With one palette for all frames, only what changes has to be stored.
    palette = Image.new("P", (1, 1))
    palette.putpalette([part for colour in _make_palette() for part in colour])
    return [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in taken]


def _make_palette() -> list[tuple[int, ...]]:
    """Return every colour that a film is drawn with, and what smooth edges make of it on the floor."""
    floor = ImageColor.getrgb(FLOOR)
    inks = [ImageColor.getrgb(colour) for colour in (*list_level_colours(), *MAP_COLOURS.values(), HARM, WALL, "black")]
    mixed = [
        tuple(round(share * a + (1 - share) * b) for a, b in zip(ink, floor, strict=True))
        for ink in inks
        for share in SHARES
    ]
    return [ImageColor.getrgb("white"), floor, *mixed]


def _make_gif(taken: Sequence[Image.Image]) -> bytes:
    buffer = io.BytesIO()
    durations = [*[FRAME_MS] * (len(taken) - 1), LAST_MS]
    taken[0].save(buffer, "GIF", save_all=True, append_images=taken[1:], duration=durations, loop=0, disposal=1)
    return buffer.getvalue()


def _make_png(frame: Image.Image) -> bytes:
    buffer = io.BytesIO()
    frame.save(buffer, "PNG", optimize=True)
    return buffer.getvalue()
