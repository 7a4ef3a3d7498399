"""What is measured of a run: a number of its summary, or such a number by the way travelled or the time."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from tutorstudent.study.runs.results import Run

WAY, TIME, DECISIONS = "distance_m", "time_s", "decisions"
PER = 10_000
"""Decisions to which harm is referred: the length of the thesis's runs."""


class Measure(NamedTuple):
    """A number of every run."""

    title: str
    key: str
    """Of a run's summary."""
    over: str = ""
    """Key of what it is divided by, run by run; empty for the number itself."""
    per: float = 1.0
    """How much of `over` makes the unit: 100 m, 1,000 s."""
    better: int = 0
    """1 where more is better, -1 where less is, 0 where it is neither."""

    def read(self, summary: Mapping[str, float]) -> float | None:
        """Return the number of one run.

        Returns:
            None where the run does not have it: not known to its world, no finite number, or divided by nothing.

        >>> rate = Measure("hits per 100 m", "hits", "distance_m", 100.0)
        >>> rate.read({"hits": 3.0, "distance_m": 50.0}), rate.read({"hits": 0.0, "distance_m": 0.0})
        (6.0, None)
        """
        value = summary.get(self.key, math.nan)
        if self.over:
            divisor = summary.get(self.over, 0.0)
            value = self.per * value / divisor if 0 < divisor < math.inf else math.nan
        return value if math.isfinite(value) else None

    def is_known(self, runs: Iterable[Run]) -> bool:
        """Return whether any of the runs could have the number: its parts are in the summary."""
        return any(self.key in run.summary and (not self.over or self.over in run.summary) for run in runs)

    def read_by_seed(self, runs: Sequence[Run]) -> dict[int, float]:
        """Return the numbers of the runs that have one."""
        values = {run.seed: self.read(run.summary) for run in runs}
        return {seed: value for seed, value in values.items() if value is not None}


def measure_per_way(title: str, key: str, better: int = 0) -> Measure:
    """Return a number for every 100 m travelled."""
    return Measure(f"{title} per 100 m", key, WAY, 100.0, better)


def measure_per_time(title: str, key: str, better: int = 0) -> Measure:
    """Return a number for every 1,000 s of simulated time; for every second it would be 0.00."""
    return Measure(f"{title} per 1,000 s", key, TIME, 1000.0, better)


def measure_per_decisions(title: str, key: str, better: int = 0) -> Measure:
    """Return a number for every `PER` decisions."""
    return Measure(f"{title} per {PER:,}", key, DECISIONS, PER, better)


def find_harm_measure(runs: Iterable[Run]) -> Measure:
    """Return what is counted as harm: collided decisions, and violated ones where the world knows no collisions."""
    collided = Measure("collided decisions", "collided", better=-1)
    return collided if collided.is_known(runs) else Measure("violated decisions", "violated", better=-1)
