"""What a comparison counts as achievement."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.rundir import run_pipeline
from tutorstudent.core.words.errors import PipelineError, list_names, suggest
from tutorstudent.study.plans.controls import make_candidates
from tutorstudent.study.plans.resolving import Resolved, find_learner, reread

UNBOUNDED = ("share:", "violated:")
"""What begins a name in a summary that only some runs have."""


def find_goal(asked: str, environments: Iterable[Mapping[str, Resolved]], registry: Registry) -> str:
    """Return the name of what a run should maximise; empty where nothing counts it.

    Args:
        asked: The goal by name; empty: what the learner's observers count first, else what its world says.
        environments: The pipelines of each.
        registry: Of the plugins.

    Raises:
        PipelineError: if no run counts the goal that is asked for.
    """
    pipelines = list(environments)
    learners = [found[name] for found in pipelines if (name := find_learner(found))]
    first = next(iter([*learners, *pipelines[0].values()]))
    if asked:
        _check(asked, first, registry)
    return asked or next(iter(first.counters), first.goal_event)


def put_goal_first(goal: str, counters: Mapping[str, str], known: Mapping[str, str]) -> dict[str, str]:
    """Return what a variant counts with the goal before all else; without a situation where no observer enters one.

    >>> put_goal_first("prey", {"turns": "Turning"}, {"turns": "Turning", "prey": "Spin"})
    {'prey': 'Spin', 'turns': 'Turning'}
    >>> put_goal_first("distance_m", {}, {}), put_goal_first("", {}, {})
    ({'distance_m': ''}, {})
    """
    return ({goal: known.get(goal, "")} if goal else {}) | dict(counters)


def explain_unknown_goal(goal: str, known: Iterable[str]) -> PipelineError:
    """Return the error about a goal that no run counts."""
    names = sorted(known)
    return PipelineError(
        f"--goal {goal}: no run counts it{suggest(goal, names)}. What is counted: {list_names(names)}."
    )


def _check(goal: str, resolved: Resolved, registry: Registry) -> None:
    """Run the tutor alone for one decision to see what is counted."""
    if goal.startswith(UNBOUNDED):
        return
    tutor_alone = next(make_candidates(resolved)).values
    known = run_pipeline(reread(f"--goal {goal}", tutor_alone | {"decisions": 1}, registry)).summary
    if goal not in known:
        raise explain_unknown_goal(goal, known)
