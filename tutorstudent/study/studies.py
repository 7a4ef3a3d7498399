"""A whole study: plan, drawings, every run, tables and page."""

from __future__ import annotations

from pathlib import Path

from tutorstudent.core.errors import PipelineError
from tutorstudent.core.registry import Registry
from tutorstudent.core.rundir import writing
from tutorstudent.study.jobs import run_jobs
from tutorstudent.study.plan import Plan, save_plan
from tutorstudent.study.progress import shown
from tutorstudent.study.resolving import reread, sketch_of
from tutorstudent.study.results import Study
from tutorstudent.study.sketches import save_sketch


def run_study(plan: Plan, folder: Path, workers: int = 1) -> Study:
    """Run a plan as ``tutorstudent compare`` does, with its progress on standard error, and write its report.

    Args:
        plan: From `make_plan`, or put together by hand.
        folder: For all results.
        workers: Number of processes; the results are the same for any number.

    Raises:
        PipelineError: if the folder holds something else, or cannot be written.
    """
    from tutorstudent.study.report import write_report  # matplotlib is an extra

    check_folder(folder)
    write_plan(plan, folder, Registry.discover())
    jobs = plan.jobs()
    for _ in shown(run_jobs(jobs, folder, workers), f"runs of {plan.decisions} decisions", len(jobs)):
        pass
    return write_report(folder)


def check_folder(out: Path) -> None:
    """Refuse a folder that holds something already.

    Raises:
        PipelineError: if it does, or cannot be read.
    """
    with writing(out):
        if out.exists() and not out.is_dir():
            raise PipelineError(f"--out {out}: there is a file of that name; give a folder.")
        if out.is_dir() and any(out.iterdir()):
            raise PipelineError(f"--out {out}: the folder is not empty; give a new one, or remove what is in it.")


def write_plan(plan: Plan, out: Path, registry: Registry) -> None:
    """Write the plan, and the drawing of every environment.

    Raises:
        PipelineError: if the folder cannot be written.
    """
    with writing(out):
        out.mkdir(parents=True, exist_ok=True)
    for environment in plan.environments:
        pipeline = reread(environment.name, environment.variants[0].pipeline | {"seed": plan.seeds[0]}, registry)
        sketch = sketch_of(pipeline)
        with writing(out):
            save_sketch(out / "sketches" / f"{environment.name}.json", sketch)
    with writing(out):
        save_plan(plan, out)
