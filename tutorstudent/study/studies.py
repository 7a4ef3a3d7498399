"""A whole study, begun or resumed: plan, drawings, the search for a level, every run, tables and page."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import closing
from pathlib import Path
from typing import NamedTuple

from tutorstudent.core.files.durable import PARTIAL, lock_folder, remove_partial
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.rundir import explain_write_errors
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.study.plans.constant_level import FOLDER, settle
from tutorstudent.study.plans.plan import Job, Plan
from tutorstudent.study.plans.planfile import FILE, check_versions, find_differences, load_plan, make_data, save_plan
from tutorstudent.study.plans.resolving import draw_sketch, reread
from tutorstudent.study.runs.backends import LOKY, Backend, check_backend
from tutorstudent.study.runs.jobs import run_jobs
from tutorstudent.study.runs.progress import show_progress
from tutorstudent.study.runs.results import Study, pending, read_study
from tutorstudent.study.runs.searching import find_levels, keep_levels
from tutorstudent.study.runs.sketches import save_sketch
from tutorstudent.study.runs.timing import Sitting


class Workforce(NamedTuple):
    """Who runs the jobs, and in how many processes."""

    workers: int
    backend: Backend


def run_study(plan: Plan, folder: Path, workers: int = 1, backend: Backend = LOKY) -> Study:
    """Run a plan as ``tutorstudent compare`` does: `run_plan`, then the tables and the page."""
    from tutorstudent.study.page.report import write_report  # matplotlib is an extra

    run_plan(plan, folder, workers, backend)
    return write_report(folder)


def run_plan(plan: Plan, folder: Path, workers: int = 1, backend: Backend = LOKY) -> Study:
    """Run a plan, with its progress on standard error; write no report.

    If the folder holds a study of the same plan, that study goes on: complete runs stay, all others are run. Results
    are the same to the last byte for any number of workers and interruptions, except for the timing.

    Args:
        plan: From `make_plan`, or put together by hand.
        folder: For all results; new or empty, or with a study of the same plan.
        workers: Number of processes.
        backend: Who runs the jobs.

    Raises:
        PipelineError: if the folder holds something else or cannot be written, another process works in it, or the
            backend is not there.
    """
    check_backend(backend)
    begin(plan, folder)
    with lock_folder(folder):
        with explain_write_errors(folder):
            remove_partial(folder)
        plan = _run_all(plan, folder, workers, backend)
    return read_study(folder, plan)


def begin(plan: Plan, folder: Path) -> None:
    """Write the plan into its folder with a drawing of every environment, or make sure that it is there.

    Raises:
        PipelineError: if the folder holds something else, another plan, or cannot be written.
    """
    with explain_write_errors(folder):
        there = (folder / FILE).exists()
    if there:
        check_same(plan, folder)
    else:
        check_folder(folder)
        with explain_write_errors(folder):
            folder.mkdir(parents=True, exist_ok=True)
            save_plan(plan, folder)
    _draw(plan, folder)


def check_folder(folder: Path) -> None:
    """Refuse a folder that is not empty.

    Raises:
        PipelineError: if it does, or cannot be read.
    """
    with explain_write_errors(folder):
        if folder.exists() and not folder.is_dir():
            raise PipelineError(f"--out {folder}: there is a file of that name; give a folder.")
        found = [path.name for path in folder.iterdir()] if folder.is_dir() else []
    if FILE in found:
        raise PipelineError(
            f"--out {folder}: the folder is not empty; it holds a study. Add --resume to go on with it, or give "
            "a new folder."
        )
    if any(not name.endswith(PARTIAL) for name in found):
        raise PipelineError(f"--out {folder}: the folder is not empty; give a new one, or remove what is in it.")


def check_same(plan: Plan, folder: Path) -> None:
    """Refuse to resume a study with another plan, or one that was begun with other versions.

    Raises:
        PipelineError: with what differs.
    """
    check_versions(folder)
    there = load_plan(folder)
    if there != plan:
        differences = find_differences(make_data(there), make_data(plan))
        raise PipelineError(
            f"{folder}: its {FILE} is that of another study. What differs: {differences}. "
            "Leave the pipelines out to go on with the one that is there, or give another folder."
        )


def _draw(plan: Plan, folder: Path) -> None:
    registry = Registry.discover()
    for environment in plan.environments:
        path = folder / "sketches" / f"{environment.name}.json"
        if not path.exists():
            values = environment.variants[0].pipeline | {"seed": plan.seeds[0]}
            sketch = draw_sketch(reread(environment.name, values, registry))
            with explain_write_errors(folder):
                save_sketch(path, sketch)


def _run_all(plan: Plan, folder: Path, workers: int, backend: Backend) -> Plan:
    """Run the search, if there is one, and then everything else; return the plan with what was found."""
    sitting, workforce = Sitting(folder, workers), Workforce(workers, backend)
    if plan.search is not None:
        _run_jobs("search: constant levels", plan.search.plan.jobs(), folder / FOLDER, sitting, workforce)
        searched = find_levels(plan.search, folder)
        with explain_write_errors(folder):
            keep_levels(plan, searched, folder)
        plan = settle(plan, searched)
    _run_jobs(f"runs of {plan.decisions} decisions", plan.jobs(), folder, sitting, workforce)
    return plan


def _run_jobs(title: str, jobs: Sequence[Job], folder: Path, sitting: Sitting, workforce: Workforce) -> None:
    left = pending(folder, jobs)
    with closing(run_jobs(left, folder, *workforce)) as results:
        for _ in show_progress(results, title, len(jobs), done=len(jobs) - len(left)):
            with explain_write_errors(folder):
                sitting.note()
