"""Finds the best constant level from the runs of a search."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path
from statistics import fmean

from tutorstudent.study.plans.constant_level import (
    BEST,
    FOLDER,
    Level,
    Searched,
    find_best,
    list_levels,
    load_searched,
    name_candidate,
    save_searched,
)
from tutorstudent.study.plans.goals import explain_unknown_goal
from tutorstudent.study.plans.plan import Plan, Search
from tutorstudent.study.runs.results import Run, read_runs


def find_levels(search: Search, folder: Path) -> Searched:
    """Return the table of the search's runs with the best level of each environment.

    Args:
        search: What was run.
        folder: The study's.

    Raises:
        PipelineError: if no run counts the goal.
    """
    runs, _ = read_runs(folder / FOLDER, search.plan.jobs())
    _check_goal(search.goal, runs)
    blank = Searched(search.goal, search.harm_budget, search.plan.seeds, ())
    levels: list[Level] = []
    for environment in search.plan.environments:
        here = [_make_level(environment.name, level, runs, search.goal) for level in list_levels(environment)]
        limit = blank._replace(levels=tuple(here)).limit(environment.name)
        chosen = find_best(here, limit, len(search.plan.seeds))
        levels += [item._replace(chosen=item == chosen) for item in here]
    return blank._replace(levels=tuple(levels))


def keep_levels(plan: Plan, searched: Searched, folder: Path) -> None:
    """Write the table, and remove the runs of a level that an earlier table, with fewer runs, had chosen."""
    earlier = load_searched(folder)
    for environment in plan.environments:
        before = earlier and earlier.chosen(environment.name)
        now = searched.chosen(environment.name)
        if before and (now is None or before.level != now.level):
            shutil.rmtree(folder / "runs" / environment.name / BEST, ignore_errors=True)
    save_searched(searched, folder)


def _make_level(environment: str, level: int, runs: Sequence[Run], goal: str) -> Level:
    there = [run for run in runs if (run.environment, run.variant) == (environment, name_candidate(level))]
    if not there:
        return Level(environment, level, 0, None, None)
    reached = fmean(run.summary.get(goal, 0.0) for run in there)
    violated = fmean(run.summary["violated"] / max(1.0, run.summary["decisions"]) for run in there)
    return Level(environment, level, len(there), reached, violated)


def _check_goal(goal: str, runs: Sequence[Run]) -> None:
    known = {key for run in runs for key in run.summary}
    if known and goal not in known:
        raise explain_unknown_goal(goal, known)
