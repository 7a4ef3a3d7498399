"""The calibration as commands; each goes on where it was stopped."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from tutorstudent_prototype2.calibration.agreement import ENVIRONMENTS
from tutorstudent_prototype2.calibration.freezing import (
    AFTER_ROUNDS,
    freeze,
    most_promising,
    run_again,
    save_candidates,
)
from tutorstudent_prototype2.calibration.predictive import (
    keep_predictions,
    load_predictions,
    predict,
    save_predictions,
)
from tutorstudent_prototype2.calibration.summary import describe
from tutorstudent_prototype2.calibration.walks import keep_looks, load_looks, read_looks, save_looks, stays, walk_on

DATA = Path(__file__).parent / "data"
LOOKS, CANDIDATES, PREDICTIONS = DATA / "looks.jsonl", DATA / "candidates.jsonl", DATA / "predictions.jsonl"
SETTING = Path(__file__).parent.parent / "setting.yaml"

app = typer.Typer(
    help="Fit the free choices on prototype 2's rows alone, and predict prototype 2A.", no_args_is_help=True
)

Folder = Annotated[Path, typer.Option(help="Where finished runs are kept, so that an interrupted command goes on.")]
Workers = Annotated[int, typer.Option(min=1, help="Processes; the results are the same for any number.")]


@app.command()
def walk(
    walks: Annotated[int, typer.Option(min=1, help="Random walks.")] = 8,
    rounds: Annotated[int, typer.Option(min=1, help="Rounds of each walk.")] = 60,
    workers: Workers = 2,
    out: Folder = Path("studies/calibration/walks"),
    table: Annotated[Path, typer.Option(help="The result.")] = LOOKS,
) -> None:
    """Walk among the settings under which prototype 2 agrees with the thesis, on from what the table holds; long."""
    if table.exists():
        keep_looks(out, load_looks(table))
    with _progress() as progress:
        task = progress.add_task("rounds", total=rounds)
        for _ in walk_on(out, walks, rounds, workers):
            progress.advance(task)
    looks = read_looks(out)
    save_looks(table, looks)
    typer.echo(f"{len(looks)} settings looked at, {len(stays(looks))} agree: {table}")


@app.command(name="freeze")
def freeze_command(
    workers: Workers = 2,
    table: Annotated[Path, typer.Option(help="The candidates with their runs.")] = CANDIDATES,
    setting: Annotated[Path, typer.Option(help="The frozen setting.")] = SETTING,
) -> None:
    """Run the most promising settings again and freeze the one that fits prototype 2 best."""
    looks = load_looks(LOOKS)
    candidates = run_again(most_promising(looks), workers)
    save_candidates(table, candidates)
    freeze(candidates[0], setting, sum(look.round <= AFTER_ROUNDS for look in looks))
    for candidate in candidates:
        typer.echo(f"walk {candidate.look.walk}, round {candidate.look.round}: misfit {candidate.misfit:.2f}")
    typer.echo(f"written to {setting}")


@app.command(name="predict")
def predict_command(
    workers: Workers = 2,
    out: Folder = Path("studies/calibration/predictions"),
    table: Annotated[Path, typer.Option(help="The result.")] = PREDICTIONS,
) -> None:
    """Run prototype 2A under every setting that agrees, but for what the table holds already; long."""
    if table.exists():
        keep_predictions(out, load_predictions(table))
    looks = [look for look, _ in stays(load_looks(LOOKS))]
    with _progress() as progress:
        task = progress.add_task("runs", total=len(looks) * len(ENVIRONMENTS))
        predictions = []
        for prediction in predict(out, looks, workers):
            predictions.append(prediction)
            progress.advance(task)
    save_predictions(table, predictions)
    typer.echo(f"{len(predictions)} predictions: {table}")


@app.command()
def show() -> None:
    """Print what the calibration found, from the stored results; nothing is run."""
    for line in describe(LOOKS, CANDIDATES, PREDICTIONS):
        typer.echo(line)


def _progress() -> Progress:
    return Progress(TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
