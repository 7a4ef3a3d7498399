"""`tutorstudent compare`: from pipeline files to a page of evidence."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import Annotated, NamedTuple

import typer
from rich.console import Console

from tutorstudent.command import compare_options as options
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.study.page.remarks import describe_goal, make_remarks, make_resume_command
from tutorstudent.study.plans.plan import Plan
from tutorstudent.study.plans.planfile import load_plan
from tutorstudent.study.plans.planning import make_plan
from tutorstudent.study.plans.requests import Request, read_pipelines, read_setting, read_variation
from tutorstudent.study.runs.backends import Backend, check_backend, check_extras, end_workers
from tutorstudent.study.runs.results import Study
from tutorstudent.study.studies import check_folder, run_study
from tutorstudent.study.tables.media import make_terminal_table
from tutorstudent.study.tables.tables import make_digest_table

INTERRUPTED = 130
"""Exit code after Ctrl-C, as shells have it."""


def compare(
    context: typer.Context,
    pipelines: options.Pipelines = None,
    runs: options.Runs = 10,
    decisions: options.Decisions = None,
    workers: options.Workers = 1,
    out: options.Out = Path("studies/new"),
    resume: options.Resume = False,
    vary: options.Vary = None,
    settings: options.Settings = None,
    controls: options.Controls = True,
    goal: options.Goal = "",
    harm_budget: options.HarmBudget = 0.001,
    search_runs: options.SearchRuns = 2,
    seed: options.Seed = 0,
    backend: options.BackendName = "loky",
    address: options.Address = "",
) -> None:
    """Compare pipelines on paired seeds, with their controls, and write a page with every run."""
    check_extras()
    workforce = Backend(backend, address)
    check_backend(workforce)
    if resume and not pipelines:
        plan = _load_plan(out, context)
    else:
        if not resume:
            check_folder(out)
        asked = Wish(pipelines or [], settings or [], vary)
        plan = _make_plan(asked, Request({}, runs, seed, decisions, (), controls, goal, harm_budget, search_runs))
    try:
        study = run_study(plan, out, workers, workforce)
    except KeyboardInterrupt:
        typer.echo(f"interrupted; go on with: {make_resume_command(out)}", err=True)
        raise typer.Exit(INTERRUPTED) from None
    except SystemExit:
        typer.echo(f"ended from outside; go on with: {make_resume_command(out)}", err=True)
        raise
    finally:
        end_workers()
    with suppress(BrokenPipeError, SystemExit):  # rich's word for it: nobody reads it; the page is written
        show(study)
    if study.failures:
        typer.echo(f"What failed is run again by: {make_resume_command(out)}", err=True)
        raise typer.Exit(1)


class Wish(NamedTuple):
    """What is to be compared, as it was written."""

    pipelines: list[Path]
    settings: list[str]
    vary: str | None


def _make_plan(wish: Wish, request: Request) -> Plan:
    registry = Registry.discover()
    given = read_pipelines(wish.pipelines, registry)
    for text in wish.settings:
        given = {name: read_setting("--set", text).apply(pipeline) for name, pipeline in given.items()}
    variations = read_variation("--vary", wish.vary) if wish.vary is not None else []
    return make_plan(request._replace(pipelines=given, variations=variations), registry)


def _load_plan(out: Path, context: typer.Context) -> Plan:
    """Return the plan of a study to resume; refuse options that would contradict it."""
    if said := options.find_repeated(context):
        raise PipelineError(
            f"--resume with {', '.join(said)}: the plan in {out} already decides that; leave "
            f"{'it' if len(said) == 1 else 'them'} out, or name the pipelines too; then both plans are compared."
        )
    return load_plan(out)


def report(
    folder: Annotated[Path, typer.Argument(help="Folder of a comparison.", show_default=False)],
) -> None:
    """Make tables and page of a comparison again, from what is on disk; nothing is run."""
    check_extras()
    from tutorstudent.study.page.report import write_report  # matplotlib is an extra

    show(write_report(folder))


def show(study: Study) -> None:
    """Print a digest of a study's tables, and where the report is."""
    from tutorstudent.study.page.report import MARKDOWN, PAGE  # matplotlib is an extra

    console, out = Console(), study.folder
    digests = {environment.name: make_digest_table(study, environment) for environment in study.plan.environments}
    for name, table in digests.items():
        console.rule(name, align="left")
        console.print(make_terminal_table(table, console.width), "\n")
    for text in filter(None, [describe_goal(study), *make_remarks(study)]):
        console.print(text, markup=False, highlight=False, soft_wrap=True)
    for legend in dict.fromkeys(table.note for table in digests.values()):
        console.print(legend, markup=False, highlight=False)
    console.print(f"{len(study.runs)} runs, {len(study.failures)} failed. Controls are in italics.", highlight=False)
    console.print(
        f"All tables, with paired differences and intervals: {out / MARKDOWN}", highlight=False, soft_wrap=True
    )
    console.print(f"The page: {out / PAGE}", highlight=False, soft_wrap=True)
