"""How the runs of one row are spread."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np


class Spread(NamedTuple):
    """How the runs of one row are spread."""

    runs: int
    mean: float
    sd: float
    """Of a sample (n - 1), as in the thesis's tables; NaN for a single run."""
    median: float
    highest: float
    middle: float
    """The interquartile mean, see `interquartile_mean`."""


def spread(values: Sequence[float]) -> Spread:
    """Return how values are spread.

    >>> spread([1.0, 2.0, 6.0])
    Spread(runs=3, mean=3.0, sd=2.6457513110645907, median=2.0, highest=6.0, middle=3.0)

    Raises:
        ValueError: if there is none.
    """
    if not len(values):
        raise ValueError("no run, no spread; show a cell without runs as a dash.")
    array = np.asarray(values, dtype=np.float64)
    sd = float(array.std(ddof=1)) if len(array) > 1 else float("nan")
    middle = interquartile_mean(values)
    return Spread(len(array), float(array.mean()), sd, float(np.median(array)), float(array.max()), middle)


def interquartile_mean(values: Sequence[float]) -> float:
    """Return the mean of what is left when the lowest and the highest quarter are cut off.

    A quarter is rounded down to whole runs, so that up to three runs are all kept (Agarwal et al. 2021, "Deep
    reinforcement learning at the edge of the statistical precipice"). Choice: see docs/fidelity.md.

    >>> interquartile_mean([900.0, 1.0, 2.0, 3.0, 4.0])
    3.0
    """
    cut = len(values) // 4
    return float(np.mean(np.sort(np.asarray(values, dtype=np.float64))[cut : len(values) - cut]))
