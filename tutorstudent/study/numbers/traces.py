"""What pictures need of a run: small enough that all runs of an environment are kept at once, each read once."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.running.arrays import Arrays
from tutorstudent.core.words.measures import Measure
from tutorstudent.study.numbers.curves import (
    Curve,
    count_by_decision,
    find_harm,
    make_learning_curve,
    read_event,
    read_points,
    read_series,
    sum_up,
    thin_out,
)
from tutorstudent.study.numbers.declared import choose_harm, find_measures
from tutorstudent.study.plans.plan import Environment
from tutorstudent.study.runs.results import Run, Study


class Counted(NamedTuple):
    """What is counted in one environment."""

    counters: dict[str, str]
    """What adds up decision by decision, and the situation whose entries that is; empty for any other measure."""
    harm: str
    """``collided`` or, where the world knows no collisions, ``violated``."""
    goal: str = ""
    """What is gained, of a run's summary; empty for nothing."""
    measures: tuple[Measure, ...] = ()
    """All of which some run recorded every decision."""

    def harm_total(self) -> str:
        """Return the title of the harm of a whole run, as in the tables."""
        return f"{self.harm} decisions"


class Trace(NamedTuple):
    """One run."""

    seed: int
    decisions: int
    goal: float | None
    """What it came to; None if it does not count that."""
    totals: dict[str, Curve]
    """By title: how often it had happened, at `curves.thin_out` decisions; the last is the end."""
    rates: dict[str, Curve]
    """By measure, a value for each of `curves.make_edges`; what the run does not have is missing."""
    harm_places: NDArray[np.float64] | None
    """Where each harmed decision ended, shape (harmed, 2), metres; None if the world does not say."""
    contact_places: NDArray[np.float64] | None
    """The same where contacts began; None if the world counts no contacts."""


class Traces(NamedTuple):
    """All runs of one environment."""

    counted: Counted
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

    def rates(self, measure: Measure) -> dict[str, list[Curve]]:
        """Return the learning curve of every run that has one."""
        return {
            name: [trace.rates[measure.name] for trace in found if measure.name in trace.rates]
            for name, found in self.by_variant.items()
        }


def read_traces(study: Study, environment: Environment) -> Traces:
    """Read every run of an environment."""
    runs = {variant.name: study.of(environment.name, variant.name) for variant in environment.variants}
    counted = _find_counted(study, environment)
    by_variant: dict[str, list[Trace]] = {}
    firsts = {}
    for name, found in runs.items():
        by_variant[name] = []
        for run in found:
            arrays = run.arrays()
            by_variant[name].append(_make_trace(run, arrays, counted))
            if run.seed == study.plan.seeds[0]:
                firsts[name] = arrays
    recorded = {name for traces in by_variant.values() for trace in traces for name in trace.rates}
    there = tuple(measure for measure in counted.measures if measure.name in recorded)
    return Traces(counted._replace(measures=there), by_variant, firsts)


def _find_counted(study: Study, environment: Environment) -> Counted:
    measures = find_measures(environment, study.runs)
    sums = [measure.name for measure in measures if measure.summed == "sum"]
    counters = {name: situation for name, situation in environment.counters().items() if situation or name in sums}
    return Counted(counters, choose_harm(measures).name, study.plan.goal, tuple(measures))


def _make_trace(run: Run, arrays: Arrays, counted: Counted) -> Trace:
    harm, situations = find_harm(arrays), counted.counters
    found = {name: count_by_decision(arrays, name, situation) for name, situation in situations.items()}
    happened = {name: values for name, values in found.items() if values is not None}
    at = thin_out(len(harm))
    totals = {name: sum_up(which)[at] for name, which in (happened | {counted.harm_total(): harm}).items()}
    numbers = {item: happened.get(item.name, read_series(arrays, item.name)) for item in counted.measures}
    where, contacts = read_points(arrays), read_event(arrays, "contacts")
    return Trace(
        run.seed,
        len(harm),
        run.summary.get(counted.goal),
        totals,
        {item.name: make_learning_curve(values, item) for item, values in numbers.items() if values is not None},
        None if where is None else where[harm],
        None if where is None or contacts is None else where[contacts > 0],
    )
