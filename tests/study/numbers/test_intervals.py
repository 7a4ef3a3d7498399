"""Intervals against scipy, against closed forms, and where there is only one possible answer."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest
from scipy.stats import binomtest, bootstrap

from tutorstudent.study.numbers.intervals import RESAMPLES, Interval, bca, wilson

LOPSIDED = (0.0, 0.0, 1.0, 0.0, 3.0, 0.0, 40.0, 2.0, 0.0, 5.0)


@pytest.mark.parametrize("confidence", [0.9, 0.95])
@pytest.mark.parametrize("values", [LOPSIDED, (1.5, 2.0, -1.0), tuple(np.random.default_rng(4).normal(3, 1, 30))])
def test_an_interval_is_scipys_bca_bootstrap(values: tuple[float, ...], confidence: float) -> None:
    expected = bootstrap(
        (values,),
        np.mean,
        confidence_level=confidence,
        n_resamples=RESAMPLES,
        method="BCa",
        rng=np.random.default_rng(0),
    )
    assert tuple(expected.confidence_interval) == pytest.approx(bca(values, confidence))


def test_an_interval_is_efrons_formula() -> None:
    rng = np.random.default_rng(77)
    values = rng.gamma(0.7, 10, size=12)
    expected = bca_by_the_book(values, rng)
    found = bca(tuple(values.tolist()))
    assert found is not None
    # Two independent sets of resamples; the bounds are tail quantiles of them.
    assert expected == pytest.approx(found, rel=0.05)


def bca_by_the_book(values: Sequence[float], rng: np.random.Generator) -> tuple[float, float]:
    """Efron and Tibshirani 1993, equations 14.9 to 14.15."""
    from statistics import NormalDist

    normal, n = NormalDist(), len(values)
    means = np.sort(rng.choice(values, size=(100_000, n)).mean(axis=1))
    z0 = normal.inv_cdf(float(np.mean(means < np.mean(values))))
    without = np.array([np.mean(np.delete(values, i)) for i in range(n)])
    away = without.mean() - without
    a = float((away**3).sum() / (6 * (away**2).sum() ** 1.5))
    ranks = [normal.cdf(z0 + (z0 + z) / (1 - a * (z0 + z))) for z in (normal.inv_cdf(0.025), normal.inv_cdf(0.975))]
    low, high = np.quantile(means, ranks)
    return float(low), float(high)


def test_a_lopsided_sample_has_a_lopsided_interval() -> None:
    found = bca(LOPSIDED)
    assert found is not None
    mean = float(np.mean(LOPSIDED))
    assert found.high - mean > 2 * (mean - found.low)


def test_an_interval_covers_the_true_mean_about_as_often_as_it_says() -> None:
    rng = np.random.default_rng(8)
    found = [bca(tuple(rng.normal(1.0, 1.0, 30).tolist())) for _ in range(100)]
    covered = sum(item is not None and item.low <= 1.0 <= item.high for item in found)
    assert 88 <= covered <= 99


@pytest.mark.parametrize("values", [(), (1.0,), (1.0, 2.0)])
def test_fewer_than_three_values_have_no_interval(values: tuple[float, ...]) -> None:
    assert bca(values) is None


def test_equal_values_leave_no_doubt() -> None:
    assert Interval(3.0, 3.0) == bca((3.0,) * 7)


@pytest.mark.parametrize("scale", [1e-160, 1e-9, 1e9, 1e200])
def test_an_interval_does_not_depend_on_the_unit(scale: float) -> None:
    plain, scaled = bca(LOPSIDED), bca(tuple(value * scale for value in LOPSIDED))
    assert plain is not None
    assert scaled is not None
    assert plain == pytest.approx((scaled.low / scale, scaled.high / scale))


def test_one_run_that_differs_has_an_interval_of_numbers() -> None:
    for count in (3, 10, 40):
        low, high = bca((0.0,) * (count - 1) + (1.0,)) or (math.nan, math.nan)
        assert 0.0 <= low < 1 / count < high <= 1.0


def test_the_same_values_have_the_same_interval_again() -> None:
    before = bca(LOPSIDED)
    bca.cache_clear()
    assert before == bca(LOPSIDED)


@pytest.mark.parametrize(("wins", "count"), [(0, 1), (1, 1), (0, 10), (3, 10), (10, 10), (57, 100)])
def test_the_interval_of_a_share_is_scipys_wilson_interval(wins: int, count: int) -> None:
    expected = binomtest(wins, count).proportion_ci(method="wilson")
    assert (expected.low, expected.high) == pytest.approx(wilson(wins / count, count))


def test_ten_of_ten_are_no_certainty() -> None:
    low, high = wilson(1.0, 10)
    assert 0.72 == round(low, 2)
    assert 1.0 == high
