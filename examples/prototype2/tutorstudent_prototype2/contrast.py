"""The learner against what learns nothing: a row for every variant of a study, in each environment."""

from __future__ import annotations

import math
from collections.abc import Sequence

from tutorstudent.study import Environment, Run, Study
from tutorstudent_prototype2.sheets import NOTHING, Section, Sheet, difference, number, spread
from tutorstudent_prototype2.summaries import INTERVALS, pair_up, summarize

LEARNER = "prototype2a"
HEADER = ("", "attractors", "less 2A's", "collided", "per 100 m", "contacts", "m/s", "way, m", "stall")
READING = (
    f"Differences are to prototype 2A (learning phase 2500) on the same seeds, with the {INTERVALS}: what learning is "
    "worth is what controls lack. Collided: decisions, and how many for 100 m of way. Contacts: first ones of each "
    "entanglement; m/s: the fastest of all runs. Way: metres travelled. Stall: refused decisions in a row, the most of "
    "all runs; where it is long, a robot was trapped. {time_s:.0f} s of simulated time a run."
)


def contrasts(study: Study) -> list[Section]:
    """Return a sheet for each environment; what the columns mean is said once, at the end."""
    sections = [
        Section(_sheet(study, environment), (_controls(environment),)) for environment in study.plan.environments
    ]
    *others, last = sections
    time_s = max((run.summary["time_s"] for run in study.runs), default=0.0)
    return [*others, Section(last.sheet, (*last.reading, READING.format(time_s=time_s)))]


def _sheet(study: Study, environment: Environment) -> Sheet:
    learner = by_seed(study.of(environment.name, LEARNER), "attractors")
    rows = []
    for variant in environment.variants:
        runs = study.of(environment.name, variant.name)
        itself = variant.name == LEARNER
        rows.append((variant.name, *(_row(runs, learner, itself) if runs else [NOTHING] * (len(HEADER) - 1))))
    return Sheet(f"{environment.name}: with controls", HEADER, tuple(rows))


def _controls(environment: Environment) -> str:
    found = [f"{item.name} ({item.about.partition('.')[0]})" for item in environment.variants if item.control]
    return f"Controls: {'; '.join(found)}." if found else "There are no controls."


def _row(runs: Sequence[Run], learner: dict[int, float], itself: bool) -> list[str]:
    means = {key: summarize([run.summary[key] for run in runs]) for key in ("attractors", "collided", "contacts")}
    return [
        spread(*means["attractors"][1:3]),
        NOTHING if itself else difference(pair_up(by_seed(runs, "attractors"), learner)),
        spread(*means["collided"][1:3]),
        _rate([_per_100_m(run) for run in runs]),
        spread(*means["contacts"][1:3]),
        f"{max(run.summary['contact_speed_mps'] for run in runs):.2f}",
        number(summarize([run.summary["distance_m"] for run in runs]).mean),
        f"{max(run.summary['longest_stall'] for run in runs):.0f}",
    ]


def _per_100_m(run: Run) -> float:
    way_m = run.summary["distance_m"]
    return 100 * run.summary["collided"] / way_m if way_m else math.nan


def _rate(rates: Sequence[float]) -> str:
    mean = summarize(rates).mean
    return NOTHING if math.isnan(mean) else f"{mean:.3f}"


def by_seed(runs: Sequence[Run], key: str) -> dict[int, float]:
    """Return one number of each run, by its seed."""
    return {run.seed: run.summary[key] for run in runs}
