"""What every run gained over the tutor alone, and what it cost: the numbers of one picture."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tutorstudent.study.numbers.traces import Traces
from tutorstudent.study.plans.plan import Environment

PER = 10_000
"""Decisions to which harm is referred."""


class Outcome(NamedTuple):
    """One run, or what several come to."""

    harm: float
    """Harmed decisions in `PER`."""
    gain: float
    """How much more was achieved than by the tutor alone in the run with the same seed."""


class Row(NamedTuple):
    """The runs of one variant."""

    runs: tuple[Outcome, ...]
    mean: Outcome
    sd: Outcome
    """Standard deviations of a sample (n - 1); 0 for a single run."""


class Gains(NamedTuple):
    """All runs of one environment."""

    goal: str
    """What is gained."""
    harm: str
    reference: str
    reference_mean: float
    """What the tutor alone achieves in a run."""
    rows: dict[str, Row]
    """By variant, in the order of the tables. Runs to which no run of the tutor alone belongs are missing."""

    @property
    def has_percent(self) -> bool:
        """Whether gains can be told in percent of what the tutor alone achieves: that is more than nothing."""
        return self.reference_mean > 0


def find_gains(environment: Environment, traces: Traces) -> Gains | None:
    """Return what the runs gained; None where they have no goal or the tutor alone does not run."""
    alone = {run.seed: run.goal for run in traces.by_variant.get(environment.reference, []) if run.goal is not None}
    if not alone:
        return None
    harm = traces.counted.harm_total()
    outcomes = {
        name: [
            Outcome(PER * float(run.totals[harm][-1]) / run.decisions, run.goal - alone[run.seed])
            for run in found
            if run.goal is not None and run.seed in alone
        ]
        for name, found in traces.by_variant.items()
    }
    rows = {name: _make_row(found) for name, found in outcomes.items() if found}
    mean = sum(alone.values()) / len(alone)
    return Gains(traces.counted.goal, traces.counted.harm, environment.reference, mean, rows)


def _make_row(outcomes: Sequence[Outcome]) -> Row:
    array = np.array(outcomes)
    sd = array.std(axis=0, ddof=1) if len(outcomes) > 1 else np.zeros(2)
    return Row(tuple(outcomes), Outcome(*array.mean(axis=0).tolist()), Outcome(*sd.tolist()))
