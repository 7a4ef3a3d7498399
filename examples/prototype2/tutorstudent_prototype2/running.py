"""Runs what a study consists of; whatever was finished before is not run again."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

import tutorstudent as ts
from tutorstudent.study import Failure, Job, Plan, Request, Run, Setting, make_plan, pending, read_runs, run_jobs
from tutorstudent_prototype2.pipelines import ENVIRONMENTS

FIRST_SEED = 0
"""Of everything that is reported; the calibration begins at 100,000."""
JOBS = "jobs.json"


def plan_of(
    pipelines: Mapping[str, ts.Pipeline], scenes: Sequence[str], runs: int, decisions: int, controls: bool
) -> Plan:
    """Return the plan of a study: every pipeline in every scene, run i with the seed `FIRST_SEED` + i for all alike.

    Robots start at the poses of the scene and act in its order, whatever the controller (Thesis 4.2).

    Raises:
        PipelineError: Something cannot be built.
    """
    variations = [Setting("world.scene", scene) for scene in scenes]
    request = Request(pipelines, runs, FIRST_SEED, decisions, variations, controls)
    return make_plan(request, ts.Registry.discover())


def read_scenes(text: str) -> list[str]:
    """Return the scenes of a list with commas.

    Raises:
        PipelineError: One is none of the thesis's environments, or there is none.
    """
    scenes = [word.strip() for word in text.split(",") if word.strip()]
    wrong = [scene for scene in scenes if scene not in ENVIRONMENTS]
    if wrong or not scenes:
        found = f"there is no environment '{wrong[0]}'" if wrong else "no environment is named"
        raise ts.PipelineError(f"--scenes {text}: {found}. Environments: {', '.join(ENVIRONMENTS)}.")
    return scenes


def finish(jobs: Sequence[Job], folder: Path, workers: int, title: str) -> tuple[list[Run], list[Failure]]:
    """Run the jobs that have no results yet, with progress on standard error, and read all.

    Raises:
        PipelineError: The folder belongs to other jobs.
    """
    _claim(jobs, folder)
    todo = pending(folder, jobs)
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True)) as progress:
        task = progress.add_task(title, total=len(jobs), completed=len(jobs) - len(todo))
        for finished in run_jobs(todo, folder, workers):
            progress.advance(task)
            if finished.problem:
                progress.console.print(f"failed: {finished.job.folder}: {finished.problem}", markup=False)
    return read_runs(folder, jobs)


def _claim(jobs: Sequence[Job], folder: Path) -> None:
    """Write down what the folder is for, or make sure that it is for these jobs."""
    text = json.dumps([job._asdict() for job in jobs], indent=1, default=str) + "\n"
    path = folder / JOBS
    try:
        other = path.exists() and path.read_text(encoding="utf-8") != text
        folder.mkdir(parents=True, exist_ok=True)
        if not path.exists():
            partial = path.with_name(f".{path.name}.partial")
            partial.write_text(text, encoding="utf-8")
            partial.replace(path)
    except OSError as error:
        raise ts.PipelineError(f"{folder}: cannot be used: {error.strerror or error}. Give another --out.") from None
    if other:
        raise ts.PipelineError(
            f"{folder}: holds a study with other pipelines, settings or numbers; go on with the same ones, or give "
            "another --out."
        )
