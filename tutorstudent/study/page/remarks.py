"""What has to be said of a study before anybody reads its numbers, in the terminal, the page and the tables alike."""

from __future__ import annotations

import math
import shlex
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from tutorstudent.core.running.observers import TALLIED
from tutorstudent.core.words.errors import list_names
from tutorstudent.study.numbers.declared import NO_MEASURES
from tutorstudent.study.plans.constant_level import BEST
from tutorstudent.study.plans.controls import CONSTANT
from tutorstudent.study.plans.goals import UNBOUNDED
from tutorstudent.study.plans.plan import Environment
from tutorstudent.study.runs.results import Study
from tutorstudent.study.tables.cells import count

OWN_OBSERVER = "count it with an observer of your own (ts.Entries, docs/guide/write-an-observer.md)"
CONDUCT = {*NO_MEASURES[:2], *(measure.name for measure in TALLIED)}
"""Numbers of every run that nobody drives for."""


def make_remarks(study: Study) -> list[str]:
    """Return sentences about what is not there and what tells nothing; none of a study where all is well."""
    return [
        *_remark_on_waiting(study),
        *_remark_on_notices(study),
        *_remark_on_goal(study),
        *_remark_on_constant(study),
        *_remark_on_sameness(study),
    ]


def describe_goal(study: Study) -> str:
    """Return what a run is to have most of as a sentence; empty where nothing counts it."""
    goal = study.plan.goal
    return f"The goal, of which more is better: {goal} (--goal names another)." if goal else ""


def make_resume_command(folder: Path) -> str:
    """Return what goes on with the study in a folder, as it is typed.

    >>> make_resume_command(Path("my study"))
    "tutorstudent compare --resume --out 'my study'"
    """
    return f"tutorstudent compare --resume --out {shlex.quote(str(folder))}"


def _remark_on_waiting(study: Study) -> Iterator[str]:
    if waiting := len(study.waiting):
        runs = f"{waiting} run{' was' if waiting == 1 else 's were'}"
        yield f"{runs} not run yet; go on with: {make_resume_command(study.folder)}"


def _remark_on_notices(study: Study) -> Iterator[str]:
    """Yield what kept learners from having any effect, each kind once for every pipeline and environment."""
    for environment in study.plan.environments:
        for variant in environment.variants:
            if variant.control:
                continue
            runs = study.of(environment.name, variant.name)
            kinds = Counter(notice.kind for run in runs for notice in run.notices)
            said = {notice.kind: notice.says for run in reversed(runs) for notice in run.notices}
            for kind, times in kinds.items():
                yield f"{variant.name} in {environment.name}, {times} of {len(runs)} runs: {said[kind]}"


def _remark_on_goal(study: Study) -> Iterator[str]:
    if study.plan.goal:
        return
    known = {key for run in study.runs for key in run.summary if key not in CONDUCT and not key.startswith(UNBOUNDED)}
    named = f"name what does with --goal (there are: {list_names(known)}), or " if known else ""
    yield f"Nothing counts what the tutors achieve; {named}{OWN_OBSERVER}."


def _remark_on_constant(study: Study) -> Iterator[str]:
    if CONSTANT in [variant.name for variant in study.plan.variants() if variant.control]:
        why = "as was asked for" if study.plan.goal else "since nothing is counted that could be most"
        yield f"No constant level was searched for, {why}: {CONSTANT} stands where {BEST} would."


def _remark_on_sameness(study: Study) -> Iterator[str]:
    for environment in study.plan.environments:
        if study.search:
            yield from _remark_on_levels(study, environment)
        yield from _remark_on_runs(study, environment)


def _remark_on_levels(study: Study, environment: Environment) -> Iterator[str]:
    chosen = study.search and study.search.chosen(environment.name)
    if study.search and chosen and study.search.is_indifferent(environment.name):
        yield (
            f"In the search for the best constant level in {environment.name} every level came to the same "
            f"{study.search.goal}, {count(chosen.goal or 0.0)}: level {chosen.level} is the one that violates least, "
            "or the lowest of those, and best at nothing."
        )


def _remark_on_runs(study: Study, environment: Environment) -> Iterator[str]:
    goal, runs = study.plan.goal, [run for run in study.runs if run.environment == environment.name]
    values = {run.summary[goal] for run in runs if math.isfinite(run.summary.get(goal, math.nan))}
    if len(values) != 1 or len(runs) < 2:
        return
    situation = environment.counters().get(goal)
    entered = f" It counts how often the tutor enters the situation '{situation}'." if situation else ""
    yield (
        f"In {environment.name} {goal} is {count(values.pop())} in every run, so that it tells nobody apart.{entered} "
        f"Take more decisions, name another goal with --goal, or {OWN_OBSERVER}."
    )
