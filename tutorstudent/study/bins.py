"""Rates instead of totals: what happened in each thousand decisions."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tutorstudent.study.curves import Curve

DECISIONS = 1_000
"""A point of a learning curve covers this many decisions. Choice: see docs/fidelity.md."""
FEWEST = 5
"""Runs in which that would make fewer points than this are cut into `TENTHS`."""
TENTHS = 10


def edges(decisions: int) -> NDArray[np.int_]:
    """Return where bins begin and end, shape (bins + 1,): as many thousands as a run has, or its tenths.

    What is left over of a thousand is spread over all bins, so that no bin is shorter than the others by more than one.

    >>> edges(6_000).tolist(), edges(30).tolist()
    ([0, 1000, 2000, 3000, 4000, 5000, 6000], [0, 3, 6, 9, 12, 15, 18, 21, 24, 27, 30])
    """
    bins = decisions // DECISIONS if decisions >= FEWEST * DECISIONS else min(TENTHS, decisions)
    return np.linspace(0, decisions, bins + 1).round().astype(int)


def middles(decisions: int) -> Curve:
    """Return the middle of every bin, in decisions."""
    ends = edges(decisions)
    return np.asarray((ends[:-1] + ends[1:]) / 2, dtype=np.float64)


def binned(values: NDArray[np.float64]) -> Curve:
    """Return the mean in every bin of something that each decision has, shape (bins,).

    >>> binned(np.array([0.0, 1.0, 1.0, 0.0])).tolist()
    [0.0, 1.0, 1.0, 0.0]
    """
    ends = edges(len(values))
    sums = np.concatenate([[0.0], np.cumsum(values)])[ends]
    return np.asarray(np.diff(sums) / np.diff(ends), dtype=np.float64)


def covers(decisions: int) -> str:
    """Return in words what a point of a learning curve covers.

    >>> covers(10_000), covers(60)
    ('1,000 decisions', 'a tenth of the run, 6 decisions')
    """
    bins = len(edges(decisions)) - 1
    if bins == decisions:
        return "a decision"
    width = f"{round(decisions / bins):,} decisions"
    return width if decisions >= FEWEST * DECISIONS else f"a tenth of the run, {width}"
