"""The film: what it shows, how long it is, and that it is a GIF that anything can show."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image, ImageColor, ImageSequence

from tutorstudent.core.roles.world import Sketch
from tutorstudent.core.running.arrays import Arrays
from tutorstudent.study.numbers.traces import Counted, Traces
from tutorstudent.study.pictures.film import DECISIONS, FRAME_MS, FRAMES, make_film
from tutorstudent.study.pictures.galleries import make_film_gallery
from tutorstudent.study.pictures.maps import list_level_colours
from tutorstudent.study.pictures.palette import HARM, MAP_COLOURS
from tutorstudent.study.pictures.shots import HIGHEST_PX, WIDTH_PX, draw_stage, make_shot, make_view
from tutorstudent.study.plans.plan import Environment, Variant

ROOM = Sketch(
    [([(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (0.0, 2.0)], "black"), ([(3.0, 1.0), (3.4, 1.0), (3.4, 1.4)], "red")],
    [((3.0, 0.4), 0.2, "blue")],
    [(0.5, 0.5, 0.0, "green")],
)
EVENTS = ["x_m", "y_m", "heading_rad", "collided", "time_s"]


def drive(decisions: int, events: tuple[str, ...] = tuple(EVENTS)) -> Arrays:
    """From left to right at level 3, with a collision on the way."""
    along = np.linspace(0.5, 2.5, decisions)
    columns = {
        "x_m": along,
        "y_m": np.full(decisions, 1.0),
        "heading_rad": np.zeros(decisions),
        "collided": np.arange(decisions) == decisions // 2,
        "time_s": np.full(decisions, 0.24),
    }
    return {
        "events": np.column_stack([columns[name] for name in events]).astype(float),
        "event_names": np.array(events),
        "resulting_level": np.full(decisions, 3),
        "trial_ended": np.zeros(decisions, dtype=int),
        "violated": np.zeros((decisions, 1), dtype=bool),
        "situation": np.arange(decisions) % 2,
        "situation_names": np.array(["Forward", "Prey Spin"]),
    }


def has(frame: Image.Image, colour: str) -> bool:
    found = frame.convert("RGB").getcolors(1 << 20)
    assert found is not None
    return ImageColor.getrgb(colour) in [each for _, each in found]


def test_a_film_shows_the_end_of_a_run_in_twelve_seconds() -> None:
    taken = make_film("x", ROOM, drive(1_500), {"prey": "Prey Spin"}, "collided")
    assert taken is not None
    assert (301, 1_500, 12.0) == taken[3:6]
    assert 24.0 == pytest.approx(taken.time_lapse)
    with Image.open(io.BytesIO(taken.gif)) as gif:
        assert taken.size == gif.size
        assert 0 == gif.info["loop"]
        durations = [frame.info["duration"] for frame in ImageSequence.Iterator(gif)]
    assert FRAMES * FRAME_MS <= sum(durations) < 1.25 * FRAMES * FRAME_MS
    assert len(taken.gif) < 500_000


def test_a_short_run_is_shown_whole() -> None:
    taken = make_film("x", ROOM, drive(7), {}, "collided")
    assert taken is not None
    assert (1, 7, 7 * FRAME_MS / 1000) == taken[3:6]


def test_the_still_is_the_last_frame_with_the_way_the_level_and_the_collision() -> None:
    taken = make_film("x", ROOM, drive(40), {}, "collided")
    assert taken is not None
    with Image.open(io.BytesIO(taken.still)) as still:
        assert taken.size == still.size
        for colour in (HARM, list_level_colours()[3], MAP_COLOURS["green"], MAP_COLOURS["red"], MAP_COLOURS["blue"]):
            assert has(still, colour)
        assert not has(still, list_level_colours()[8])
    with Image.open(io.BytesIO(taken.gif)) as gif:
        assert not has(gif, HARM)


def test_the_same_run_makes_the_same_film() -> None:
    assert make_film("x", ROOM, drive(9), {}, "collided") == make_film("x", ROOM, drive(9), {}, "collided")


def test_a_world_without_places_has_no_film_and_one_without_a_clock_no_time_lapse() -> None:
    assert make_film("x", ROOM, drive(9, ("collided", "x_m")), {}, "collided") is None
    taken = make_film("x", ROOM, drive(9, ("y_m", "x_m")), {}, "violated")
    assert taken is not None
    assert taken.time_lapse is None


def test_counts_and_levels_are_those_of_the_decision() -> None:
    shown = make_shot(
        "x", drive(5) | {"resulting_level": np.array([0, 1, 8, 9, 1000])}, {"prey": "Prey Spin"}, "collided"
    )
    assert shown is not None
    assert [0, 1, 1, 2, 2] == shown.counts["prey"].tolist()
    assert [0, 0, 1, 1, 1] == shown.counts["collided"].tolist()
    scale = list_level_colours()
    assert [scale[0], scale[1], scale[8], scale[8], scale[8]] == list(shown.colours)


def test_a_view_holds_the_world_and_the_way_upright() -> None:
    seen = make_view(ROOM, np.array([[5.0, -1.0], [0.0, 1.0]]))
    corners = [seen.to_pixels(x, y) for x in (0.0, 5.0) for y in (-1.0, 2.0)]
    assert all(0 <= x <= seen.size[0] and 0 <= y <= seen.size[1] for x, y in corners)
    assert seen.to_pixels(0.0, 2.0)[1] < seen.to_pixels(0.0, -1.0)[1]
    assert seen.to_pixels(0.0, 0.0)[0] < seen.to_pixels(5.0, 0.0)[0]


@pytest.mark.parametrize("way", [[[0.0, 0.0]], [[0.0, 0.0], [0.1, 900.0]], [[0.0, 0.0], [900.0, 0.1]]])
def test_a_frame_is_never_larger_than_a_page_can_show(way: list[list[float]]) -> None:
    seen = make_view(Sketch(), np.array(way))
    assert 2 * WIDTH_PX == seen.size[0]
    assert seen.size[1] <= 2 * (HIGHEST_PX + 100)
    draw_stage(Sketch(), seen)


def test_robots_are_outlines_since_they_do_not_stay_where_they_begin() -> None:
    box = [(2.0, 1.0), (2.4, 1.0), (2.4, 1.4), (2.0, 1.4)]
    seen = make_view(ROOM, np.zeros((1, 2)))
    middle = [round(part) for part in seen.to_pixels(2.2, 1.2)]
    standing = draw_stage(Sketch([*ROOM.polygons, (box, "red")]), seen)
    robot = draw_stage(Sketch([*ROOM.polygons, (box, "red")], poses=[(2.2, 1.2, 0.0, "red")]), seen)
    assert ImageColor.getrgb(MAP_COLOURS["red"]) == standing.getpixel(middle)
    assert ImageColor.getrgb(MAP_COLOURS["red"]) != robot.getpixel(middle)


def environment(*names: str) -> Environment:
    return Environment("room", tuple(Variant(name, "", name == "ramp", {}, {}) for name in names), "alone")


def test_the_page_shows_the_first_run_of_the_first_learner_and_says_so() -> None:
    firsts = {name: drive(12) for name in ("alone", "ramp", "<2A>", "other")}
    found = make_film_gallery(environment(*firsts), Traces(Counted({}, "collided"), {}, firsts), ROOM, 7)
    assert found.note.startswith("&lt;2A&gt;, seed 7, the first run: decisions 1 to 12, 3 times as fast as it was.")
    [figure] = found.figures
    assert figure.count("data:image/gif;base64,") == figure.count("data:image/png;base64,") == 1
    assert figure.index("data:image/png") < figure.index("<details>") < figure.index("data:image/gif")
    assert "<2A>" not in figure


@pytest.mark.parametrize("names", [("alone",), ("alone", "ramp"), ("alone", "gone")])
def test_without_a_learner_or_its_first_run_there_is_no_film(names: tuple[str, ...]) -> None:
    firsts = {name: drive(3) for name in names if name != "gone"}
    found = make_film_gallery(environment(*names), Traces(Counted({}, "collided"), {}, firsts), ROOM, 7)
    assert [] == found.figures


def test_a_film_is_as_long_as_it_says() -> None:
    assert DECISIONS == 8 * FRAMES
