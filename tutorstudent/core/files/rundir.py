"""Runs a pipeline in its world and writes the run's directory.

| file | what |
|---|---|
| ``pipeline.yaml`` | the pipeline with every option written out |
| ``decisions.npz`` | every decision, see `Recorder` |
| ``run.json`` | versions, plugins, seed, summary (null for what is no finite number), measures, notices, incidents |
| ``learned.npz`` | what was learned, see `arrays.nest` |
"""

from __future__ import annotations

import json
import math
import platform
from collections.abc import Iterable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import asdict
from importlib import metadata
from pathlib import Path
from typing import Any, NamedTuple

from ruamel.yaml import YAML

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.watching import Notice
from tutorstudent.core.files.pipeline import Built, Pipeline, describe
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.roles.part import Component
from tutorstudent.core.running.arrays import Arrays, flatten, save_arrays
from tutorstudent.core.running.meter import WorldEvents
from tutorstudent.core.running.noticing import Noticer
from tutorstudent.core.running.observers import Observer, Tally, make_tally_measures
from tutorstudent.core.running.recorder import Recorder
from tutorstudent.core.running.runner import run
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.core.words.measures import Measure

PACKAGES = ("tutorstudent", "numpy", "pydantic", "pluggy", "pybullet", "scikit-learn")


class Finished(NamedTuple):
    """What came out of a run."""

    engine: Engine[Any, Any, Any]
    resolved: dict[str, Any]
    """The pipeline with every option written out."""
    plugins: dict[str, str]
    """The distribution that each part comes from, by role and name."""
    summary: dict[str, float]
    """What the observers counted; NaN for what is no number."""
    decisions: Arrays
    measures: tuple[Measure, ...] = ()
    """What the world, the observers and every run declare."""
    notices: tuple[Notice, ...] = ()
    """What kept the learner from having any effect."""


def run_pipeline(pipeline: Pipeline, observers: Sequence[Observer] = ()) -> Finished:
    """Run a pipeline in its own world and return what came out.

    Args:
        pipeline: Says parts, world, seed and number of decisions.
        observers: More observers than the pipeline names, for example a progress bar.
    """
    with pipeline.built() as built, ExitStack() as stack:
        # Before the run: what cannot be written down should not cost a run.
        resolved, plugins = describe(built.engine, built.world, pipeline), find_providers(built, pipeline.registry)
        recorder = Recorder([*built.observers, *observers])
        noticer = Noticer()
        counting = [Tally(), WorldEvents(), recorder, noticer]
        for observer in (*counting, *observers):
            slot = f"observers.{observer.name}"
            observer.bind(Binding(pipeline.header.seed, slot, built.engine.tutor.action))
            stack.callback(observer.close)
        engine, world, header = built.engine, built.world, pipeline.header
        summary = run(engine, world, header.decisions, seed=header.seed, observers=counting)
        measures = (*world.measures, *recorder.measured, *make_tally_measures(engine))
        return Finished(engine, resolved, plugins, summary, recorder.arrays(), measures, noticer.find_notices())


def write_run(directory: Path, finished: Finished, final: Path | None = None) -> str | None:
    """Write the run's files into `directory`.

    Args:
        directory: New, empty, or with an earlier run in it.
        finished: The run.
        final: What messages call the directory, where it will be moved afterwards.

    Returns:
        None, or a sentence about why what was learned could not be saved; the other files are written.

    Raises:
        PipelineError: if the directory cannot be written.
    """
    final = final or directory
    prepare(directory)
    with explain_write_errors(final):
        with (directory / "pipeline.yaml").open("w", encoding="utf-8") as stream:
            YAML().dump(finished.resolved, stream)
        save_arrays(directory / "decisions.npz", finished.decisions)
        text = json.dumps(_make_record(finished), indent=2, sort_keys=True, allow_nan=False)
        (directory / "run.json").write_text(f"{text}\n", encoding="utf-8")
        (directory / "learned.npz").unlink(missing_ok=True)
    problem = _save_learned(directory / "learned.npz", finished.engine)
    return problem and f"{final / 'learned.npz'}: {problem}"


def _save_learned(path: Path, engine: Engine[Any, Any, Any]) -> str | None:
    try:
        save_arrays(path, flatten(engine.state_dict()))
    except Exception as error:  # whatever a part's state_dict() does, the run has been paid for
        path.unlink(missing_ok=True)
        why = " ".join(f"{type(error).__name__}: {error}".split()).rstrip(".")
        return f"what was learned could not be saved: {why}. The other files of the run are written."
    return None


def prepare(directory: Path) -> None:
    """Make a directory for a run. An earlier run's files are overwritten; nothing else is.

    Raises:
        PipelineError: if the directory holds something other than a run, or cannot be made.
    """
    with explain_write_errors(directory):
        if directory.exists() and not directory.is_dir():
            raise PipelineError(f"{directory} is a file; name a directory for the run.")
        if directory.is_dir() and any(directory.iterdir()) and not (directory / "run.json").exists():
            raise PipelineError(f"{directory} holds something other than a run; name another directory.")
        directory.mkdir(parents=True, exist_ok=True)


@contextmanager
def explain_write_errors(path: Path) -> Iterator[None]:
    """Turn errors of the operating system into sentences about a file or folder.

    Raises:
        PipelineError: if something there cannot be read or written.
    """
    try:
        yield
    except OSError as error:
        reason = error.strerror or str(error)
        raise PipelineError(f"{path}: cannot be written: {reason}. Name a directory that you may write to.") from None


def _make_record(finished: Finished) -> dict[str, Any]:
    engine = finished.engine
    return {
        "versions": find_versions(),
        "plugins": finished.plugins,
        "seed": finished.resolved["seed"],
        "decisions": finished.resolved["decisions"],
        "summary": {key: value if math.isfinite(value) else None for key, value in finished.summary.items()},
        "measures": [asdict(measure) for measure in finished.measures],
        "notices": [notice._asdict() for notice in finished.notices],
        "incident_counts": {f"{part}: {kind}": count for (part, kind), count in sorted(engine.incident_counts.items())},
        "newest_incidents": [incident._asdict() for incident in engine.incidents],
    }


def find_providers(built: Built, registry: Registry) -> dict[str, str]:
    """Return the distribution of every part, by role and name, as in ``tutor prototype2``."""
    known = {installed.cls: installed.distribution for installed in registry}
    engine = [part for _, part in built.engine.slots()]
    used = {type(part) for part in _walk_parts([*engine, built.world, *built.observers])}
    return {f"{cls.role} {cls.name}": known[cls] for cls in used if cls in known}


def _walk_parts(parts: Iterable[Component]) -> Iterator[Component]:
    for part in parts:
        yield part
        yield from _walk_parts(nested for _, nested in part.parts())


def find_versions() -> dict[str, str]:
    """Return the versions that a result depends on."""
    found = {"python": platform.python_version(), "machine": platform.machine()}
    for package in PACKAGES:
        try:
            found[package] = metadata.version(package)
        except metadata.PackageNotFoundError:
            found[package] = "not installed"
    return found
