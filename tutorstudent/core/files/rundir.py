"""Runs a pipeline in its world and writes the run's directory.

| file | what |
|---|---|
| ``pipeline.yaml`` | the pipeline with every option written out |
| ``decisions.npz`` | every decision, see `Recorder` |
| ``run.json`` | versions, plugins, seed, summary (null: not finite), measures, notices, incidents; whether complete |
| ``learned.npz`` | what was learned, see `arrays.nest` |
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from io import StringIO
from pathlib import Path
from typing import Any

from ruamel.yaml import YAML

from tutorstudent.core.deciding.guard import is_owners
from tutorstudent.core.files.durable import write_whole
from tutorstudent.core.files.finished import Failure, Finished, make_record, name_parts
from tutorstudent.core.files.journal import CUT_SHORT, DECISIONS, RECORD, Journal, remove_blocks, save_record
from tutorstudent.core.files.pipeline import Built, Pipeline, describe
from tutorstudent.core.files.provenance import find_providers, find_versions
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.running.arrays import flatten, save_arrays
from tutorstudent.core.running.meter import Meter, WorldEvents
from tutorstudent.core.running.noticing import Noticer
from tutorstudent.core.running.observers import Observer, Tally, make_tally_measures
from tutorstudent.core.running.recorder import Recorder
from tutorstudent.core.running.runner import run_loop
from tutorstudent.core.running.whereabouts import BEGIN, CLOSE, OWN, SAVE, Whereabouts
from tutorstudent.core.words.errors import PipelineError, say_error


def run_pipeline(pipeline: Pipeline, observers: Sequence[Observer] = ()) -> Finished:
    """Run a pipeline in its own world and return what came out.

    Args:
        pipeline: Says parts, world, seed and number of decisions.
        observers: More observers than the pipeline names, for example a progress bar.
    """
    finished = try_pipeline(pipeline, observers)
    if finished.failure is not None:
        raise finished.failure.error
    return finished


def try_pipeline(
    pipeline: Pipeline,
    observers: Sequence[Observer] = (),
    folder: Path | None = None,
    at: Whereabouts | None = None,
) -> Finished:
    """Run a pipeline as `run_pipeline` does, but whatever ends the run, return what was decided before.

    Args:
        pipeline: Says parts, world, seed and number of decisions.
        observers: More observers than the pipeline names.
        folder: Is given the pipeline at the beginning, and then every decision, a block at a time.
        at: Notes down where the run is.

    Raises:
        TutorStudentError: if something cannot be built.
    """
    at, finished = at or Whereabouts(), None
    at.enter(OWN)
    try:
        with pipeline.built() as built:
            finished = _run_built(pipeline, built, observers, folder, at)
            at.enter(CLOSE)
    except BaseException as error:
        if finished is None:
            raise
        if is_owners(error):
            return finished._replace(failure=finished.failure or Failure(error, "interrupted while parts were closed"))
        return finished._replace(notes=(*finished.notes, f"a part could not be closed: {say_error(error)}"))
    return finished


def _run_built(
    pipeline: Pipeline, built: Built, observers: Sequence[Observer], folder: Path | None, at: Whereabouts
) -> Finished:
    # Before the run: what cannot be written down should not cost a run.
    resolved, plugins = describe(built.engine, built.world, pipeline), find_providers(built, pipeline.registry)
    at.note((at.read() or {}) | name_parts(built))
    recorder = Recorder([*built.observers, *observers])
    journal = None if folder is None else Journal(folder, recorder)
    if folder is not None:
        _begin_folder(folder, resolved, plugins)
    noticer = Noticer()
    meter = Meter([Tally(), WorldEvents(), recorder, noticer, *filter(None, [journal])])
    with ExitStack() as stack:
        for observer in (*meter.observers, *observers):
            slot = f"observers.{observer.name}"
            observer.bind(Binding(pipeline.header.seed, slot, built.engine.tutor.action))
            stack.callback(observer.close)
        failure = _run_loop(pipeline, built, meter, journal, at)
        if failure is not None and at.place == BEGIN:
            return Finished(built.engine, resolved, plugins, {}, {}, (), failure)
        summary = _sum_up(meter, failure)
    measures = (*built.world.measures, *recorder.measured, *make_tally_measures(built.engine))
    notices = noticer.find_notices()
    return Finished(built.engine, resolved, plugins, summary, recorder.arrays(), measures, failure, notices=notices)


def _run_loop(
    pipeline: Pipeline, built: Built, meter: Meter, journal: Journal | None, at: Whereabouts
) -> Failure | None:
    """Run the loop; return what ended it too early. What is decided is written down in both cases."""
    header, failure = pipeline.header, None
    try:
        run_loop(built.engine, built.world, header.decisions, header.seed, meter, at)
    except BaseException as error:
        failure = Failure.explain(error, built, at)
    if journal is not None and at.place != BEGIN:
        try:
            journal.write()
        except PipelineError as error:
            failure = failure or Failure(error, f"decision {at.decision}: {error}")
    return failure


def _sum_up(meter: Meter, failure: Failure | None) -> dict[str, float]:
    try:
        return meter.summary()
    except Exception:
        if failure is None:
            raise
        return {}


def _begin_folder(folder: Path, resolved: dict[str, Any], plugins: dict[str, str]) -> None:
    with explain_write_errors(folder):
        _write_pipeline(folder, resolved)
        about = {"seed": resolved["seed"], "decisions": resolved["decisions"], "plugins": plugins}
        save_record(
            folder, about | {"versions": find_versions(), "complete": False, "problem": CUT_SHORT, "decided": 0}
        )


def _write_pipeline(folder: Path, resolved: dict[str, Any]) -> None:
    stream = StringIO()
    YAML().dump(resolved, stream)
    write_whole(folder / "pipeline.yaml", stream.getvalue())


def write_run(directory: Path, finished: Finished, final: Path | None = None, at: Whereabouts | None = None) -> str:
    """Write the run's files into `directory`, each of them whole.

    Args:
        directory: New, empty, or with an earlier run in it.
        finished: The run.
        final: What messages call the directory, where it will be moved afterwards.
        at: Notes down when what was learned is asked for.

    Returns:
        Nothing, or a sentence about why what was learned could not be saved; the other files are written.

    Raises:
        PipelineError: if the directory cannot be written.
    """
    final = final or directory
    prepare(directory)
    problem = _save_learned(directory / "learned.npz", finished, at or Whereabouts())
    with explain_write_errors(final):
        _write_pipeline(directory, finished.resolved)
        if finished.decisions:
            save_arrays(directory / DECISIONS, finished.decisions)
        save_record(directory, make_record(finished, find_versions()))
        remove_blocks(directory)
    return problem and f"{final / 'learned.npz'}: {problem}"


def _save_learned(path: Path, finished: Finished, at: Whereabouts) -> str:
    at.enter(SAVE)
    try:
        path.unlink(missing_ok=True)
        save_arrays(path, flatten(finished.engine.state_dict()))
    except BaseException as error:  # whatever a part's state_dict() does, the run has been paid for
        if is_owners(error):
            raise
        why = say_error(error)
        return f"what was learned could not be saved: {why} The other files of the run are written."
    finally:
        at.enter(OWN)
    return ""


def prepare(directory: Path) -> None:
    """Make a directory for a run. An earlier run's files are overwritten; nothing else is.

    Raises:
        PipelineError: if the directory holds something other than a run, or cannot be made.
    """
    check_directory(directory)
    with explain_write_errors(directory):
        directory.mkdir(parents=True, exist_ok=True)


def check_directory(directory: Path) -> None:
    """Refuse a directory that holds something other than a run.

    Raises:
        PipelineError: if it does, or cannot be read.
    """
    with explain_write_errors(directory):
        if directory.exists() and not directory.is_dir():
            raise PipelineError(f"{directory} is a file; name a directory for the run.")
        if directory.is_dir() and any(directory.iterdir()) and not (directory / RECORD).exists():
            raise PipelineError(f"{directory} holds something other than a run; name another directory.")


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
