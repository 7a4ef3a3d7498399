"""Gain against harm: the numbers in closed form, and a picture in which every run is a mark."""

from __future__ import annotations

import re
from math import sqrt
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from tutorstudent.study.numbers.gains import Gains, Outcome, Row, find_gains
from tutorstudent.study.numbers.traces import Counted, Trace, Traces
from tutorstudent.study.pictures.labels import Box, place_labels
from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.pictures.scatter import DISC, RING, draw_scatter
from tutorstudent.study.plans.plan import Environment, Variant

SEEDS = (4, 5, 6)
HARM = "collided decisions"


def trace(seed: int, found: float | None, harmed: float, decisions: int = 5_000) -> Trace:
    return Trace(seed, decisions, found, {HARM: np.array([0.0, harmed])}, {}, None, None)


def traces(**rows: list[Trace]) -> Traces:
    return Traces(Counted({}, "collided", "prey"), rows, {})


PLACE = Environment("cave", (), "alone")


def test_a_gain_is_the_difference_to_the_tutor_alone_on_the_same_seed() -> None:
    alone = [trace(seed, found, 0) for seed, found in zip(SEEDS, (10, 20, 60), strict=True)]
    ours = [trace(seed, found, harmed) for seed, found, harmed in zip(SEEDS, (13, 22, 61), (0, 1, 5), strict=True)]
    found = find_gains(PLACE, traces(alone=alone, learner=ours[::-1]))
    assert found is not None
    assert ("prey", "collided", "alone", 30.0) == found[:4]
    assert (Outcome(10.0, 1.0), Outcome(2.0, 2.0), Outcome(0.0, 3.0)) == found.rows["learner"].runs
    assert Outcome(4.0, 2.0) == found.rows["learner"].mean
    assert (sqrt((36 + 4 + 16) / 2), 1.0) == pytest.approx(found.rows["learner"].sd)
    assert (Outcome(0.0, 0.0),) * 3 == found.rows["alone"].runs


def test_harm_is_referred_to_ten_thousand_decisions_whatever_the_length_of_a_run() -> None:
    found = find_gains(PLACE, traces(alone=[trace(4, 1, 0)], learner=[trace(4, 1, 3, decisions=100)]))
    assert found is not None
    assert 300.0 == found.rows["learner"].runs[0].harm
    assert Outcome(0.0, 0.0) == found.rows["learner"].sd


def test_a_run_without_a_partner_has_no_gain() -> None:
    found = find_gains(PLACE, traces(alone=[trace(4, 1, 0)], learner=[trace(4, 3, 0), trace(5, 9, 0)], gone=[]))
    assert found is not None
    assert (Outcome(0.0, 2.0),) == found.rows["learner"].runs
    assert "gone" not in found.rows


def test_without_a_goal_or_tutor_alone_there_is_no_gain() -> None:
    assert find_gains(PLACE, traces(alone=[trace(4, None, 0)], learner=[trace(4, 1, 0)])) is None
    assert find_gains(PLACE, traces(learner=[trace(4, 1, 0)])) is None
    assert find_gains(PLACE._replace(reference=""), traces(learner=[trace(4, 1, 0)])) is None


def rows(count: int) -> dict[str, Row]:
    rng = np.random.default_rng(8)
    found = {}
    for i in range(count):
        runs = tuple(Outcome(float(harm), float(gain)) for harm, gain in rng.uniform(0, 40, (4, 2)))
        found[f"a-rather-long-name-{i}"] = Row(runs, Outcome(*np.mean(runs, axis=0)), Outcome(2.0, 2.0))
    return found


def palette_of(names: object) -> Palette:
    return Palette([Variant(str(name), "", False, {}, {}) for name in names])  # type: ignore[attr-defined]


def test_the_picture_has_a_mark_for_each_run_and_a_name_for_each_mean() -> None:
    shown = rows(3)
    drawn = draw_scatter(Gains("prey", "collided", "alone", 8.0, shown), palette_of(shown), controls=())
    ET.fromstring(drawn)
    for i, name in enumerate(shown):
        assert 4 + 1 == len(re.findall(rf'<use [^>]*style="fill: var\(--v{i}\)', drawn))
        assert 1 == len(re.findall(rf">{name}</text>", drawn))
        assert f"{name}: {shown[name].mean.gain:+.4g} at {shown[name].mean.harm:.4g}" in drawn
    assert "0.1\N{NO-BREAK SPACE}%" in drawn
    assert "+200 %" in drawn


def test_where_nobody_gained_anything_the_scale_says_one_more_and_one_less() -> None:
    same = {name: Row((Outcome(0.0, 0.0),) * 2, Outcome(0.0, 0.0), Outcome(0.0, 0.0)) for name in ("alone", "2A")}
    drawn = draw_scatter(Gains("prey", "collided", "alone", 0.0, same), palette_of(same), controls=())
    labels = re.findall(r">([-+\N{MINUS SIGN}]?[\d.,]+)</text>", drawn)
    assert 1 == labels.count("+1") == labels.count("\N{MINUS SIGN}1")
    assert not {"+0", "-0", "\N{MINUS SIGN}0"} & set(labels)
    assert " %" not in drawn


def test_small_gains_are_not_all_written_as_0() -> None:
    shown = {"alone": Row((Outcome(0.0, 0.0),), Outcome(0.0, 0.0), Outcome(0.0, 0.0))}
    shown |= {"2A": Row((Outcome(0.0, 0.3),), Outcome(0.0, 0.3), Outcome(0.0, 0.0))}
    drawn = draw_scatter(Gains("reward", "violated", "alone", 0.0, shown), palette_of(shown), controls=())
    assert {"+0.1", "+0.2", "+0.3"} <= set(re.findall(r">([-+][\d.]+)</text>", drawn))
    assert ">+0<" not in drawn


def test_means_of_controls_are_rings_in_which_a_learner_that_comes_to_the_same_is_seen() -> None:
    row = Row((Outcome(3.0, 5.0),), Outcome(3.0, 5.0), Outcome(0.0, 0.0))
    shown = {"learner": row, "blind": row}
    drawn = draw_scatter(Gains("prey", "collided", "alone", 8.0, shown), palette_of(shown), controls=["blind"])
    assert 1 == len(re.findall(r'<use [^>]*style="fill: var\(--v0\); stroke: var\(--v0\)', drawn))
    assert 1 == len(re.findall(r'<use [^>]*style="fill-opacity: 0; stroke: var\(--v1\)', drawn))
    assert drawn.index("stroke: var(--v0)") < drawn.index("fill-opacity: 0; stroke")
    assert DISC < RING - 2


@pytest.mark.parametrize("harm", [0.0, 3.0, 9_000.0])
def test_the_picture_shows_zero_and_the_budget_whatever_the_harm(harm: float) -> None:
    row = Row((Outcome(harm, 0.0),), Outcome(harm, 0.0), Outcome(0.0, 0.0))
    drawn = draw_scatter(Gains("prey", "collided", "alone", 0.0, {"x": row}), palette_of("x"), controls=())
    ticks = re.findall(r"text-anchor: middle[^>]*>([\d,]+)</text>", drawn)
    assert {"0", "10"} <= set(ticks)
    assert " %<" not in drawn.replace("0.1 %", "")


def test_names_neither_hide_each_other_nor_marks() -> None:
    marks = [(100.0 + 3 * i, 100.0 + (i % 3)) for i in range(13)]
    boxes = place_labels(marks, [(60.0, 11.0)] * 13, Box(0, 0, 400, 300))
    for i, box in enumerate(boxes):
        assert box.left >= 0
        assert box.bottom >= 0
        assert all(0 == box.measure_overlap(other) for other in boxes[:i])
        assert not any(box.left < x < box.right and box.bottom < y < box.top for x, y in marks)


def test_a_name_stands_next_to_a_mark_that_is_alone() -> None:
    [box] = place_labels([(50.0, 50.0)], [(40.0, 10.0)], Box(0, 0, 200, 100))
    assert (59.0, 45.0, 99.0, 55.0) == box


def test_a_name_at_the_edge_stands_inside() -> None:
    [box] = place_labels([(195.0, 95.0)], [(40.0, 10.0)], Box(0, 0, 200, 100))
    assert 40.0 * 10.0 == box.measure_overlap(Box(0, 0, 200, 100))


def test_a_name_avoids_dots() -> None:
    dots = [(70.0 + 4 * i, 50.0) for i in range(6)]
    [box] = place_labels([(50.0, 50.0)], [(40.0, 10.0)], Box(0, 0, 200, 100), dots)
    assert not any(box.left < x < box.right and box.bottom < y < box.top for x, y in dots)
