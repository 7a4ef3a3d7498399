"""What every run gained over the tutor alone, and what it cost: the numbers of one picture."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tutorstudent.study.plan import Environment
from tutorstudent.study.traces import Trace, Traces

PER = 10_000
"""Decisions to which harm is referred."""


class Outcome(NamedTuple):
    """One run, or what several come to."""

    harm: float
    """Harmed decisions in `PER`."""
    gain: float
    """How much more was counted than by the tutor alone in the run with the same seed."""


class Row(NamedTuple):
    """The runs of one variant."""

    runs: tuple[Outcome, ...]
    mean: Outcome
    sd: Outcome
    """Standard deviations of a sample (n - 1); 0 for a single run."""


class Gains(NamedTuple):
    """All runs of one environment."""

    counter: str
    """What is gained: the environment's first counter."""
    harm: str
    reference: str
    reference_mean: float
    """What the tutor alone counts in a run."""
    rows: dict[str, Row]
    """By variant, in the order of the tables. Runs to which no run of the tutor alone belongs are missing."""


def gains(environment: Environment, traces: Traces) -> Gains | None:
    """Return what the runs gained; None where nothing is counted or the tutor alone does not run."""
    alone = {trace.seed: trace for trace in traces.by_variant.get(environment.reference, [])}
    if not traces.measures.counters or not alone:
        return None
    counter, harm = next(iter(traces.measures.counters)), traces.measures.harm_total()
    outcomes = {
        name: [
            Outcome(PER * _end(trace, harm) / trace.decisions, _end(trace, counter) - _end(partner, counter))
            for trace in found
            if (partner := alone.get(trace.seed))
        ]
        for name, found in traces.by_variant.items()
    }
    mean = sum(_end(trace, counter) for trace in alone.values()) / len(alone)
    rows = {name: _row(found) for name, found in outcomes.items() if found}
    return Gains(counter, traces.measures.harm, environment.reference, mean, rows)


def _row(outcomes: Sequence[Outcome]) -> Row:
    array = np.array(outcomes)
    sd = array.std(axis=0, ddof=1) if len(outcomes) > 1 else np.zeros(2)
    return Row(tuple(outcomes), Outcome(*array.mean(axis=0).tolist()), Outcome(*sd.tolist()))


def _end(trace: Trace, title: str) -> float:
    return float(trace.totals[title][-1])
