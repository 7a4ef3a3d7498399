"""Two rows, run by run: which runs are paired, and what is said of too few of them."""

from __future__ import annotations

import numpy as np
import pytest

from tutorstudent.study.numbers.pairs import Pairs, make_pairs


def pairs(ours: list[float], theirs: list[float]) -> Pairs:
    return Pairs(tuple(range(len(ours))), tuple(ours), tuple(theirs))


def test_only_seeds_that_both_have_are_paired_whatever_their_order() -> None:
    found = make_pairs({9: 100.0, 1: 7.0, 0: 5.0}, {0: 4.0, 8: 0.0, 1: 6.5})
    assert Pairs((0, 1), (5.0, 7.0), (4.0, 6.5)) == found
    assert (1.0, 0.5) == found.differences


def test_without_a_common_seed_there_is_no_pair() -> None:
    assert make_pairs({0: 1.0}, {1: 1.0}) is None
    assert make_pairs({}, {}) is None


def test_one_pair_has_a_difference_and_nothing_else() -> None:
    found = pairs([5.0], [2.0])
    assert (1, 3.0, None) == found.difference()
    assert found.correlation() is None


def test_two_pairs_have_no_interval_and_no_correlation() -> None:
    found = pairs([5.0, 6.0], [2.0, 1.0])
    assert (2, 4.0, None) == found.difference()
    assert found.correlation() is None


@pytest.mark.parametrize("seed", range(3))
def test_the_correlation_is_pearsons(seed: int) -> None:
    x, y = np.random.default_rng(seed).normal(size=(2, 8))
    dx, dy = x - x.mean(), y - y.mean()
    expected = (dx * dy).sum() / np.sqrt((dx**2).sum() * (dy**2).sum())
    assert expected == pytest.approx(pairs(x.tolist(), y.tolist()).correlation())


def test_what_never_changes_correlates_with_nothing() -> None:
    assert pairs([1.0, 1.0, 1.0], [1.0, 2.0, 3.0]).correlation() is None
    assert pairs([1.0, 2.0, 3.0], [0.0, 0.0, 0.0]).correlation() is None


def test_a_tie_is_half_an_improvement_and_less_can_be_better() -> None:
    found = pairs([3.0, 3.0, 1.0, 2.0], [1.0, 3.0, 5.0, 1.0])
    assert 0.625 == found.improvement(1).share  # better, tie, worse, better
    assert 0.375 == found.improvement(-1).share


def test_an_improvement_has_an_interval_that_holds_its_share() -> None:
    for wins in range(6):
        found = pairs([1.0] * wins + [0.0] * (5 - wins), [0.5] * 5).improvement(1)
        assert wins / 5 == found.share
        assert found.interval.low <= found.share <= found.interval.high
        assert found.interval.high - found.interval.low > 0.3
