"""The learner against what learns nothing: a row for every variant of a study, in each environment."""

from __future__ import annotations

from collections.abc import Sequence

from tutorstudent.study import Environment, Run, Study
from tutorstudent_prototype2.sheets import NOTHING, Section, Sheet, difference, number, spread
from tutorstudent_prototype2.summaries import INTERVALS, paired, summarize

LEARNER = "prototype2a"
HEADER = ("", "attractors", "less 2A's", "collided", "contacts", "way, m", "stall")
READING = (
    f"Differences are to prototype 2A (learning phase 2500) on the same seeds, with the {INTERVALS}: what learning is "
    "worth is what controls lack. Collided: decisions; contacts: first ones of each entanglement. Way: metres "
    "travelled. Stall: refused decisions in a row, the most of all runs; where it is long, a robot was trapped."
)


def contrasts(study: Study) -> list[Section]:
    """Return a sheet for each environment; what the columns mean is said once, at the end."""
    sections = [
        Section(_sheet(study, environment), (_controls(environment),)) for environment in study.plan.environments
    ]
    *others, last = sections
    return [*others, Section(last.sheet, (*last.reading, READING))]


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
        NOTHING if itself else difference(paired(by_seed(runs, "attractors"), learner)),
        spread(*means["collided"][1:3]),
        spread(*means["contacts"][1:3]),
        number(summarize([run.summary["distance_m"] for run in runs]).mean),
        f"{max(run.summary['longest_stall'] for run in runs):.0f}",
    ]


def by_seed(runs: Sequence[Run], key: str) -> dict[int, float]:
    """Return one number of each run, by its seed."""
    return {run.seed: run.summary[key] for run in runs}
