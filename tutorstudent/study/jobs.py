"""Runs the jobs of a plan, in this process or in several; the results are the same."""

from __future__ import annotations

import traceback
from collections.abc import Iterator, Sequence
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager, nullcontext
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

from tutorstudent.core.registry import Registry
from tutorstudent.core.rundir import run_pipeline, write_run
from tutorstudent.study.plan import Job
from tutorstudent.study.resolving import reread

ERROR = "error.txt"
"""What a run that failed leaves behind: the problem in the first line, then where it arose."""


class Finished(NamedTuple):
    """A job that is over."""

    job: Job
    problem: str
    """Why it failed, or empty."""
    note: str = ""
    """What could not be saved although it did not fail, or empty."""


def run_jobs(jobs: Sequence[Job], folder: Path, workers: int) -> Iterator[Finished]:
    """Run the jobs and yield each as it ends, in any order; a job that fails does not take the others along.

    Args:
        jobs: The runs.
        folder: The study's; each run writes into its own folder below.
        workers: Number of processes; 1 stays in this one.
    """
    if workers == 1:
        registry = Registry.discover()
        yield from (run_job(job, folder, registry) for job in jobs)
        return
    waiting = {job.folder: job for job in jobs}
    try:
        for finished in _in_parallel(jobs, folder, workers):
            del waiting[finished.job.folder]
            yield finished
    except BrokenProcessPool as error:
        problem = f"a worker process died, and what had not ended with it ({type(error).__name__})."
        yield from (_failed(job, folder, problem, str(error)) for job in waiting.values())


def run_job(job: Job, folder: Path, registry: Registry | None = None) -> Finished:
    """Run one job and write its results, or `ERROR`, into its folder; without a registry it looks for the plugins."""
    try:
        own = {"seed": job.seed, "decisions": job.decisions}
        pipeline = reread(str(job.folder), job.pipeline | own, registry or Registry.discover())
        with _one_thread():
            finished = run_pipeline(pipeline)
        note = write_run(folder / job.folder, finished) or ""
    except Exception as error:
        return _failed(job, folder, f"{type(error).__name__}: {error}", traceback.format_exc())
    return Finished(job, "", note)


def _failed(job: Job, folder: Path, problem: str, trace: str) -> Finished:
    problem = " ".join(problem.split())
    place = folder / job.folder
    place.mkdir(parents=True, exist_ok=True)
    (place / ERROR).write_text(f"{problem}\n\n{trace}", encoding="utf-8")
    return Finished(job, problem)


def _in_parallel(jobs: Sequence[Job], folder: Path, workers: int) -> Iterator[Finished]:
    import joblib  # an extra: the rest of the package does without

    with joblib.parallel_config(backend="loky", inner_max_num_threads=1):
        parallel = joblib.Parallel(n_jobs=workers, return_as="generator_unordered", batch_size=1)
    yield from parallel(joblib.delayed(run_job)(job, folder) for job in jobs)


def _one_thread() -> AbstractContextManager[Any]:
    # Sums over several threads may differ in the last bit. The limiter comes with scikit-learn; numpy alone does not
    # split what is as small as these networks.
    if find_spec("threadpoolctl") is None:
        return nullcontext()
    limits: AbstractContextManager[Any] = import_module("threadpoolctl").threadpool_limits(1)
    return limits
