"""Makes a plan: pipelines x environments x paired seeds, with the controls."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from tutorstudent.core.errors import PipelineError, listing
from tutorstudent.core.pipeline import Pipeline
from tutorstudent.core.registry import Registry
from tutorstudent.study.controls import controls_of
from tutorstudent.study.plan import Environment, Plan, Variant
from tutorstudent.study.requests import Setting, slug
from tutorstudent.study.resolving import Resolved, completed, is_tutor_alone, resolve, same


class Request(NamedTuple):
    """What is to be compared."""

    pipelines: Mapping[str, Pipeline]
    """By name."""
    runs: int
    first_seed: int = 0
    """Run i has the seed ``first_seed + i``."""
    decisions: int | None = None
    """None: as many as all files say."""
    variations: Sequence[Setting] = ()
    """One environment for each; none: the world of the files."""
    controls: bool = True


def make_plan(request: Request, registry: Registry) -> Plan:
    """Return the plan of a comparison; every pipeline in it has been built once.

    Raises:
        TutorStudentError: if something cannot be built, or the pipelines cannot be compared.
    """
    decisions = request.decisions or _decisions(request.pipelines)
    seeds = tuple(range(request.first_seed, request.first_seed + request.runs))
    variations: Sequence[Setting | None] = request.variations or (None,)
    environments = [_environment(request, variation, registry) for variation in variations]
    return Plan(tuple(environments), seeds, decisions)


def _decisions(pipelines: Mapping[str, Pipeline]) -> int:
    found = {pipeline.header.decisions for pipeline in pipelines.values()}
    if len(found) > 1:
        raise PipelineError(
            f"compare: the pipelines take different numbers of decisions ({listing(map(str, found))}); "
            "give one number with --decisions."
        )
    return found.pop()


def _environment(request: Request, variation: Setting | None, registry: Registry) -> Environment:
    varied = {name: variation.apply(given) if variation else given for name, given in request.pipelines.items()}
    resolved = {name: resolve(pipeline) for name, pipeline in varied.items()}
    _check_one_world(resolved)
    given = [
        Variant(name, f"The pipeline {_file(request.pipelines[name])}.", False, found.values, found.counters)
        for name, found in resolved.items()
    ]
    variants = [*given, *_controls(resolved, registry)] if request.controls else given
    name = variation.label if variation else _world_name(given[0])
    return Environment(name, tuple(variants), _reference(variants))


def _check_one_world(resolved: Mapping[str, Resolved]) -> None:
    first, *others = resolved
    for name in others:
        if resolved[name].values["world"] != resolved[first].values["world"]:
            raise PipelineError(
                f"compare: '{first}' and '{name}' run in different worlds; their runs cannot be paired. "
                "Give them one 'world', or set what differs with --set or --vary."
            )


def _controls(resolved: Mapping[str, Resolved], registry: Registry) -> list[Variant]:
    learner = next((name for name, found in resolved.items() if not is_tutor_alone(found.values)), None)
    if learner is None:
        return []
    variants = []
    for control in controls_of(resolved[learner]):
        where = f"control '{control.name}' of '{learner}'"
        values = completed(where, control.values, registry)
        if any(same(values, found.values) for found in resolved.values()):
            continue
        if control.name in resolved:
            raise PipelineError(
                f"compare: '{control.name}' is the name of a control; rename the file, or --no-controls."
            )
        about = f"{control.about} A control of {learner}."
        variants.append(Variant(control.name, about, True, values, resolved[learner].counters))
    return variants


def _reference(variants: Sequence[Variant]) -> str:
    """Return the name of what the learner's own tutor does alone; empty where that does not run."""
    alone = [variant for variant in variants if is_tutor_alone(variant.pipeline)]
    learner = next((variant for variant in variants if variant not in alone), None)
    return next((item.name for item in alone if not learner or item.pipeline["tutor"] == learner.pipeline["tutor"]), "")


def _file(pipeline: Pipeline) -> str:
    return Path(pipeline.document.name).name


def _world_name(variant: Variant) -> str:
    world = variant.pipeline["world"]
    scene = world.get("scene")
    return slug(Path(scene).stem) if isinstance(scene, str) else slug(world["use"])
