"""Plans the search for the best constant level: every level in every environment, on seeds of its own."""

from __future__ import annotations

from collections.abc import Mapping

from tutorstudent.core.errors import PipelineError, listing, suggestion
from tutorstudent.core.registry import Registry
from tutorstudent.core.rundir import run_pipeline
from tutorstudent.study.controls import candidates_of
from tutorstudent.study.levels import ALONE
from tutorstudent.study.plan import Environment, Plan, Search, Variant
from tutorstudent.study.requests import Request
from tutorstudent.study.resolving import Resolved, completed, learner_of, reread

SEEDS_FROM = 1_000_000
"""The first seed of a search, unless a reported run has it. Choice: see docs/fidelity.md."""
UNBOUNDED = ("share:", "violated:")
"""What begins a name in a summary that only some runs have."""


def plan_search(
    request: Request, places: Mapping[str, Mapping[str, Resolved]], registry: Registry, decisions: int
) -> Search | None:
    """Return the search for the best constant level; None where there is no learner, no goal, or none is wanted.

    Args:
        request: What is compared.
        places: The pipelines in each environment.
        registry: Of the plugins.
        decisions: Of a run.

    Raises:
        PipelineError: if the goal is nothing that a run counts.
    """
    learners = {place: (name, found[name]) for place, found in places.items() if (name := learner_of(found))}
    if not (request.controls and request.search_runs and learners):
        return None
    name, learner = next(iter(learners.values()))
    goal = request.goal or next(iter(learner.counters), "")
    if not goal:
        return None
    first = max(SEEDS_FROM, request.first_seed + request.runs)
    seeds = tuple(range(first, first + request.search_runs))
    environments = tuple(_environment(place, *found, registry) for place, found in learners.items())
    if request.goal:
        _check_goal(goal, environments[0], registry)
    return Search(goal, request.harm_budget, Plan(environments, seeds, decisions))


def _environment(place: str, learner: str, resolved: Resolved, registry: Registry) -> Environment:
    variants = []
    for control in candidates_of(resolved):
        values = completed(f"control '{control.name}' of '{learner}'", control.values, registry)
        about = f"{control.about} A control of {learner}."
        variants.append(Variant(control.name, about, True, values, resolved.counters))
    return Environment(place, tuple(variants), ALONE)


def _check_goal(goal: str, environment: Environment, registry: Registry) -> None:
    """Take one decision to see what is counted, before all are taken."""
    if goal.startswith(UNBOUNDED):
        return
    pipeline = reread(f"--goal {goal}", environment.variants[0].pipeline | {"decisions": 1}, registry)
    known = run_pipeline(pipeline).summary
    if goal not in known:
        raise PipelineError(
            f"--goal {goal}: no run counts it{suggestion(goal, known)}. What is counted: {listing(known)}."
        )
