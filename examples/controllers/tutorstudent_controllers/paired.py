"""Differences between runs with the same seeds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.stats import bootstrap

RESAMPLES = 10_000
FEWEST = 3
"""Fewer pairs than this have no interval."""


class Difference(NamedTuple):
    """A mean paired difference."""

    mean: float
    interval: tuple[float, float] | None
    """BCa bootstrap, 95 %; none for too few pairs, and one point where all differences are equal."""
    upper: float | None
    """One-sided 95 % bound."""


def difference(ours: Sequence[float], theirs: Sequence[float]) -> Difference:
    """Return how much more ours are, pair by pair.

    >>> difference([1.0, 2.0, 3.0], [0.0, 1.0, 2.0])
    Difference(mean=1.0, interval=(1.0, 1.0), upper=1.0)
    """
    pairs = np.array(ours) - np.array(theirs)
    mean = float(pairs.mean())
    if len(pairs) < FEWEST:
        return Difference(mean, None, None)
    if np.ptp(pairs) == 0:
        return Difference(mean, (mean, mean), mean)
    return Difference(mean, _bounds(pairs, 0.95), _bounds(pairs, 0.90)[1])


def verdict(found: Difference, margin: float) -> str:
    """Say whether a harm is not worse by more than a margin.

    >>> verdict(Difference(1.0, (0.5, 1.5), 1.4), margin=10.0)
    'not worse'
    """
    if found.interval is None or found.upper is None:
        return "too few pairs"
    if found.upper <= margin:
        return "not worse"
    return "worse" if found.interval[0] > margin else "undecided"


def _bounds(pairs: NDArray[np.float64], confidence: float) -> tuple[float, float]:
    rng = np.random.default_rng(0)
    found = bootstrap(
        (pairs,), np.mean, confidence_level=confidence, n_resamples=RESAMPLES, method="BCa", rng=rng
    ).confidence_interval
    return float(found.low), float(found.high)
