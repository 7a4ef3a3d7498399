"""Panels of curves: well-formed, every run a line, and points where the numbers are."""

from __future__ import annotations

import re
from collections.abc import Sequence
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from tutorstudent.study.pictures.charts import Chart, make_decision_axis, make_value_axis
from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.pictures.panels import Bundle, draw_panels
from tutorstudent.study.plans.plan import Variant

NASTY = '<i>"&x'
PALETTE = Palette([Variant(name, "", False, {}, {}) for name in ("a", NASTY)])
AT = np.array([500.0, 1_500.0, 2_500.0])


def bundle(**curves: Sequence[Sequence[float]]) -> Bundle:
    found = {name: [np.array(curve) for curve in rows] for name, rows in curves.items()}
    return Bundle("hits", AT, "In the last bin", found, "a")


def paths(drawn: str, kind: str) -> list[str]:
    return [str(found.get("d")) for found in ET.fromstring(drawn).iter("path") if found.get("class") == kind]


def points(path: str) -> list[tuple[float, float]]:
    return [(float(x), float(y)) for x, y in re.findall(r"([\d.]+) ([\d.]+)", path)]


def test_every_run_is_a_line_and_their_mean_another() -> None:
    drawn = draw_panels(bundle(a=[[0, 4, 8], [2, 4, 0]], **{NASTY: [[1, 1, 1]]}), PALETTE)
    assert [2, 1] == [len(paths(panel, "run")) for panel in drawn]
    assert [1, 1] == [len(paths(panel, "mean")) for panel in drawn]
    assert [0, 1] == [len(paths(panel, "reference")) for panel in drawn]


def test_points_stand_where_the_numbers_are() -> None:
    [drawn] = draw_panels(bundle(a=[[0, 4, 8], [2, 4, 0]]), PALETTE)
    mean = points(paths(drawn, "mean")[0])
    width, height, limit = 240 - 10 - 28, 170 - 20 - 20, 8 * 1.04
    expected = [(28 + width * x / 3_000, 150 - height * y / limit) for x, y in zip(AT, (1, 4, 4), strict=True)]
    np.testing.assert_allclose(expected, mean, rtol=1e-3)


def test_a_long_scale_is_linear_up_to_ten_and_logarithmic_beyond() -> None:
    up = make_value_axis([0.0, 1.0, 2.0, 1_000.0])
    assert "logarithmic beyond 10" == up.label
    assert [0, 5, 10, 50, 100, 500, 1_000] == [tick for tick, _ in up.ticks]
    shares = up.share(np.array([0.0, 5.0, 10.0, 100.0, 1_000.0, up.limit]))
    assert (0.0, 1.0) == (shares[0], shares[-1])
    assert shares[1] * 2 == pytest.approx(shares[2])
    np.testing.assert_allclose(np.diff(shares[2:5]), shares[2])


@pytest.mark.parametrize("highest", [[], [0.0], [0.4], [8.0, 8.0], [97.0, 90.0], [0.0, 0.0, 83.0]])
def test_a_scale_begins_at_zero_and_holds_everything(highest: list[float]) -> None:
    up = make_value_axis(highest)
    assert up.limit > max([1.0, *highest])
    assert (0.0, "0") == up.ticks[0]
    assert all(0 <= tick <= up.limit for tick, _ in up.ticks)
    assert len(up.ticks) > 1
    assert (max(highest, default=0.0) == 83.0) == bool(up.label)


@pytest.mark.parametrize("decisions", [1.0, 2.0, 30.0, 10_000.0, 1e6])
def test_decisions_are_marked_from_zero_to_the_end(decisions: float) -> None:
    along = make_decision_axis(decisions)
    assert (0.0, "0") == along.ticks[0]
    assert 2 <= len(along.ticks) <= 6
    assert along.ticks[-1][0] <= decisions


def test_words_are_escaped_and_the_drawing_says_what_it_shows() -> None:
    drawn = draw_panels(bundle(**{NASTY: [[1.0, 2.0, 3.0], [1.0, 2.0, 0.5]]}), PALETTE)[0]
    root = ET.fromstring(drawn)
    assert f"hits over decisions, {NASTY}. In the last bin: 3, 0.5." == root.get("aria-label")
    assert [NASTY] == [text.text for text in root.iter("text") if text.get("class") == "title"]


def test_a_variant_without_runs_has_no_panel() -> None:
    assert 1 == len(draw_panels(bundle(a=[], **{NASTY: [[1, 2, 3]]}), PALETTE))
    assert [] == draw_panels(bundle(a=[]), PALETTE)


def test_a_chart_without_curves_is_well_formed() -> None:
    ET.fromstring(Chart(make_decision_axis(10.0), make_value_axis([])).make_svg("x", "red", "nothing"))


def test_what_is_less_than_nothing_and_what_is_missing_has_its_place_or_none() -> None:
    up = make_value_axis([2.0], -6.0)
    assert "" == up.label
    assert (0.0, 1.0) == tuple(up.share(np.array([-6.0, up.limit])))
    assert min(tick for tick, _ in up.ticks) == -6
    nan = float("nan")
    [drawn] = draw_panels(bundle(a=[[-6, nan, 2], [nan, nan, 0]]), PALETTE)
    assert [2, 1] == [len(points(path)) for path in paths(drawn, "run")]
    assert 2 == len(points(paths(drawn, "mean")[0]))
    assert "nan" not in drawn.partition(">")[2]
    assert [] == paths(draw_panels(bundle(a=[[nan, nan, nan]]), PALETTE)[0], "run")


def test_small_numbers_that_are_no_counts_fill_their_scale() -> None:
    assert 1.0 < make_value_axis([0.02]).limit
    assert 0.03 > make_value_axis([0.02], least=1e-9).limit
