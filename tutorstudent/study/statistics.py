"""The few numbers that a table shows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

RESAMPLES = 10_000
CONFIDENCE = 0.95


class Spread(NamedTuple):
    """How the runs of one row are spread."""

    runs: int
    mean: float
    sd: float
    """Of a sample (n - 1); NaN for a single run."""
    median: float
    highest: float


class Difference(NamedTuple):
    """Mean of paired differences, with its interval; the bounds are NaN for a single pair."""

    pairs: int
    mean: float
    low: float
    high: float


def spread(values: Sequence[float]) -> Spread:
    """Return how values are spread.

    >>> spread([1.0, 2.0, 6.0])
    Spread(runs=3, mean=3.0, sd=2.6457513110645907, median=2.0, highest=6.0)
    """
    array = np.asarray(values, dtype=np.float64)
    sd = float(array.std(ddof=1)) if len(array) > 1 else float("nan")
    return Spread(len(array), float(array.mean()), sd, float(np.median(array)), float(array.max()))


def paired_difference(ours: Mapping[int, float], theirs: Mapping[int, float], seed: int = 0) -> Difference | None:
    """Return the mean difference over the seeds that both have, with a percentile bootstrap interval over pairs.

    Args:
        ours: A number for each seed.
        theirs: The same of what it is compared to.
        seed: Of the resampling, so that a report can be made again to the last digit.

    Returns:
        None if they have no seed in common.
    """
    pairs = sorted(ours.keys() & theirs.keys())
    if not pairs:
        return None
    differences = np.array([ours[pair] - theirs[pair] for pair in pairs])
    if len(pairs) == 1:
        return Difference(1, float(differences[0]), float("nan"), float("nan"))
    drawn = np.random.default_rng(seed).integers(len(pairs), size=(RESAMPLES, len(pairs)))
    tail = (1 - CONFIDENCE) / 2
    low, high = np.quantile(differences[drawn].mean(axis=1), [tail, 1 - tail])
    return Difference(len(pairs), float(differences.mean()), float(low), float(high))
