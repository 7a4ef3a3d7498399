"""What is compared of runs: a measure, or how much of it there was by way, by time or by decisions."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from tutorstudent.core.words.measures import Measure
from tutorstudent.study.runs.results import Run


class Unit(NamedTuple):
    """What a measure is referred to."""

    key: str
    """Of a run's summary."""
    amount: float
    words: str


WAY = Unit("distance_m", 100.0, "100 m")
TIME = Unit("time_s", 1000.0, "1,000 s")
"""For every second it would be 0.00."""
DECISIONS = Unit("decisions", 10_000.0, "10,000")
"""The length of the thesis's runs."""
SIGNS = {"more": 1, "less": -1, None: 0}


class Quantity(NamedTuple):
    """A number of every run."""

    measure: Measure
    over: Unit | None = None
    """What it is divided by, run by run; None for the number itself."""

    @property
    def title(self) -> str:
        """How it is called in tables."""
        return f"{self.measure.heading} per {self.over.words}" if self.over else self.measure.heading

    @property
    def better(self) -> int:
        """1 where more is better, -1 where less is, 0 where it is neither."""
        return SIGNS[self.measure.better]

    def of(self, summary: Mapping[str, float]) -> float | None:
        """Return the number of one run; shares are in percent.

        Returns:
            None where the run does not have it: not known to its world, no finite number, or divided by nothing.

        >>> rate = Quantity(Measure("hits"), WAY)
        >>> rate.of({"hits": 3.0, "distance_m": 50.0}), rate.of({"hits": 0.0, "distance_m": 0.0})
        (6.0, None)
        """
        value = summary.get(self.measure.name, math.nan) * (100 if self.measure.unit == "%" else 1)
        if self.over:
            divisor = summary.get(self.over.key, 0.0)
            value = self.over.amount * value / divisor if 0 < divisor < math.inf else math.nan
        return value if math.isfinite(value) else None

    def is_known(self, runs: Iterable[Run]) -> bool:
        """Return whether any of the runs could have the number: its parts are in the summary."""
        keys = {self.measure.name} | ({self.over.key} if self.over else set())
        return any(keys <= run.summary.keys() for run in runs)

    def read_by_seed(self, runs: Sequence[Run]) -> dict[int, float]:
        """Return the numbers of the runs that have one."""
        values = {run.seed: self.of(run.summary) for run in runs}
        return {seed: value for seed, value in values.items() if value is not None}
