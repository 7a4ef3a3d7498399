"""`tutorstudent compare`: from pipeline files to a page of evidence."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from tutorstudent.core.errors import PipelineError
from tutorstudent.core.registry import Registry
from tutorstudent.core.rundir import writing
from tutorstudent.study.extras import check_extras
from tutorstudent.study.jobs import Finished, run_jobs
from tutorstudent.study.media import terminal
from tutorstudent.study.plan import Plan, save_plan
from tutorstudent.study.planning import Request, make_plan
from tutorstudent.study.requests import read_pipelines, read_setting, read_variation
from tutorstudent.study.resolving import reread, sketch_of
from tutorstudent.study.sketches import save_sketch
from tutorstudent.study.tables import digest_table

LEGEND = (
    "collided: decisions in which the robot's own motion was refused. contacts: how often that began. way: distance "
    "travelled. stall: longest run of collided decisions. level: mean amplification level."
)


def compare(
    pipelines: Annotated[list[Path], typer.Argument(help="Pipeline files to compare, YAML.", show_default=False)],
    runs: Annotated[int, typer.Option(min=1, help="Runs of each pipeline and control in each environment.")] = 10,
    decisions: Annotated[
        int | None, typer.Option(min=1, max=1_000_000_000, help="Decisions of a run; else what the files say.")
    ] = None,
    workers: Annotated[int, typer.Option(min=1, help="Processes; the results are the same for any number.")] = 1,
    out: Annotated[Path, typer.Option(help="Folder for all results; it must be new or empty.")] = Path("studies/new"),
    vary: Annotated[
        str | None, typer.Option(help="One environment for each value: world.scene=chase-avoid,cave-box.")
    ] = None,
    settings: Annotated[
        list[str] | None, typer.Option("--set", help="Set key=value in every pipeline; may be repeated.")
    ] = None,
    controls: Annotated[bool, typer.Option("--controls/--no-controls", help="Run the controls beside them.")] = True,
    seed: Annotated[
        int, typer.Option(min=0, help="Seed of run 0; run i has this + i, for all alike, whatever the files say.")
    ] = 0,
) -> None:
    """Compare pipelines on paired seeds, with their controls, and write a page with every run."""
    check_extras()
    check_folder(out)
    registry = Registry.discover()
    given = read_pipelines(pipelines, registry)
    for text in settings or []:
        given = {name: read_setting("--set", text).apply(pipeline) for name, pipeline in given.items()}
    variations = read_variation("--vary", vary) if vary is not None else []
    plan = make_plan(Request(given, runs, seed, decisions, variations, controls), registry)
    write_plan(plan, out, registry)
    problems = execute(plan, out, workers)
    show(out)
    if problems:
        raise typer.Exit(1)


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


def execute(plan: Plan, out: Path, workers: int) -> list[Finished]:
    """Run all jobs with a progress bar and return those that failed."""
    jobs = plan.jobs()
    console = Console(stderr=True)
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console) as progress:
        task = progress.add_task(f"runs of {plan.decisions} decisions", total=len(jobs))
        return list(_problems(run_jobs(jobs, out, workers), progress, task))


def _problems(results: Iterable[Finished], progress: Progress, task: int) -> Iterable[Finished]:
    for finished in results:
        progress.advance(task)  # type: ignore[arg-type]
        job, said = finished.job, finished.problem or finished.note
        if said:
            word = "failed" if finished.problem else "note"
            text = f"{word}: {job.environment}, {job.variant}, seed {job.seed}: {said}"
            progress.console.print(text, markup=False, highlight=False)
        if finished.problem:
            yield finished


def report(
    folder: Annotated[Path, typer.Argument(help="Folder of a comparison.", show_default=False)],
) -> None:
    """Make tables and page of a comparison again, from what is on disk; nothing is run."""
    check_extras()
    show(folder)


def show(out: Path) -> None:
    """Write the report and print a digest of its tables."""
    from tutorstudent.study.report import MARKDOWN, PAGE, write_report  # matplotlib is an extra

    console = Console()
    study = write_report(out)
    for environment in study.plan.environments:
        console.rule(environment.name, align="left")
        console.print(terminal(digest_table(study, environment)), "\n")
    if not any(environment.counters() for environment in study.plan.environments):
        console.print("Nothing counts what the tutors achieve; name an observer, as in --set 'observers=[attractors]'.")
    console.print(LEGEND, highlight=False)
    console.print(f"{len(study.runs)} runs, {len(study.failures)} failed. Controls are in italics.", highlight=False)
    console.print(
        f"All tables, with paired differences and intervals: {out / MARKDOWN}", highlight=False, soft_wrap=True
    )
    console.print(f"The page: {out / PAGE}", highlight=False, soft_wrap=True)
