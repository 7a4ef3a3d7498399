"""The command line of this example: every study, resumable, with its tables on the terminal and as files."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, NoReturn

import typer
from rich.console import Console

import tutorstudent as ts
from tutorstudent_prototype2 import thesis
from tutorstudent_prototype2.calibration.command import app as calibration
from tutorstudent_prototype2.heldout import heldout
from tutorstudent_prototype2.intervals import intervals
from tutorstudent_prototype2.pipelines import ENVIRONMENTS
from tutorstudent_prototype2.reproduce import reproduce
from tutorstudent_prototype2.running import read_scenes
from tutorstudent_prototype2.sheets import Section, show
from tutorstudent_prototype2.transplant import transplant

app = typer.Typer(
    name="tutorstudent-prototype2",
    help="Chapter 4 of the thesis, and what its section 5.2 leaves open. A command that was stopped goes on where it "
    "stood when it is given again.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    add_completion=False,
)
app.add_typer(calibration, name="calibration")

INTERRUPTED = 130
"""Exit code of a program that was stopped by a signal."""
ALL = ",".join(ENVIRONMENTS)
Runs = Annotated[int, typer.Option(min=1, help="Runs of everything; run i has the seed i.")]
Decisions = Annotated[int, typer.Option(min=10, help="Decisions of a run.")]
Workers = Annotated[int, typer.Option(min=1, help="Processes; the results are the same for any number.")]
Out = Annotated[Path, typer.Option(help="Folder of the study; new, or with the same study.")]
Scenes = Annotated[str, typer.Option(help="Environments, with commas.")]


@app.command("reproduce")
def reproduce_command(
    runs: Runs = thesis.RUNS,
    decisions: Decisions = thesis.DECISIONS,
    workers: Workers = 1,
    scenes: Scenes = ALL,
    out: Out = Path("studies/reproduce"),
) -> None:
    """Tables 2 to 9 beside ours: prototype 2, 2A and controls in four environments."""
    with _resumable():
        study, sections = reproduce(read_scenes(scenes), runs, decisions, workers, out)
    _end(sections, len(study.failures), out)


@app.command("intervals")
def intervals_command(
    runs: Runs = thesis.RUNS,
    decisions: Decisions = thesis.DECISIONS,
    workers: Workers = 1,
    scenes: Scenes = "cave-box",
    out: Out = Path("studies/intervals"),
) -> None:
    """In which decisions learning takes place (5.2.5): prototype 2A, taught within one interval only."""
    with _resumable():
        study, sections = intervals(read_scenes(scenes), runs, decisions, workers, out)
    _end(sections, len(study.failures), out)


@app.command("transplant")
def transplant_command(
    runs: Runs = thesis.RUNS,
    decisions: Decisions = thesis.DECISIONS,
    workers: Workers = 1,
    out: Out = Path("studies/transplant"),
) -> None:
    """Students trained in Cave-Box, carried into Cave-Predator-Prey-Box (5.2.3)."""
    with _resumable():
        failures, sections = transplant(runs, decisions, workers, out)
    _end(sections, len(failures), out)


@app.command("heldout")
def heldout_command(
    runs: Runs = thesis.RUNS,
    decisions: Decisions = thesis.DECISIONS,
    workers: Workers = 1,
    out: Out = Path("studies/heldout"),
) -> None:
    """A scene that no calibration has seen: a smaller cave, as an occupancy map."""
    with _resumable():
        study, sections = heldout(runs, decisions, workers, out)
    _end(sections, len(study.failures), out)


@contextmanager
def _resumable() -> Iterator[None]:
    """Say how to go on where Ctrl-C was pressed."""
    try:
        yield
    except KeyboardInterrupt:
        typer.echo("interrupted; the same command goes on where it stood.", err=True)
        raise typer.Exit(INTERRUPTED) from None


def _end(sections: Sequence[Section], failed: int, out: Path) -> None:
    console = Console()
    show(sections, console)
    console.print(f"written to {out}", highlight=False, soft_wrap=True)
    if failed:
        console.print(f"{failed} runs failed; give the command again to run them again.", highlight=False)
        raise typer.Exit(1)


def main() -> NoReturn:
    """Run the command line; a mistake of the user's is a sentence and exit code 2."""
    try:
        app()
    except ts.TutorStudentError as error:
        typer.echo(f"tutorstudent-prototype2: {error}", err=True)
        sys.exit(2)
    sys.exit(0)
