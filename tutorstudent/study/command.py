"""`tutorstudent compare`: from pipeline files to a page of evidence."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from tutorstudent.core.registry import Registry
from tutorstudent.study.extras import check_extras
from tutorstudent.study.media import terminal
from tutorstudent.study.planning import Request, make_plan
from tutorstudent.study.requests import read_pipelines, read_setting, read_variation
from tutorstudent.study.results import Study
from tutorstudent.study.studies import check_folder, run_study
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
    study = run_study(plan, out, workers)
    show(study)
    if study.failures:
        raise typer.Exit(1)


def report(
    folder: Annotated[Path, typer.Argument(help="Folder of a comparison.", show_default=False)],
) -> None:
    """Make tables and page of a comparison again, from what is on disk; nothing is run."""
    check_extras()
    from tutorstudent.study.report import write_report  # matplotlib is an extra

    show(write_report(folder))


def show(study: Study) -> None:
    """Print a digest of a study's tables, and where the report is."""
    from tutorstudent.study.report import MARKDOWN, PAGE  # matplotlib is an extra

    console, out = Console(), study.folder
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
