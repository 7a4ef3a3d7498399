"""Makes a plan: pipelines x environments x paired seeds, with the controls."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.words.errors import PipelineError, listing
from tutorstudent.study.plans.constant_level import BEST
from tutorstudent.study.plans.controls import controls_of, unsearched
from tutorstudent.study.plans.goals import goal_of, with_goal
from tutorstudent.study.plans.plan import Environment, Plan, Search, Variant
from tutorstudent.study.plans.requests import ANY, Request, Setting, slug
from tutorstudent.study.plans.resolving import Resolved, completed, is_tutor_alone, learner_of, resolve, same
from tutorstudent.study.plans.seeking import plan_search


def make_plan(request: Request, registry: Registry) -> Plan:
    """Return the plan of a comparison; every pipeline in it has been built once.

    Raises:
        TutorStudentError: if something cannot be built, or the pipelines cannot be compared.
    """
    decisions = request.decisions or _decisions(request.pipelines)
    seeds = tuple(range(request.first_seed, request.first_seed + request.runs))
    variations: Sequence[Setting | None] = request.variations or (None,)
    places = dict(_place(request, variation) for variation in variations)
    request = request._replace(goal=goal_of(request.goal, places.values(), registry))
    search = plan_search(request, places, registry, decisions)
    environments = [_environment(request, name, resolved, registry, search) for name, resolved in places.items()]
    return Plan(tuple(environments), seeds, decisions, search)


def _decisions(pipelines: Mapping[str, Pipeline]) -> int:
    found = {pipeline.header.decisions for pipeline in pipelines.values()}
    if len(found) > 1:
        raise PipelineError(
            f"compare: the pipelines take different numbers of decisions ({listing(map(str, found))}); "
            "give one number with --decisions."
        )
    return found.pop()


def _place(request: Request, variation: Setting | None) -> tuple[str, dict[str, Resolved]]:
    """Return the name of an environment with the pipelines in it."""
    varied = {name: variation.apply(given) if variation else given for name, given in request.pipelines.items()}
    resolved = {name: resolve(pipeline) for name, pipeline in varied.items()}
    _check_one_world(resolved)
    return variation.label if variation else _world_name(next(iter(resolved.values()))), resolved


def _check_one_world(resolved: Mapping[str, Resolved]) -> None:
    first, *others = resolved
    for name in others:
        if resolved[name].values["world"] != resolved[first].values["world"]:
            raise PipelineError(
                f"compare: '{first}' and '{name}' run in different worlds; their runs cannot be paired. "
                "Give them one 'world', or set what differs with --set or --vary."
            )


def _environment(
    request: Request, name: str, resolved: Mapping[str, Resolved], registry: Registry, search: Search | None
) -> Environment:
    given = [
        Variant(name, f"The pipeline {_file(request.pipelines[name])}.", False, found.values, found.counters)
        for name, found in resolved.items()
    ]
    learner = learner_of(resolved) if request.controls else None
    variants = [*given, *(_controls(learner, resolved, registry, search) if learner else [])]
    known = {key: situation for found in resolved.values() for key, situation in found.counters.items()}
    counted = [item._replace(counters=with_goal(request.goal, item.counters, known)) for item in variants]
    return Environment(name, tuple(counted), _reference(counted))


def _controls(
    learner: str, resolved: Mapping[str, Resolved], registry: Registry, search: Search | None
) -> Iterator[Variant]:
    if search:
        _check_name(BEST, resolved)
    constant = [] if search else [unsearched(resolved[learner])]
    for control in [*controls_of(resolved[learner]), *constant]:
        values = completed(f"control '{control.name}' of '{learner}'", control.values, registry)
        if any(same(values, found.values) for found in resolved.values()):
            continue
        _check_name(control.name, resolved)
        about = f"{control.about} A control of {learner}."
        yield Variant(control.name, about, True, values, resolved[learner].counters)


def _check_name(control: str, resolved: Mapping[str, Resolved]) -> None:
    if control in resolved:
        raise PipelineError(f"compare: '{control}' is the name of a control; rename the file, or --no-controls.")


def _reference(variants: Sequence[Variant]) -> str:
    """Return the name of what the learner's own tutor does alone; empty where that does not run."""
    alone = [variant for variant in variants if is_tutor_alone(variant.pipeline)]
    learner = next((variant for variant in variants if variant not in alone), None)
    return next((item.name for item in alone if not learner or item.pipeline["tutor"] == learner.pipeline["tutor"]), "")


def _file(pipeline: Pipeline) -> str:
    path = Path(pipeline.document.name)
    return f"{path.resolve().parent.name}/{path.name}" if path.stem == ANY else path.name


def _world_name(resolved: Resolved) -> str:
    world = resolved.values["world"]
    scene = world.get("scene")
    return slug(Path(scene).stem) if isinstance(scene, str) else slug(world["use"])
