"""Runs the jobs of a plan, in this process or in several; the results are the same."""

from __future__ import annotations

import traceback
from collections.abc import Generator, Iterator, Sequence
from contextlib import AbstractContextManager, nullcontext
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

from tutorstudent.core.files.durable import replace_folder
from tutorstudent.core.files.registry import Registry, find_registry
from tutorstudent.core.files.rundir import explain_write_errors, run_pipeline, write_run
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
    waiting = {job.folder: job for job in jobs}
    try:
        for finished in _run_in_parallel(jobs, folder.resolve(), workers, backend):
            del waiting[finished.job.folder]
            yield finished
    except WorkersLost as error:
        yield from (_report_failure(job, folder, str(error), str(error.__cause__)) for job in waiting.values())


def run_job(job: Job, folder: Path, registry: Registry | None = None) -> Finished:
    """Run one job and write its results, or `ERROR`, into its folder; finds the plugins if it is given no registry."""
    own_folder = folder / job.folder
    try:
        own = {"seed": job.seed, "decisions": job.decisions}
        pipeline = reread(str(job.folder), job.pipeline | own, registry or find_registry())
        watch = Stopwatch()
        with _limit_threads():
            finished = run_pipeline(pipeline)
        with replace_folder(own_folder) as partial:
            note = write_run(partial, finished, own_folder) or ""
            save_timing(partial, watch.read())
    except Exception as error:
        return _report_failure(job, folder, f"{type(error).__name__}: {error}", traceback.format_exc())
    return Finished(job, "", note)


def _report_failure(job: Job, folder: Path, problem: str, trace: str) -> Finished:
    problem = " ".join(problem.split())
    own_folder = folder / job.folder
    with explain_write_errors(own_folder), replace_folder(own_folder) as partial:
        (partial / ERROR).write_text(f"{problem}\n\n{trace}", encoding="utf-8")
    return Finished(job, problem)


def _run_in_parallel(jobs: Sequence[Job], folder: Path, workers: int, backend: Backend) -> Iterator[Finished]:
    import joblib  # an extra: the rest of the package does without

    with start(backend, workers) as parallel:
        yield from parallel(joblib.delayed(run_job)(job, folder) for job in jobs)


def _limit_threads() -> AbstractContextManager[Any]:
    # Sums over several threads may differ in the last bit. The limiter comes with scikit-learn; numpy alone does not
    # split what is as small as these networks.
    if find_spec("threadpoolctl") is None:
        return nullcontext()
    limits: AbstractContextManager[Any] = import_module("threadpoolctl").threadpool_limits(1)
    return limits
