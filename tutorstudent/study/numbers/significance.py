"""Whether differences may be chance: a permutation test of pairs, and Holm's correction for many of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

LEVEL = 0.05
EXACT_UP_TO = 16
"""Pairs; 65,536 ways to set their signs."""
DRAWS = 10_000


@lru_cache(maxsize=10_000)
def sign_flip(differences: tuple[float, ...]) -> float | None:
    """Return the two-sided p of the paired permutation test of the mean difference.

    If nothing but chance told the two of a pair apart, each difference might as well have the other sign. p is the
    share of all ways to set the signs whose mean is at least as far from 0 as the one that was seen. All ways are
    gone through for up to `EXACT_UP_TO` pairs; beyond, `DRAWS` are drawn with a fixed seed, and p is at least
    1 / (DRAWS + 1).

    Returns:
        None for fewer than two pairs, of which nothing can be said.

    >>> sign_flip((1.0, 2.0, 4.0))
    0.25
    """
    if len(differences) < 2:
        return None
    if len(differences) <= EXACT_UP_TO:
        return _find_exact(differences)
    from scipy.stats import permutation_test  # an extra: the rest of the package does without

    found = permutation_test(
        (differences,),
        _mean,
        permutation_type="samples",
        vectorized=True,
        n_resamples=DRAWS,
        rng=np.random.default_rng(0),
    )
    return float(found.pvalue)


def _find_exact(differences: Sequence[float]) -> float:
    # scipy goes through all signs too, in Python: half a second for 16 pairs, against one millisecond.
    sums = np.zeros(1)
    for difference in differences:
        sums = np.concatenate([sums + difference, sums - difference])
    seen = abs(math.fsum(differences))
    rounding = 1e-12 * math.fsum(map(abs, differences))
    return float(np.mean(np.abs(sums) >= seen - rounding))


def _mean(values: NDArray[Any], axis: int) -> Any:
    return np.mean(values, axis=axis)


def holm(ps: Sequence[float]) -> list[float]:
    """Return the p values of one family of tests, corrected for their number after Holm (1979).

    >>> holm([0.01, 0.04, 0.03])
    [0.03, 0.06, 0.06]
    """
    corrected = [0.0] * len(ps)
    least = 0.0
    for rank, i in enumerate(sorted(range(len(ps)), key=ps.__getitem__)):
        least = max(least, min(1.0, (len(ps) - rank) * ps[i]))
        corrected[i] = least
    return corrected


def count_fewest_pairs(tests: int) -> int:
    """Return how many pairs it takes for the smallest p of a family to be able to get below `LEVEL` after Holm.

    With n pairs the smallest p is 2 / 2**n: all differences with one sign.

    >>> count_fewest_pairs(1), count_fewest_pairs(32)
    (6, 11)
    """
    return math.ceil(math.log2(2 * tests / LEVEL))
