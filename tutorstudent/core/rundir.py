"""One run of a pipeline in its world, and the directory that it leaves behind.

| file | what |
|---|---|
| ``pipeline.yaml`` | the pipeline with every option written out |
| ``run.json`` | versions, seed, summary, incidents |
| ``decisions.npz`` | every decision, see `Recorder` |
| ``learned.npz`` | what was learned, see `recording.nested` |
"""

from __future__ import annotations

import json
import platform
from collections.abc import Sequence
from importlib import metadata
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from ruamel.yaml import YAML

from tutorstudent.core.component import Binding
from tutorstudent.core.engine import Engine
from tutorstudent.core.errors import PipelineError
from tutorstudent.core.observers import Observer, Tally, WorldEvents
from tutorstudent.core.pipeline import Pipeline, describe
from tutorstudent.core.recording import Arrays, Recorder, flat, save_arrays
from tutorstudent.core.runner import run

PACKAGES = ("tutorstudent", "numpy", "pydantic", "pluggy", "pybullet", "scikit-learn")


class Finished(NamedTuple):
    """What came out of a run."""

    engine: Engine[Any, Any, Any]
    resolved: dict[str, Any]
    summary: dict[str, float]
    decisions: Arrays


def run_pipeline(pipeline: Pipeline, observers: Sequence[Observer] = ()) -> Finished:
    """Run a pipeline in its own world and return what came out.

    Args:
        pipeline: Says parts, world, seed and number of decisions.
        observers: More observers than the pipeline names, for example a progress bar.
    """
    engine = pipeline.engine()
    action = engine.tutor.action
    world = pipeline.world(action)
    recorder, counting = Recorder(), [Tally(), WorldEvents(), *pipeline.observers(action)]
    seed = pipeline.header.seed
    for observer in (recorder, *counting[:2], *observers):
        observer.bind(Binding(seed, f"observers.{observer.name}", action))
    try:
        run(engine, world, pipeline.header.decisions, seed=seed, observers=[recorder, *counting, *observers])
    finally:
        world.close()
        engine.close()
    summary = {key: value for observer in [*counting, *observers] for key, value in observer.summary().items()}
    return Finished(engine, describe(engine, world, pipeline), summary, recorder.arrays())


def write_run(directory: Path, finished: Finished) -> None:
    """Write the run's files into `directory`."""
    prepare(directory)
    with (directory / "pipeline.yaml").open("w", encoding="utf-8") as stream:
        YAML().dump(finished.resolved, stream)
    text = json.dumps(_record(finished), indent=2, sort_keys=True, allow_nan=False)
    (directory / "run.json").write_text(f"{text}\n", encoding="utf-8")
    save_arrays(directory / "decisions.npz", finished.decisions)
    save_arrays(directory / "learned.npz", flat(finished.engine.state_dict()))


def prepare(directory: Path) -> None:
    """Make a directory for a run; an earlier run's may be written over, anything else may not.

    Raises:
        PipelineError: if the directory holds something that is no run.
    """
    if directory.exists() and not directory.is_dir():
        raise PipelineError(f"{directory} is a file; name a directory for the run.")
    if directory.is_dir() and any(directory.iterdir()) and not (directory / "run.json").exists():
        raise PipelineError(f"{directory} holds something that is no run; name another directory.")
    directory.mkdir(parents=True, exist_ok=True)


def _record(finished: Finished) -> dict[str, Any]:
    engine = finished.engine
    return {
        "versions": versions(),
        "seed": finished.resolved["seed"],
        "decisions": finished.resolved["decisions"],
        "summary": {key: value for key, value in finished.summary.items() if np.isfinite(value)},
        "incident_counts": {f"{part}: {kind}": count for (part, kind), count in sorted(engine.incident_counts.items())},
        "newest_incidents": [incident._asdict() for incident in engine.incidents],
    }


def versions() -> dict[str, str]:
    """Return the versions that a result depends on."""
    found = {"python": platform.python_version(), "machine": platform.machine()}
    for package in PACKAGES:
        try:
            found[package] = metadata.version(package)
        except metadata.PackageNotFoundError:
            found[package] = "not installed"
    return found
