"""Keeps a run in its folder, whatever ends it: it is written beside it, and becomes the folder in one step."""

from __future__ import annotations

import shutil
import signal
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from tutorstudent.core.files.durable import PARTIAL, lock_folder, place_folder
from tutorstudent.core.files.finished import Finished
from tutorstudent.core.files.journal import RECORD, finish_cut_short, is_complete, load_record
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.rundir import check_directory, explain_write_errors, try_pipeline, write_run
from tutorstudent.core.running.observers import Observer
from tutorstudent.core.running.whereabouts import Whereabouts
from tutorstudent.core.words.errors import PipelineError

Beside = Callable[[Path, Finished], None]
"""Writes more files into the folder of a run."""


class Kept(NamedTuple):
    """A run that is over, and where it is."""

    finished: Finished
    folder: Path
    """The one that was asked for; or, if that one holds a complete run and this one failed, one beside it."""
    notes: tuple[str, ...]
    """What could not be saved or closed, if the run itself was fine."""


@contextmanager
def claim(folder: Path) -> Iterator[Path]:
    """Yield an empty folder in which a run is written; no other process gets it meanwhile.

    What a process has left in it that was killed becomes a folder of its own, beside `folder`.

    Raises:
        PipelineError: if another process is writing this run, or the folder holds something else.
    """
    check_directory(folder)
    partial = folder.with_name(f".{folder.name}{PARTIAL}")
    busy = f"{folder}: another process is writing this run; wait for it, or name another folder."
    with explain_write_errors(folder):
        partial.mkdir(parents=True, exist_ok=True)
        with lock_folder(partial, busy):
            if any(partial.iterdir()):
                rescue(partial, folder)
        partial.mkdir(exist_ok=True)
    with lock_folder(partial, busy):
        yield partial


def keep_run(
    pipeline: Pipeline,
    folder: Path,
    partial: Path,
    at: Whereabouts,
    observers: Sequence[Observer] = (),
    beside: Beside | None = None,
) -> Kept:
    """Run a pipeline and keep what was decided, whatever ends it.

    Args:
        pipeline: Says parts, world, seed and number of decisions.
        folder: What the run's folder is to be; an absolute path.
        partial: Where it is written until it is over; on the same disk.
        at: Notes down where the run is, for whoever watches over this process.
        observers: More observers than the pipeline names.
        beside: Writes more files.

    Raises:
        TutorStudentError: if something cannot be built, or not be written; what could be written is kept.
    """
    at.note({"folder": str(folder), "partial": str(partial)})
    try:
        finished = try_pipeline(pipeline, observers, partial, at)
        with _hold_signals():
            note = _write(folder, partial, finished, at)
            if beside is not None:
                beside(partial, finished)
            kept = settle(partial, folder, complete=finished.failure is None)
    finally:
        shutil.rmtree(partial, ignore_errors=True)
        at.note(None)
    return Kept(finished, kept, tuple(filter(None, (note, *finished.notes))))


def _write(folder: Path, partial: Path, finished: Finished, at: Whereabouts) -> str:
    try:
        return write_run(partial, finished, folder, at)
    except PipelineError as error:
        said = f"decision {at.decision}: {error}" if finished.failure is None else finished.failure.problem
        raise PipelineError(f"{said} {say_kept(rescue(partial, folder, said))}") from error


def rescue(partial: Path, folder: Path, problem: str = "") -> Path:
    """Keep what a run left that could not be finished, and return where it is."""
    finish_cut_short(partial, problem)
    return settle(partial, folder, complete=False)


def settle(partial: Path, folder: Path, *, complete: bool) -> Path:
    """Make a written folder the run's, and return where it is; a failed run never replaces a complete one."""
    target = folder if complete else _find_place(folder)
    with explain_write_errors(target):
        place_folder(partial, target)
    return target


def say_kept(folder: Path) -> str:
    """Return the sentence about a run that failed."""
    return f"What was decided before is kept in {folder}; its {RECORD} says that it is not complete."


def _find_place(folder: Path) -> Path:
    if not (folder / RECORD).exists() or not is_complete(load_record(folder)):
        return folder
    names = (f"{folder.name}-failed{'' if number == 1 else f'-{number}'}" for number in range(1, 1_000_000))
    return next(path for path in map(folder.with_name, names) if not path.exists())


@contextmanager
def _hold_signals() -> Iterator[None]:
    """Let a stop from outside wait until the run is written."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM, signal.SIGHUP})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
