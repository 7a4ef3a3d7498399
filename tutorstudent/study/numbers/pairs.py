"""Two rows of a table, run by run on the same seed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from tutorstudent.study.numbers.intervals import CONFIDENCE, FEWEST, Interval, bca, wilson


class Difference(NamedTuple):
    """Mean of paired differences, with its interval."""

    pairs: int
    mean: float
    interval: Interval | None
    """None where there are too few pairs for one."""


class Improvement(NamedTuple):
    """How often ours was the better of a pair, a tie counting half, with Wilson's interval."""

    share: float
    interval: Interval


class Pairs(NamedTuple):
    """Numbers of the seeds that both have; at least one."""

    seeds: tuple[int, ...]
    """In ascending order, as the numbers."""
    ours: tuple[float, ...]
    theirs: tuple[float, ...]

    @property
    def differences(self) -> tuple[float, ...]:
        """Ours less theirs, pair by pair."""
        return tuple(our - their for our, their in zip(self.ours, self.theirs, strict=True))

    def difference(self, confidence: float = CONFIDENCE) -> Difference:
        """Return the mean difference with its BCa interval over pairs.

        >>> Pairs((0, 1, 2), (5.0, 7.0, 9.0), (2.0, 4.0, 6.0)).difference()
        Difference(pairs=3, mean=3.0, interval=Interval(low=3.0, high=3.0))
        """
        return Difference(len(self.ours), float(np.mean(self.differences)), bca(self.differences, confidence))

    def correlation(self) -> float | None:
        """Return Pearson's r: how much pairing by seed explains. None where it is not defined or of two pairs.

        >>> Pairs((0, 1, 2), (1.0, 2.0, 3.0), (2.0, 4.0, 6.0)).correlation()
        1.0
        """
        if len(self.ours) < FEWEST or min(np.ptp(self.ours), np.ptp(self.theirs)) == 0:
            return None
        return float(np.corrcoef(self.ours, self.theirs)[0, 1])

    def improvement(self, better: int) -> Improvement:
        """Return how often ours was better.

        Args:
            better: 1 where more is better, -1 where less is.

        >>> Pairs((0, 1), (1.0, 5.0), (1.0, 4.0)).improvement(1).share
        0.75
        """
        signs = np.sign(self.differences) * better
        share = float(np.mean((signs + 1) / 2))
        return Improvement(share, wilson(share, len(signs)))


def make_pairs(ours: Mapping[int, float], theirs: Mapping[int, float]) -> Pairs | None:
    """Return the pairs of two rows.

    Args:
        ours: A number for each seed.
        theirs: The same of what it is compared to.

    Returns:
        None if they have no seed in common.
    """
    seeds = tuple(sorted(ours.keys() & theirs.keys()))
    if not seeds:
        return None
    return Pairs(seeds, tuple(float(ours[seed]) for seed in seeds), tuple(float(theirs[seed]) for seed in seeds))
