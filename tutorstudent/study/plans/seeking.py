"""Plans the search for the best constant level: every level in every environment, on seeds of its own."""

from __future__ import annotations

from collections.abc import Mapping

from tutorstudent.core.files.registry import Registry
from tutorstudent.study.plans.constant_level import TUTOR_ALONE
from tutorstudent.study.plans.controls import make_candidates
from tutorstudent.study.plans.goals import put_goal_first
from tutorstudent.study.plans.plan import Environment, Plan, Search, Variant
from tutorstudent.study.plans.requests import Request
from tutorstudent.study.plans.resolving import Resolved, complete, find_learner

SEEDS_FROM = 1_000_000
"""The first seed of a search, unless a reported run has it. Choice: see docs/fidelity.md."""


def plan_search(
    request: Request, pipelines: Mapping[str, Mapping[str, Resolved]], registry: Registry, decisions: int
) -> Search | None:
    """Return the search for the best constant level; None where there is no learner, no goal, or none is wanted.

    Args:
        request: What is compared, with the goal that `goals.find_goal` found.
        pipelines: By environment, then by name.
        registry: Of the plugins.
        decisions: Of a run.
    """
    learners = {env: (name, found[name]) for env, found in pipelines.items() if (name := find_learner(found))}
    if not (request.controls and request.search_runs and learners and request.goal):
        return None
    first = max(SEEDS_FROM, request.first_seed + request.runs)
    seeds = tuple(range(first, first + request.search_runs))
    environments = tuple(_make_environment(env, *found, request.goal, registry) for env, found in learners.items())
    return Search(request.goal, request.harm_budget, Plan(environments, seeds, decisions))


def _make_environment(name: str, learner: str, resolved: Resolved, goal: str, registry: Registry) -> Environment:
    counters = put_goal_first(goal, resolved.counters, resolved.counters)
    variants = []
    for control in make_candidates(resolved):
        values = complete(f"control '{control.name}' of '{learner}'", control.values, registry)
        about = f"{control.about} A control of {learner}."
        variants.append(Variant(control.name, about, True, values, counters))
    return Environment(name, tuple(variants), TUTOR_ALONE)
