"""Studies put together by hand: numbers whose tables can be worked out on paper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from tutorstudent.core.running.observers import TALLIED
from tutorstudent.core.words.measures import Measure, as_measure
from tutorstudent.sims.pioneer.events import EVENTS
from tutorstudent.study.plans.plan import Environment, Plan, Variant
from tutorstudent.study.runs.results import Failure, Run, Study

COUNTERS = {"attractors": "Prey Spin"}
MEASURES = (*(as_measure(name, how) for name, how in EVENTS.items()), *TALLIED)
Numbers = Mapping[str, Mapping[str, Sequence[float | None]]]


def made(
    numbers: Numbers,
    reference: str = "alone",
    controls: Sequence[str] = ("ramp",),
    failures: Sequence[Failure] = (),
    measures: Sequence[Measure] = MEASURES,
) -> Study:
    """Return a study of one environment.

    Args:
        numbers: By variant and key of the summary, one for each seed from 0; None where a run does not have it.
        reference: The tutor alone.
        controls: Names of the variants that are controls.
        failures: Runs that failed.
        measures: What the parts of every run declared.
    """
    variants = tuple(Variant(name, "", name in controls, {}, COUNTERS) for name in numbers)
    runs = [
        Run("cave", name, seed, _summary(columns, seed), Path("nowhere"), tuple(measures))
        for name, columns in numbers.items()
        for seed in range(max(len(values) for values in columns.values()))
    ]
    seeds = tuple(range(max((run.seed + 1 for run in runs), default=0)))
    return Study(
        Path("nowhere"), Plan((Environment("cave", variants, reference),), seeds, 100), tuple(runs), tuple(failures)
    )


def _summary(columns: Mapping[str, Sequence[float | None]], seed: int) -> dict[str, float]:
    return {key: value for key, values in columns.items() if (value := values[seed]) is not None}
