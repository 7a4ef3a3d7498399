"""How far off a mean or a share may be."""

from __future__ import annotations

import math
from functools import lru_cache
from statistics import NormalDist
from typing import NamedTuple

import numpy as np

RESAMPLES = 10_000
CONFIDENCE = 0.95
FEWEST = 3
"""With fewer values there is no interval."""


class Interval(NamedTuple):
    """Where the true value lies, as far as one can tell."""

    low: float
    high: float


@lru_cache(maxsize=10_000)
def bca(values: tuple[float, ...], confidence: float = CONFIDENCE) -> Interval | None:
    """Return the bias-corrected and accelerated bootstrap interval of a mean (Efron 1987, as scipy computes it).

    The resampling has a fixed seed: the same values have the same interval. Its upper bound for a confidence of 0.9 is
    the one-sided bound for 0.95.

    Returns:
        None for fewer than `FEWEST` values; the value itself if all are equal.
    """
    if len(values) < FEWEST:
        return None
    array = np.asarray(values, dtype=np.float64)
    first, width = float(array[0]), float(np.ptp(array))
    if width == 0:
        return Interval(first, first)
    from scipy.stats import bootstrap  # an extra: the rest of the package does without

    # In units of their own width, since third powers of the deviations would vanish or overflow otherwise.
    found = bootstrap(
        ((array - first) / width,),
        np.mean,
        n_resamples=RESAMPLES,
        confidence_level=confidence,
        method="BCa",
        rng=np.random.default_rng(0),
    ).confidence_interval
    return Interval(first + width * float(found.low), first + width * float(found.high))


def wilson(share: float, count: int, confidence: float = CONFIDENCE) -> Interval:
    """Return Wilson's score interval of a share of `count` trials; it has a width for shares of 0 and 1 too.

    >>> low, high = wilson(1.0, 10)
    >>> round(low, 3), high
    (0.722, 1.0)
    """
    z = NormalDist().inv_cdf((1 + confidence) / 2)
    weight = z * z / count
    centre = (share + weight / 2) / (1 + weight)
    half = math.sqrt(weight * share * (1 - share) + weight * weight / 4) / (1 + weight)
    return Interval(max(0.0, centre - half), min(1.0, centre + half))
