"""Runs jobs of one's own, as a study's: what was finished before is not run again, and a folder holds one study."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from tutorstudent.core.files.durable import write_whole
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.study.plans.plan import Job
from tutorstudent.study.runs.jobs import run_jobs
from tutorstudent.study.runs.results import Failure, Run, pending, read_runs

JOBS = "jobs.json"


def claim_folder(jobs: Sequence[Job], folder: Path) -> None:
    """Write down what a folder is for, or make sure that it is for these jobs.

    Raises:
        PipelineError: The folder belongs to other jobs, or cannot be used.
    """
    text = json.dumps([job._asdict() for job in jobs], indent=1, default=str) + "\n"
    path = folder / JOBS
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if not path.exists():
            write_whole(path, text)
        other = path.read_text(encoding="utf-8") != text
    except OSError as error:
        raise PipelineError(f"{folder}: cannot be used: {error.strerror or error}. Give another --out.") from None
    if other:
        raise PipelineError(
            f"{folder}: holds a study with other pipelines, settings or numbers; go on with the same ones, or give "
            "another --out."
        )


def finish_jobs(jobs: Sequence[Job], folder: Path, workers: int, title: str) -> tuple[list[Run], list[Failure]]:
    """Run the jobs that have no results yet, with progress on standard error, and read all."""
    todo = pending(folder, jobs)
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True)) as progress:
        task = progress.add_task(title, total=len(jobs), completed=len(jobs) - len(todo))
        for finished in run_jobs(todo, folder, workers):
            progress.advance(task)
            if finished.problem:
                progress.console.print(f"failed: {finished.job.folder}: {finished.problem}", markup=False)
    return read_runs(folder, jobs)
