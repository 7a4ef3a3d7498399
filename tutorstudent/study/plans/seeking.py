"""Plans the search for the best constant level: every level in every environment, on seeds of its own."""

from __future__ import annotations

from collections.abc import Mapping

from tutorstudent.core.files.registry import Registry
from tutorstudent.study.plans.constant_level import ALONE
from tutorstudent.study.plans.controls import candidates_of
from tutorstudent.study.plans.goals import with_goal
from tutorstudent.study.plans.plan import Environment, Plan, Search, Variant
from tutorstudent.study.plans.requests import Request
from tutorstudent.study.plans.resolving import Resolved, completed, learner_of

SEEDS_FROM = 1_000_000
"""The first seed of a search, unless a reported run has it. Choice: see docs/fidelity.md."""


def plan_search(
    request: Request, places: Mapping[str, Mapping[str, Resolved]], registry: Registry, decisions: int
) -> Search | None:
    """Return the search for the best constant level; None where there is no learner, no goal, or none is wanted.

    Args:
        request: What is compared, with the goal that `goals.goal_of` found.
        places: The pipelines in each environment.
        registry: Of the plugins.
        decisions: Of a run.
    """
    learners = {place: (name, found[name]) for place, found in places.items() if (name := learner_of(found))}
    if not (request.controls and request.search_runs and learners and request.goal):
        return None
    first = max(SEEDS_FROM, request.first_seed + request.runs)
    seeds = tuple(range(first, first + request.search_runs))
    environments = tuple(_environment(place, *found, request.goal, registry) for place, found in learners.items())
    return Search(request.goal, request.harm_budget, Plan(environments, seeds, decisions))


def _environment(place: str, learner: str, resolved: Resolved, goal: str, registry: Registry) -> Environment:
    counters = with_goal(goal, resolved.counters, resolved.counters)
    variants = []
    for control in candidates_of(resolved):
        values = completed(f"control '{control.name}' of '{learner}'", control.values, registry)
        about = f"{control.about} A control of {learner}."
        variants.append(Variant(control.name, about, True, values, counters))
    return Environment(place, tuple(variants), ALONE)
