"""Interleaved repetitions in CPU time, so that a noisy machine disturbs all rows alike."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping
from typing import NamedTuple

REPETITIONS = 7


class Timing(NamedTuple):
    """CPU microseconds per unit over the repetitions."""

    least: float
    median: float
    most: float


def interleaved(work: Mapping[str, tuple[Callable[[], object], int]]) -> dict[str, Timing]:
    """Time every piece of work in turn, several times over.

    Args:
        work: By name, what to call and how many units one call does.
    """
    seen: dict[str, list[float]] = {name: [] for name in work}
    for call, _ in work.values():
        call()
    for _ in range(REPETITIONS):
        for name, (call, units) in work.items():
            start = time.process_time()
            call()
            seen[name].append((time.process_time() - start) / units * 1e6)
    return {name: Timing(min(values), statistics.median(values), max(values)) for name, values in seen.items()}
