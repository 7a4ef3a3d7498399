"""How the runs of one controller are spread, and how two controllers differ on the same seeds."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from scipy.special import stdtrit

CONFIDENCE = 0.95
INTERVALS = "95 % interval of the mean after Student"
"""Which interval `Summary.low` and `Summary.high` are. Exact for normal runs; with one or two runs of many collisions
among runs of none it is too wide, and the median beside it says more."""


class Summary(NamedTuple):
    """Numbers of several runs."""

    runs: int
    mean: float
    sd: float
    """Of a sample (n - 1); NaN for a single run."""
    median: float
    low: float
    """Of the interval of the mean; NaN for a single run."""
    high: float


def summarize(values: Sequence[float]) -> Summary:
    """Return how values are spread.

    >>> summarize([2.0, 4.0, 9.0])[:4]
    (3, 5.0, 3.605551275463989, 4.0)
    """
    array = np.asarray(values, dtype=np.float64)
    runs, mean = len(array), float(array.mean())
    sd = float(array.std(ddof=1)) if runs > 1 else math.nan
    half = float(stdtrit(runs - 1, (1 + CONFIDENCE) / 2)) * sd / math.sqrt(runs) if runs > 1 else math.nan
    return Summary(runs, mean, sd, float(np.median(array)), mean - half, mean + half)


def pair_up(ours: Mapping[int, float], theirs: Mapping[int, float]) -> Summary | None:
    """Return the differences over the seeds that both have; None where they have none in common.

    >>> pair_up({0: 5.0, 1: 7.0, 2: 1.0}, {0: 4.0, 1: 4.0}).mean
    2.0
    """
    seeds = sorted(ours.keys() & theirs.keys())
    return summarize([ours[seed] - theirs[seed] for seed in seeds]) if seeds else None


def standard_error_of_difference(sd: float, runs: int, other_sd: float, other_runs: int) -> float:
    """Return the standard error of the difference of two independent means.

    >>> standard_error_of_difference(3.0, 9, 4.0, 16)
    1.4142135623730951
    """
    return math.sqrt(sd**2 / runs + other_sd**2 / other_runs)
