"""Runs the jobs of a plan, in this process or in several; the results are the same."""

from __future__ import annotations

import os
import shutil
import traceback
from collections.abc import Generator, Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

from tutorstudent.core.deciding.guard import is_owners
from tutorstudent.core.files.durable import find_partial, make_partial, replace_folder
from tutorstudent.core.files.finished import Finished as Run
from tutorstudent.core.files.keeping import keep_run, rescue
from tutorstudent.core.files.registry import Registry, find_registry
from tutorstudent.core.files.rundir import explain_write_errors
from tutorstudent.core.running.parenthood import watch_parent
from tutorstudent.core.running.whereabouts import HERE
from tutorstudent.core.words.errors import say_error
from tutorstudent.study.plans.plan import Job
from tutorstudent.study.plans.resolving import reread
from tutorstudent.study.runs.backends import LOKY, Backend, WorkersLost, start
from tutorstudent.study.runs.timing import Stopwatch, save_timing

ERROR = "error.txt"
"""What a run that failed leaves behind: the problem in the first line, then where it arose."""


class Finished(NamedTuple):
    """A job that is over."""

    job: Job
    problem: str
    """Why it failed, or empty."""
    note: str = ""
    """What could not be saved, if the run itself was fine."""


def run_jobs(jobs: Sequence[Job], folder: Path, workers: int = 1, backend: Backend = LOKY) -> Generator[Finished]:
    """Run the jobs and yield each as it ends, in any order; a job that fails does not stop the others.

    Args:
        jobs: The runs. Each is run, whatever its folder holds already; `pending` returns those that are not complete.
        folder: The study's; each run writes into its own folder below, which is there completely or not at all.
        workers: Number of processes; one of loky's stays in this one.
        backend: Who runs the jobs.

    Raises:
        PipelineError: if the backend is not there, or the folder cannot be written.
    """
    if workers == 1 and backend.name == "loky":
        registry = Registry.discover()
        yield from (run_job(job, folder, registry) for job in jobs)
        return
    yield from _run_safely(jobs, folder.resolve(), workers, backend)


def _run_safely(jobs: Sequence[Job], folder: Path, workers: int, backend: Backend) -> Iterator[Finished]:
    """Run jobs in parallel; where the workers are lost, only the jobs that end them fail."""
    waiting = {job.folder: job for job in jobs}
    try:
        for finished in _run_in_parallel(jobs, folder, workers, backend):
            del waiting[finished.job.folder]
            yield finished
    except WorkersLost as error:
        begun = [job for job in waiting.values() if find_partial(folder / job.folder)]
        if len(waiting) == 1 or not begun:
            yield from (_report_lost(job, folder, error) for job in waiting.values())
            return
        for path in [path for job in begun for path in find_partial(folder / job.folder) if len(begun) > 1]:
            shutil.rmtree(path)
        fresh = [job for job in waiting.values() if job not in begun]
        for job in begun:  # each by itself, so that it is seen which of them it was
            if len(begun) == 1:
                yield _report_lost(job, folder, error)
            else:
                yield from _run_safely([job], folder, workers, backend)
        if fresh:
            yield from _run_safely(fresh, folder, workers, backend)


def _report_lost(job: Job, folder: Path, error: WorkersLost) -> Finished:
    own_folder, said = folder / job.folder, str(error)
    for partial in find_partial(own_folder):
        rescue(partial, own_folder, said)
        save_error(own_folder, said, str(error.__cause__))
        return Finished(job, said)
    return _report_failure(job, folder, said, str(error.__cause__))


def run_job(job: Job, folder: Path, registry: Registry | None = None) -> Finished:
    """Run one job and write its results, or `ERROR`, into its folder; finds the plugins if it is given no registry.

    A run that failed keeps what was decided before. One that is interrupted from outside leaves nothing.
    """
    own_folder = folder / job.folder
    try:
        own = {"seed": job.seed, "decisions": job.decisions}
        pipeline = reread(str(job.folder), job.pipeline | own, registry or find_registry())
        with explain_write_errors(own_folder):
            partial = make_partial(own_folder)
        with _limit_threads():
            kept = keep_run(pipeline, own_folder, partial, HERE, beside=_Beside())
    except BaseException as error:
        if is_owners(error):
            raise
        said = say_error(error)
        trace = "".join(traceback.format_exception(error))
        return _report_failure(job, folder, said, trace)
    failure = kept.finished.failure
    return Finished(job, "" if failure is None else failure.problem, " ".join(kept.notes))


class _Beside:
    """Writes what the job took, and why it failed."""

    def __init__(self) -> None:
        self._watch = Stopwatch()

    def __call__(self, partial: Path, finished: Run) -> None:
        failure = finished.failure
        if failure is None:
            save_timing(partial, self._watch.read())
        elif failure.is_owners:
            raise failure.error
        else:
            save_error(partial, failure.problem, "".join(traceback.format_exception(failure.error)))


def save_error(folder: Path, problem: str, trace: str) -> None:
    """Write why a run failed into its folder."""
    (folder / ERROR).write_text(f"{' '.join(problem.split())}\n\n{trace}", encoding="utf-8")


def _report_failure(job: Job, folder: Path, problem: str, trace: str) -> Finished:
    own_folder = folder / job.folder
    with explain_write_errors(own_folder), replace_folder(own_folder) as partial:
        save_error(partial, problem, trace)
    return Finished(job, " ".join(problem.split()))


def _run_in_parallel(jobs: Sequence[Job], folder: Path, workers: int, backend: Backend) -> Iterator[Finished]:
    import joblib  # an extra: the rest of the package does without

    parent = os.getpid() if backend.name == "loky" else 0
    with start(backend, workers) as parallel:
        yield from parallel(joblib.delayed(_work)(job, folder, parent) for job in jobs)


def _work(job: Job, folder: Path, parent: int) -> Finished:
    if parent:
        watch_parent(parent, lambda: os._exit(1))
    return run_job(job, folder)


def _limit_threads() -> AbstractContextManager[Any]:
    # Sums over several threads may differ in the last bit. The limiter comes with scikit-learn; numpy alone does not
    # split what is as small as these networks.
    if find_spec("threadpoolctl") is None:
        return nullcontext()
    limits: AbstractContextManager[Any] = import_module("threadpoolctl").threadpool_limits(1)
    return limits
