"""The permutation test against every sign counted one by one, against scipy; Holm against examples by hand."""

from __future__ import annotations

from itertools import pairwise, product

import numpy as np
import pytest
from scipy.stats import permutation_test

from tutorstudent.study.numbers.significance import DRAWS, EXACT_UP_TO, count_fewest_pairs, holm, sign_flip


def by_counting(differences: tuple[float, ...]) -> float:
    seen = abs(sum(differences))
    ways = [
        abs(sum(sign * one for sign, one in zip(signs, differences, strict=True)))
        for signs in product((1, -1), repeat=len(differences))
    ]
    return float(np.mean([way >= seen - 1e-9 for way in ways]))


@pytest.mark.parametrize("pairs", range(2, 11))
@pytest.mark.parametrize("seed", range(3))
def test_p_is_the_share_of_all_signs_that_lie_as_far_out(pairs: int, seed: int) -> None:
    rng = np.random.default_rng(seed)
    whole = tuple(rng.integers(-4, 9, size=pairs).astype(float).tolist())
    broken = tuple(rng.normal(0.5, 1, size=pairs).tolist())
    assert by_counting(whole) == sign_flip(whole)
    assert by_counting(broken) == sign_flip(broken)


@pytest.mark.parametrize("pairs", [2, 5, 10])
def test_p_is_scipys(pairs: int) -> None:
    differences = tuple(np.random.default_rng(pairs).normal(0.4, 1, size=pairs).tolist())
    expected = permutation_test((differences,), np.mean, permutation_type="samples", n_resamples=2**pairs)
    assert expected.pvalue == pytest.approx(sign_flip(differences))


def test_drawn_signs_come_near_to_all_signs() -> None:
    assert EXACT_UP_TO == 16
    assert 2**EXACT_UP_TO == 65_536
    # A pair without a difference makes no difference: the same p, once drawn and once counted.
    few = tuple(np.random.default_rng(5).normal(0.4, 1, size=12).tolist())
    exact, drawn = sign_flip(few), sign_flip((*few, *(0.0,) * 5))
    assert exact is not None
    assert exact == pytest.approx(drawn, abs=4 * (exact * (1 - exact) / DRAWS) ** 0.5 + 1e-4)


def test_drawn_signs_are_the_same_again() -> None:
    many = tuple(np.random.default_rng(5).normal(0.4, 1, size=25).tolist())
    before = sign_flip(many)
    sign_flip.cache_clear()
    assert before == sign_flip(many)


@pytest.mark.parametrize("pairs", [2, 5, 16])
def test_differences_of_one_sign_have_the_smallest_p_there_is(pairs: int) -> None:
    assert 2 / 2**pairs == sign_flip(tuple(float(i + 1) for i in range(pairs)))


def test_beyond_all_signs_the_smallest_p_is_that_of_the_draws() -> None:
    assert 2 / (DRAWS + 1) == pytest.approx(sign_flip((1.0,) * 40), rel=0.51)


@pytest.mark.parametrize("pairs", [2, 10, 16, 20])
def test_no_difference_at_all_is_no_evidence(pairs: int) -> None:
    assert 1.0 == sign_flip((0.0,) * pairs)


def test_one_pair_says_nothing() -> None:
    assert sign_flip((5.0,)) is None
    assert sign_flip(()) is None


def test_rounding_does_not_part_what_is_equal() -> None:
    # 0.1 + 0.2 is not 0.3 to the last bit; counted in tenths it is.
    assert by_counting((1.0, 2.0, -3.0)) == sign_flip((0.1, 0.2, -0.3))


def test_the_direction_does_not_matter() -> None:
    differences = (1.0, 2.0, -0.5, 4.0)
    assert sign_flip(differences) == sign_flip(tuple(-one for one in differences))


def test_holm_multiplies_the_smallest_by_all_the_next_by_one_less() -> None:
    # By hand: 0.005 x 4, 0.01 x 3, 0.03 x 2, 0.04 x 1 but not below the one before.
    assert [0.03, 0.06, 0.06, 0.02] == pytest.approx(holm([0.01, 0.04, 0.03, 0.005]))


@pytest.mark.parametrize(
    ("ps", "expected"), [([], []), ([0.2], [0.2]), ([0.9, 0.8], [1.0, 1.0]), ([0.03, 0.03], [0.06, 0.06])]
)
def test_holm_of_few(ps: list[float], expected: list[float]) -> None:
    assert expected == pytest.approx(holm(ps))


@pytest.mark.parametrize("seed", range(5))
def test_holm_keeps_the_order_raises_everything_and_stays_a_probability(seed: int) -> None:
    ps = np.random.default_rng(seed).random(30).tolist()
    found = holm(ps)
    assert all(p <= one <= min(1.0, 30 * p) for p, one in zip(ps, found, strict=True))
    in_order = [one for _, one in sorted(zip(ps, found, strict=True))]
    assert all(one <= other for one, other in pairwise(in_order))


@pytest.mark.parametrize("tests", [1, 2, 16, 64, 400])
def test_so_many_pairs_it_takes_and_not_one_less(tests: int) -> None:
    pairs = count_fewest_pairs(tests)
    smallest = [2 / 2**one for one in (pairs - 1, pairs)]
    assert holm([smallest[0]] * tests)[0] > 0.05 >= holm([smallest[1]] * tests)[0]
