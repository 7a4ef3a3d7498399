"""Maps of where runs collided, and what stands behind them."""

from __future__ import annotations

import re
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from tutorstudent.core.roles.world import Sketch
from tutorstudent.core.running.arrays import Arrays
from tutorstudent.study.numbers.traces import Counted, Trace, Traces
from tutorstudent.study.pictures.galleries import make_harm_gallery, make_way_gallery
from tutorstudent.study.pictures.harms import draw_harm_map, find_harms
from tutorstudent.study.pictures.maps import draw_way_map, split_way
from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.plans.plan import Environment, Variant

SKETCH = Sketch([([(0.0, 0.0), (2.0, 0.0), (2.0, 1.0)], "grey")], [((1.0, 0.5), 0.2, "red")], [(0.1, 0.2, 3.0, "x")])
NASTY = '<b>"&x'
PALETTE = Palette([Variant(name, "", False, {}, {}) for name in ("a", "b", NASTY)])


def trace(harmed: int, contacts: int | None) -> Trace:
    def some(count: int) -> np.ndarray:
        return np.random.default_rng(count).random((count, 2))

    return Trace(0, 100, None, {}, {}, some(harmed), None if contacts is None else some(contacts))


def drive(decisions: int = 4) -> Arrays:
    return {
        "events": np.random.default_rng(2).random((decisions, 2)),
        "event_names": np.array(["x_m", "y_m"]),
        "resulting_level": np.zeros(decisions),
        "trial_ended": np.arange(decisions) == 1,
    }


def test_harm_is_that_of_all_runs() -> None:
    found = find_harms([trace(3, 1), trace(0, 0), trace(4, 2)])
    assert found is not None
    assert (7, 2) == found.harmed.shape
    assert (3, 2) == found.contacts.shape
    np.testing.assert_array_equal(trace(3, 1).harm_places, found.harmed[:3])


def test_contacts_are_missing_where_the_world_counts_none() -> None:
    found = find_harms([trace(3, None)])
    assert found is not None
    assert (0, 2) == found.contacts.shape


def test_a_world_without_places_or_drawing_has_no_map_of_harm() -> None:
    nowhere = Trace(0, 100, None, {}, {}, None, None)
    assert find_harms([nowhere]) is None
    assert find_harms([]) is None
    assert draw_harm_map("a", SKETCH, [nowhere], None, PALETTE) is None
    assert draw_harm_map("a", Sketch(), [trace(1, 1)], None, PALETTE) is None


@pytest.mark.parametrize("count", [0, 1, 30, 5_000])
def test_a_map_is_well_formed_and_says_how_much_it_shows(count: int) -> None:
    drawn = draw_harm_map(NASTY, SKETCH, [trace(count, count // 2), trace(2, 1)], drive(), PALETTE)
    assert drawn is not None
    root = ET.fromstring(drawn)
    words = f"Map of where {NASTY} was harmed, all 2 runs: {count + 2} decisions, {count // 2 + 1} contacts."
    assert words == root.get("aria-label")
    assert re.search(r'xlink:href="data:image/png;base64,', drawn)


def test_a_way_has_a_gap_where_a_trial_ended() -> None:
    points = np.arange(8.0).reshape(4, 2)
    pieces = split_way(points, drive())
    assert [False, False, True, False, False] == np.isnan(pieces[:, 0]).tolist()
    np.testing.assert_array_equal(points, pieces[~np.isnan(pieces[:, 0])])


def test_every_variant_has_a_map_of_harm_and_no_control_a_map_of_its_way() -> None:
    variants = (Variant("b", "", True, {}, {}), Variant("a", "", False, {}, {}), Variant(NASTY, "", False, {}, {}))
    environment = Environment("room", variants, NASTY)
    names = [variant.name for variant in variants]
    found = Traces(Counted({}, "collided"), {n: [trace(2, 1)] for n in names}, {n: drive() for n in names})
    harmed = make_harm_gallery(found, SKETCH, PALETTE)
    assert ["b", "a", NASTY] == [_named(figure) for figure in harmed.figures]
    assert "Every collided decision of all runs is a dot" in harmed.note
    assert "a ring where a contact began" in harmed.note
    ways = make_way_gallery(environment, found, SKETCH, 5, PALETTE)
    assert [NASTY, "a"] == [_named(figure) for figure in ways.figures]
    assert "seed 5" in ways.note


def test_where_the_world_knows_no_collisions_violations_are_shown() -> None:
    found = Traces(Counted({}, "violated"), {"a": [trace(2, None)]}, {})
    shown = make_harm_gallery(found, SKETCH, PALETTE)
    assert "Where conditions were violated" == shown.title
    assert "ring" not in shown.note


def test_a_run_of_one_decision_has_a_map() -> None:
    assert draw_way_map("a", SKETCH, drive(1), PALETTE) is not None


def _named(figure: str) -> str:
    title = ET.fromstring(figure).find(".//{http://www.w3.org/2000/svg}text[@style]/..")
    label = ET.fromstring(figure).get("aria-label", "")
    assert title is not None
    return re.sub(r"^Map of (where|the way of) | was harmed.*|, coloured.*", "", label)
