"""Spreads against the standard library, intervals against scipy and against cases with one possible answer."""

from __future__ import annotations

import math
import statistics

import numpy as np
import pytest
from scipy.stats import bootstrap

from tutorstudent.study.statistics import paired_difference, spread


@pytest.mark.parametrize("seed", range(5))
def test_a_spread_is_that_of_the_standard_library(seed: int) -> None:
    values = np.random.default_rng(seed).normal(10, 30, size=seed + 2).tolist()
    found = spread(values)
    assert len(values) == found.runs
    assert statistics.fmean(values) == pytest.approx(found.mean)
    assert statistics.stdev(values) == pytest.approx(found.sd)
    assert statistics.median(values) == pytest.approx(found.median)
    assert max(values) == found.highest


def test_a_single_run_has_no_standard_deviation() -> None:
    assert math.isnan(spread([4.0]).sd)


def test_an_interval_is_scipys_percentile_bootstrap() -> None:
    rng = np.random.default_rng(3)
    ours, theirs = rng.poisson(30, 12), rng.poisson(20, 12)
    found = paired_difference(dict(enumerate(ours)), dict(enumerate(theirs)))
    expected = bootstrap((ours - theirs,), np.mean, n_resamples=50_000, method="percentile", rng=rng)
    assert found is not None
    assert np.mean(ours - theirs) == pytest.approx(found.mean)
    tolerance = 0.05 * expected.standard_error
    assert expected.confidence_interval.low == pytest.approx(found.low, abs=4 * tolerance)
    assert expected.confidence_interval.high == pytest.approx(found.high, abs=4 * tolerance)


def test_an_interval_covers_the_true_difference_about_as_often_as_it_says() -> None:
    rng = np.random.default_rng(8)
    covered = 0
    for _ in range(100):
        found = paired_difference(dict(enumerate(rng.normal(1.0, 1.0, 30))), dict.fromkeys(range(30), 0.0))
        assert found is not None
        covered += found.low <= 1.0 <= found.high
    assert 88 <= covered <= 99


def test_equal_differences_leave_no_doubt() -> None:
    found = paired_difference({0: 5.0, 1: 7.0, 2: 9.0}, {0: 2.0, 1: 4.0, 2: 6.0})
    assert found is not None
    assert (3, 3.0, 3.0, 3.0) == tuple(found)


def test_only_seeds_that_both_have_are_paired() -> None:
    found = paired_difference({0: 5.0, 1: 7.0, 9: 100.0}, {0: 4.0, 1: 6.0, 8: 0.0})
    assert found is not None
    assert (2, 1.0) == (found.pairs, found.mean)
    assert paired_difference({0: 1.0}, {1: 1.0}) is None


def test_one_pair_has_a_difference_and_no_interval() -> None:
    found = paired_difference({4: 5.0}, {4: 2.0})
    assert found is not None
    assert (1, 3.0) == (found.pairs, found.mean)
    assert math.isnan(found.low)
    assert math.isnan(found.high)


def test_the_same_numbers_have_the_same_interval_again() -> None:
    ours, theirs = {i: float(i * i % 7) for i in range(10)}, dict.fromkeys(range(10), 2.0)
    assert paired_difference(ours, theirs) == paired_difference(dict(reversed(ours.items())), theirs)
