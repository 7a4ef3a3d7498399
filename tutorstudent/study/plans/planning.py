"""Makes a plan: pipelines x environments x paired seeds, with the controls."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.words.errors import PipelineError, list_names
from tutorstudent.study.plans.constant_level import BEST
from tutorstudent.study.plans.controls import make_controls, make_unsearched
from tutorstudent.study.plans.goals import find_goal, put_goal_first
from tutorstudent.study.plans.plan import Environment, Plan, Search, Variant
from tutorstudent.study.plans.requests import ANY, Request, Setting, make_slug
from tutorstudent.study.plans.resolving import Resolved, complete, find_learner, is_same, is_tutor_alone, resolve
from tutorstudent.study.plans.seeking import plan_search


def make_plan(request: Request, registry: Registry) -> Plan:
    """Return the plan of a comparison; every pipeline in it has been built once.

    Raises:
        TutorStudentError: if something cannot be built, or the pipelines cannot be compared.
    """
    decisions = request.decisions or _find_decisions(request.pipelines)
    seeds = tuple(range(request.first_seed, request.first_seed + request.runs))
    variations: Sequence[Setting | None] = request.variations or (None,)
    pipelines = dict(_resolve_all(request, variation) for variation in variations)
    request = request._replace(goal=find_goal(request.goal, pipelines.values(), registry))
    search = plan_search(request, pipelines, registry, decisions)
    environments = [
        _make_environment(request, name, resolved, registry, search) for name, resolved in pipelines.items()
    ]
    return Plan(tuple(environments), seeds, decisions, search)


def _find_decisions(pipelines: Mapping[str, Pipeline]) -> int:
    found = {pipeline.header.decisions for pipeline in pipelines.values()}
    if len(found) > 1:
        raise PipelineError(
            f"compare: the pipelines take different numbers of decisions ({list_names(map(str, found))}); "
            "give one number with --decisions."
        )
    return found.pop()


def _resolve_all(request: Request, variation: Setting | None) -> tuple[str, dict[str, Resolved]]:
    """Return the name of an environment with the pipelines in it."""
    varied = {name: variation.apply(given) if variation else given for name, given in request.pipelines.items()}
    resolved = {name: resolve(pipeline) for name, pipeline in varied.items()}
    _check_one_world(resolved)
    return variation.label if variation else _name_world(next(iter(resolved.values()))), resolved


def _check_one_world(resolved: Mapping[str, Resolved]) -> None:
    first, *others = resolved
    for name in others:
        if resolved[name].values["world"] != resolved[first].values["world"]:
            raise PipelineError(
                f"compare: '{first}' and '{name}' run in different worlds; their runs cannot be paired. "
                "Give them one 'world', or set what differs with --set or --vary."
            )


def _make_environment(
    request: Request, name: str, resolved: Mapping[str, Resolved], registry: Registry, search: Search | None
) -> Environment:
    given = [
        Variant(name, f"The pipeline {_name_file(request.pipelines[name])}.", False, found.values, found.counters)
        for name, found in resolved.items()
    ]
    learner = find_learner(resolved) if request.controls else None
    variants = [*given, *(_make_controls(learner, resolved, registry, search) if learner else [])]
    known = {key: situation for found in resolved.values() for key, situation in found.counters.items()}
    counted = [item._replace(counters=put_goal_first(request.goal, item.counters, known)) for item in variants]
    return Environment(name, tuple(counted), _find_reference(counted))


def _make_controls(
    learner: str, resolved: Mapping[str, Resolved], registry: Registry, search: Search | None
) -> Iterator[Variant]:
    if search:
        _check_name(BEST, resolved)
    constant = [] if search else [make_unsearched(resolved[learner])]
    for control in [*make_controls(resolved[learner]), *constant]:
        values = complete(f"control '{control.name}' of '{learner}'", control.values, registry)
        if any(is_same(values, found.values) for found in resolved.values()):
            continue
        _check_name(control.name, resolved)
        about = f"{control.about} A control of {learner}."
        yield Variant(control.name, about, True, values, resolved[learner].counters)


def _check_name(control: str, resolved: Mapping[str, Resolved]) -> None:
    if control in resolved:
        raise PipelineError(f"compare: '{control}' is the name of a control; rename the file, or --no-controls.")


def _find_reference(variants: Sequence[Variant]) -> str:
    """Return the name of the variant that is the learner's tutor alone; empty where there is none."""
    unamplified = [variant for variant in variants if is_tutor_alone(variant.pipeline)]
    learner = next((variant for variant in variants if variant not in unamplified), None)
    return next(
        (item.name for item in unamplified if not learner or item.pipeline["tutor"] == learner.pipeline["tutor"]), ""
    )


def _name_file(pipeline: Pipeline) -> str:
    path = Path(pipeline.document.name)
    return f"{path.resolve().parent.name}/{path.name}" if path.stem == ANY else path.name


def _name_world(resolved: Resolved) -> str:
    world = resolved.values["world"]
    scene = world.get("scene")
    return make_slug(Path(scene).stem) if isinstance(scene, str) else make_slug(world["use"])
