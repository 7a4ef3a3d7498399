"""What pictures need of a run: small enough that all runs of an environment are kept at once, each read once."""

from __future__ import annotations

from collections.abc import Sequence
from math import isclose
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.running.arrays import Arrays
from tutorstudent.study.numbers.curves import (
    DECISIONS,
    Curve,
    average_bins,
    find_harm,
    find_matches,
    read_count,
    read_event,
    read_level,
    read_points,
    sum_up,
    thin_out,
)
from tutorstudent.study.plans.plan import Environment
from tutorstudent.study.runs.results import Run, Study

LEVEL = "amplification level"
MATCH = "match rate, %"


class Measures(NamedTuple):
    """What is counted in one environment."""

    counters: dict[str, str]
    """What adds up decision by decision, and the situation whose entries that is; empty for an event of the world's."""
    harm: str
    """``collided`` or, where the world knows no collisions, ``violated``."""
    goal: str = ""
    """What is gained, of a run's summary; empty for nothing."""

    def harm_total(self) -> str:
        """Return the title of the harm of a whole run, as in the tables."""
        return f"{self.harm} decisions"

    def harm_rate(self) -> str:
        """Return the title of the harm over the decisions."""
        return f"{self.harm} decisions per {DECISIONS:,}"

    def rates(self) -> list[str]:
        """Return the titles of what is shown over the decisions as a rate."""
        return [*(_name_rate(name) for name in self.counters), self.harm_rate(), LEVEL, MATCH]


class Trace(NamedTuple):
    """One run."""

    seed: int
    decisions: int
    goal: float | None
    """What it came to; None if it does not count that."""
    totals: dict[str, Curve]
    """By title: how often it had happened, at `curves.thin_out` decisions; the last is the end."""
    rates: dict[str, Curve]
    """By title, a value for each of `curves.make_edges`; what the run does not have is missing."""
    harm_places: NDArray[np.float64] | None
    """Where each harmed decision ended, shape (harmed, 2), metres; None if the world does not say."""
    contact_places: NDArray[np.float64] | None
    """The same where contacts began; None if the world counts no contacts."""


class Traces(NamedTuple):
    """All runs of one environment."""

    measures: Measures
    by_variant: dict[str, list[Trace]]
    """By seed."""
    firsts: dict[str, Arrays]
    """By variant: every decision of the run with the study's first seed."""

    def goals(self) -> dict[str, list[float]]:
        """Return what every run came to that has a goal."""
        return {
            name: [trace.goal for trace in found if trace.goal is not None] for name, found in self.by_variant.items()
        }

    def totals(self, title: str) -> dict[str, list[Curve]]:
        """Return one measure of every run that has it, summed up."""
        return {
            name: [trace.totals[title] for trace in found if title in trace.totals]
            for name, found in self.by_variant.items()
        }

    def rates(self, title: str) -> dict[str, list[Curve]]:
        """Return one measure of every run that has it, as a rate."""
        return {
            name: [trace.rates[title] for trace in found if title in trace.rates]
            for name, found in self.by_variant.items()
        }


def read_traces(study: Study, environment: Environment) -> Traces:
    """Read every run of an environment."""
    runs = {variant.name: study.of(environment.name, variant.name) for variant in environment.variants}
    every = [run for found in runs.values() for run in found]
    counters = {name: into for name, into in environment.counters().items() if into or _adds_up(name, every)}
    measures = Measures(counters, _name_harm(every), study.plan.goal)
    by_variant: dict[str, list[Trace]] = {}
    firsts = {}
    for name, found in runs.items():
        by_variant[name] = []
        for run in found:
            arrays = run.arrays()
            by_variant[name].append(_make_trace(run, arrays, measures))
            if run.seed == study.plan.seeds[0]:
                firsts[name] = arrays
    return Traces(measures, by_variant, firsts)


def _name_harm(runs: Sequence[Run]) -> str:
    return "collided" if any("collided" in run.summary for run in runs) else "violated"


def _adds_up(name: str, runs: Sequence[Run]) -> bool:
    """Return whether a number of the summaries is the sum of an event, and not its last, largest or mean value."""
    totals = ((run.summary[name], read_count(run.arrays(), name, "")) for run in runs if name in run.summary)
    summed, values = next(totals, (0.0, None))
    return values is not None and isclose(summed, float(values.sum()), rel_tol=1e-6)


def _name_rate(name: str) -> str:
    return f"{name} per {DECISIONS:,} decisions"


def _make_trace(run: Run, arrays: Arrays, measures: Measures) -> Trace:
    harm = find_harm(arrays)
    found = {name: read_count(arrays, name, situation) for name, situation in measures.counters.items()}
    happened = {name: values for name, values in found.items() if values is not None}
    at = thin_out(len(harm))
    totals = {name: sum_up(which)[at] for name, which in (happened | {measures.harm_total(): harm}).items()}
    rates = {_name_rate(name): DECISIONS * average_bins(values) for name, values in happened.items()}
    rates |= {
        measures.harm_rate(): DECISIONS * average_bins(harm.astype(float)),
        LEVEL: average_bins(read_level(arrays)),
    }
    match = find_matches(arrays)
    if match is not None:
        rates[MATCH] = 100 * average_bins(match.astype(float))
    where, contacts = read_points(arrays), read_event(arrays, "contacts")
    return Trace(
        run.seed,
        len(harm),
        run.summary.get(measures.goal),
        totals,
        rates,
        None if where is None else where[harm],
        None if where is None or contacts is None else where[contacts > 0],
    )
