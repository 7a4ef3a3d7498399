"""Spreads against the standard library, the interquartile mean against hand and scipy."""

from __future__ import annotations

import math
import statistics

import numpy as np
import pytest
from scipy.stats import trim_mean

from tutorstudent.study.numbers.statistics import interquartile_mean, spread


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


def test_no_run_has_no_spread() -> None:
    with pytest.raises(ValueError, match="no run, no spread"):
        spread([])


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ([7.0], 7.0),
        ([1.0, 2.0, 9.0], 4.0),  # a quarter of three runs is no whole run
        ([9.0, 2.0, 3.0, 0.0], 2.5),
        ([8.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 100.0], 4.5),  # 3, 4, 5, 6 are left
        ([5.0] * 10, 5.0),
    ],
)
def test_the_interquartile_mean_leaves_out_the_lowest_and_the_highest_quarter(
    values: list[float], expected: float
) -> None:
    assert expected == interquartile_mean(values)


@pytest.mark.parametrize("runs", range(1, 24))
def test_the_interquartile_mean_is_scipys_trimmed_mean(runs: int) -> None:
    values = np.random.default_rng(runs).exponential(100, size=runs)
    assert trim_mean(values, 0.25) == pytest.approx(interquartile_mean(values.tolist()))
    assert interquartile_mean(values.tolist()) == spread(values.tolist()).middle
