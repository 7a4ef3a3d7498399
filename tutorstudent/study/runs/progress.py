"""Shows the progress of a study: how many jobs have ended or failed, and how long the rest will take."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from tutorstudent.study.runs.jobs import Finished


def show_progress(results: Iterable[Finished], title: str, total: int, done: int = 0) -> Iterator[Finished]:
    """Yield the results, and show them on standard error: a bar, and a line for each that failed or has a note.

    Args:
        results: The jobs, each as it ends.
        title: What stands before the bar.
        total: Number of jobs, with those of earlier sittings.
        done: Number of those.
    """
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[failed]} failed, time left:"),
        TimeRemainingColumn(),
    )
    failed = 0
    with Progress(*columns, console=Console(stderr=True)) as progress:
        task = progress.add_task(title, total=total, completed=done, failed=failed)
        for finished in results:
            failed += bool(finished.problem)
            progress.update(task, advance=1, failed=failed)
            if text := _write_line(finished):
                progress.console.print(text, markup=False, highlight=False)
            yield finished


def _write_line(finished: Finished) -> str:
    job, said = finished.job, finished.problem or finished.note
    word = "failed" if finished.problem else "note"
    return f"{word}: {job.environment}, {job.variant}, seed {job.seed}: {said}" if said else ""
