"""What the runs of one environment measure, as their parts declared it."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from tutorstudent.core.running.observers import TALLIED
from tutorstudent.core.words.measures import COMMON, Measure
from tutorstudent.study.plans.goals import UNBOUNDED
from tutorstudent.study.plans.plan import Environment
from tutorstudent.study.runs.results import Run

NO_MEASURES = ("decisions", "amplified", "x_m", "y_m", "heading_rad")
"""Numbers of a summary that others are made from, and where the robot was in the end."""
HARMS = ("collided", "violated")
"""What is counted as harm: the first of these that there is."""


def find_measures(environment: Environment, runs: Sequence[Run]) -> list[Measure]:
    """Return every measure that any run of an environment has: what is counted as achievement, then all others.

    More is better of what is counted as achievement, whatever its part says. A number that no part declared, such as
    one that an observer summarizes by itself, is a measure too, neither good nor bad.

    Args:
        environment: Says what is counted as achievement.
        runs: Of the whole study, or of this environment.
    """
    there = [run for run in runs if run.environment == environment.name]
    declared = {measure.name: measure for run in there for measure in run.measures}
    names = list(dict.fromkeys([*declared, *(key for run in there for key in sorted(run.summary))]))
    known = {item.name: item for item in TALLIED} | COMMON | declared
    found = [known.get(name, Measure(name)) for name in names if _is_measure(name, known)]
    ordered = sorted((item for item in found if any(item.name in run.summary for run in there)), key=_rank)
    return _add_counters(ordered, environment.counters())


def choose_harm(measures: Sequence[Measure]) -> Measure:
    """Return what is counted as harm: collided decisions, and violated ones where the world knows no collisions."""
    by_name = {measure.name: measure for measure in measures}
    return next((by_name[name] for name in HARMS if name in by_name), TALLIED[0])


def _is_measure(name: str, known: Collection[str]) -> bool:
    return name not in NO_MEASURES and (name in known or not name.startswith(UNBOUNDED))


def _rank(measure: Measure) -> tuple[bool, bool]:
    """Return what measures are ordered by: harm and whatever is no detail first."""
    return measure.detail, measure.name not in HARMS[:1]


def _add_counters(measures: Sequence[Measure], counters: Collection[str]) -> list[Measure]:
    by_name = {measure.name: measure for measure in measures}
    counted = [replace(by_name[name], better="more", detail=False) for name in counters if name in by_name]
    return [*counted, *(measure for measure in measures if measure.name not in counters)]
