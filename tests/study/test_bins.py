"""Learning curves per thousand decisions, against sums over slices."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import tutorstudent as ts
from tutorstudent.study.numbers.curves import (
    average_bins,
    describe_point,
    make_edges,
    make_learning_curve,
    make_middles,
    name_curve,
)


@pytest.mark.parametrize(
    ("decisions", "bins"), [(1, 1), (3, 3), (10, 10), (60, 10), (4_999, 10), (5_000, 5), (10_000, 10), (10_999, 10)]
)
def test_a_run_has_as_many_bins_as_thousands_and_a_short_one_has_ten(decisions: int, bins: int) -> None:
    ends = make_edges(decisions)
    assert (0, decisions) == (ends[0], ends[-1])
    assert bins == len(ends) - 1
    assert np.ptp(np.diff(ends)) <= 1
    assert bins == len(make_middles(decisions))


def test_ten_thousand_decisions_are_cut_at_the_thousands() -> None:
    assert list(range(0, 10_001, 1_000)) == make_edges(10_000).tolist()
    assert list(range(500, 10_000, 1_000)) == make_middles(10_000).tolist()


@pytest.mark.parametrize("decisions", [1, 7, 23, 60, 5_001, 10_500])
def test_a_bin_is_the_mean_of_its_decisions(decisions: int) -> None:
    values = np.random.default_rng(3).random(decisions)
    ends = make_edges(decisions)
    expected = [values[begin:end].mean() for begin, end in itertools.pairwise(ends)]
    np.testing.assert_allclose(expected, average_bins(values))


def test_rates_times_widths_add_up_to_the_total() -> None:
    happened = np.random.default_rng(4).random(10_777) < 0.01
    rates = 1_000 * average_bins(happened.astype(float))
    assert happened.sum() == pytest.approx(np.sum(rates * np.diff(make_edges(10_777))) / 1_000)


@pytest.mark.parametrize(
    ("decisions", "words"),
    [
        (10_000, "1,000 decisions"),
        (10_500, "1,050 decisions"),
        (5_000, "1,000 decisions"),
        (4_000, "a tenth of the run, 400 decisions"),
        (60, "a tenth of the run, 6 decisions"),
        (7, "a decision"),
        (1, "a decision"),
    ],
)
def test_the_width_of_a_bin_is_said(decisions: int, words: str) -> None:
    assert words == describe_point(decisions)


@pytest.mark.parametrize(
    ("summed", "unit", "expected"),
    [
        ("sum", "", [500.0, 0.0, 4000.0]),
        ("max", "", [1.0, np.nan, 5.0]),
        ("mean", "", [1.0, np.nan, 4.0]),
        ("last", "", [1.0, np.nan, 4.0]),
        ("mean", "%", [100.0, np.nan, 400.0]),
    ],
)
def test_a_learning_curve_is_of_the_decisions_that_have_a_number(
    monkeypatch: pytest.MonkeyPatch, summed: str, unit: str, expected: list[float]
) -> None:
    monkeypatch.setattr("tutorstudent.study.numbers.curves.TENTHS", 3)
    measure = ts.Measure("x", unit=unit, summed=summed)  # type: ignore[arg-type]
    values = np.array([1.0, np.nan, np.nan, np.nan, 3.0, 5.0])
    np.testing.assert_array_equal(expected, make_learning_curve(values, measure))


def test_a_curve_says_what_its_points_are() -> None:
    harm = ts.Measure("collided", "collided decisions")
    assert "collided decisions per 1,000" == name_curve(harm)
    assert "effort, J per 1,000 decisions" == name_curve(ts.Measure("effort", unit="J"))
    assert "hardest, N" == name_curve(ts.Measure("hardest", unit="N", summed="max"))
