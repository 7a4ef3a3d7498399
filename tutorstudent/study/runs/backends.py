"""Where jobs run in parallel: processes of this machine or a dask or ray cluster, all through joblib."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterator
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from importlib import import_module
from importlib.util import find_spec
from typing import Any, NamedTuple

from tutorstudent.core.words.errors import PipelineError, list_names, suggest

MODULES = {"loky": "joblib", "dask": "distributed", "ray": "ray"}
EXTRAS = {"loky": "study", "dask": "dask", "ray": "ray"}


class Backend(NamedTuple):
    """Who runs the jobs."""

    name: str = "loky"
    """``loky``: processes of this machine; ``dask``, ``ray``."""
    address: str = ""
    """Of a cluster's scheduler, HOST:PORT; empty: one that is started on this machine for the study.

    All machines of a cluster must see the study's folder under the same path, and have the same packages."""


LOKY = Backend()


class WorkersLost(Exception):
    """The workers died, and with them the jobs that had not ended."""


def check_backend(backend: Backend) -> None:
    """Refuse a backend that is not there.

    Raises:
        PipelineError: with the remedy.
    """
    name, address = backend
    if name not in MODULES:
        raise PipelineError(f"--backend {name}: unknown{suggest(name, MODULES)}. Backends: {list_names(MODULES)}.")
    if find_spec(MODULES[name]) is None:
        raise PipelineError(
            f"--backend {name} needs {MODULES[name]}; install it with: pip install 'tutorstudent[{EXTRAS[name]}]'"
        )
    if name == "loky" and address:
        raise PipelineError(f"--address {address}: loky runs on this machine only; add --backend dask or ray.")


@contextmanager
def start(backend: Backend, workers: int) -> Iterator[Any]:
    """Yield a `joblib.Parallel` that returns results as jobs end; it is shut down at the end.

    Args:
        backend: Who runs the jobs.
        workers: Number of processes; a cluster with an address has its own.

    Raises:
        PipelineError: if the backend is not there, or its cluster does not answer.
        WorkersLost: if it has gone before all jobs had ended.
    """
    check_backend(backend)
    how = {"loky": _start_loky, "dask": _start_dask, "ray": _start_ray}[backend.name]
    with warnings.catch_warnings():
        # An interrupted study lets go of jobs that have not ended; that is what is wanted.
        warnings.filterwarnings("ignore", message=r"\d+ tasks have been successfully executed", category=UserWarning)
        with how(backend.address, workers) as parallel:
            yield parallel


@contextmanager
def _start_loky(_: str, workers: int) -> Iterator[Any]:
    import joblib  # an extra, like all below: the rest of the package does without

    with joblib.parallel_config(backend="loky", inner_max_num_threads=1):
        parallel = joblib.Parallel(n_jobs=workers, return_as="generator_unordered", batch_size=1)
    try:
        yield parallel
    except BrokenProcessPool as error:
        raise WorkersLost(f"a worker process died, and its run with it ({type(error).__name__}).") from error
    except (KeyboardInterrupt, SystemExit, GeneratorExit):
        end_workers()
        raise


def end_workers() -> None:
    """End the processes that loky keeps for the next jobs, if there are any."""
    if "joblib" in sys.modules:
        from joblib.externals.loky import reusable_executor

        if reusable_executor._executor is not None:
            reusable_executor._executor.shutdown(wait=True, kill_workers=True)


@contextmanager
def _start_dask(address: str, workers: int) -> Iterator[Any]:
    import joblib

    distributed = import_module("distributed")
    try:
        client = distributed.Client(address) if address else distributed.Client(**_describe_local(workers))
    except (OSError, ValueError, RuntimeError) as error:
        where = f"at {address}, is its scheduler running?" if address else "on this machine."
        raise PipelineError(f"--backend dask: no cluster {where} {type(error).__name__}: {error}") from None
    with client, joblib.parallel_config(backend="dask", client=client):
        try:
            yield joblib.Parallel(n_jobs=-1, return_as="generator_unordered", batch_size=1)
        except distributed.KilledWorker as error:
            raise WorkersLost(f"a dask worker died, and unfinished jobs with it ({error}).") from error


def _describe_local(workers: int) -> dict[str, Any]:
    return {"n_workers": workers, "threads_per_worker": 1, "dashboard_address": None}


@contextmanager
def _start_ray(address: str, workers: int) -> Iterator[Any]:
    import joblib

    ray = import_module("ray")
    import_module("ray.util.joblib").register_ray()
    try:
        ray.init(**({"address": address} if address else {"num_cpus": workers, "include_dashboard": False}))
    except Exception as error:  # ray raises plain exceptions where a node does not start
        where = f"at {address}, is its head running?" if address else "on this machine."
        raise PipelineError(f"--backend ray: no cluster {where} {type(error).__name__}: {error}") from None
    try:
        with joblib.parallel_config(backend="ray"):
            # It cannot hand out results one by one: they come when all have ended.
            yield joblib.Parallel(n_jobs=-1 if address else workers, batch_size=1)
    except ray.exceptions.RayError as error:
        raise WorkersLost(f"a ray worker died, and unfinished jobs with it ({type(error).__name__}).") from error
    finally:
        ray.shutdown()


STUDY = ("joblib", "matplotlib", "scipy")


def check_extras(modules: tuple[str, ...] = STUDY) -> None:
    """Refuse to begin a study that cannot be finished because a package is missing.

    Raises:
        PipelineError: if a module is missing, with the remedy.
    """
    missing = [module for module in modules if find_spec(module) is None]
    if missing:
        raise PipelineError(
            f"comparing pipelines needs {' and '.join(missing)}; install it with: pip install 'tutorstudent[study]'"
        )
