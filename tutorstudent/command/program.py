"""The command line. A user's mistake ends in one sentence on standard error and exit code 2."""

from __future__ import annotations

import json
import math
import sys
import traceback
from contextlib import suppress
from importlib import metadata
from pathlib import Path
from typing import Annotated, Any, NoReturn

import typer
from rich.console import Console
from rich.table import Table
from rich.text import Text

from tutorstudent.command.check import check
from tutorstudent.command.common_options import Trace, Verbose, add_common_options, heed, is_verbose
from tutorstudent.command.compare import compare, report
from tutorstudent.command.new import new
from tutorstudent.command.outcome_lines import describe_amplification
from tutorstudent.command.plugin_info import info
from tutorstudent.command.plugin_list import plugins_list
from tutorstudent.command.progress_bar import ProgressBar
from tutorstudent.command.supervising import end, watch_over
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.files.finished import Failure, Finished
from tutorstudent.core.files.keeping import Kept, claim, keep_run, say_kept
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.rundir import explain_write_errors
from tutorstudent.core.files.schema import make_schema
from tutorstudent.core.files.settings import read_settings
from tutorstudent.core.running.whereabouts import HERE
from tutorstudent.core.words.errors import TutorStudentError

app = typer.Typer(
    name="tutorstudent",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    add_completion=False,
)
plugins = typer.Typer(help="What is installed.", no_args_is_help=True)
app.add_typer(plugins, name="plugins")
app.command()(add_common_options(compare))
app.command()(add_common_options(report))
plugins.command("list")(add_common_options(plugins_list))
plugins.command("info")(add_common_options(info))
plugins.command("check")(add_common_options(check))
plugins.command("new")(add_common_options(new))

PipelineFile = Annotated[Path, typer.Argument(help="a pipeline in YAML")]
Setting = Annotated[
    list[str] | None, typer.Option("--set", metavar="KEY=VALUE", help="another value for a dotted key; repeatable")
]


def _print_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"tutorstudent {metadata.version('tutorstudent')}")
        raise typer.Exit


Version = Annotated[
    bool, typer.Option("--version", is_eager=True, callback=_print_version, help="print the version and exit")
]


@app.callback()
def program(verbose: Verbose = False, trace: Trace = False, _version: Version = False) -> None:
    """Wrap a controller that already works with a learner, so that it improves while it stays in command."""
    heed(verbose, trace)


@app.command()
@add_common_options
def run(
    pipeline: PipelineFile,
    decisions: Annotated[int | None, typer.Option(min=1, help="how many decisions, instead of the file's")] = None,
    seed: Annotated[int | None, typer.Option(min=0, help="the seed, instead of the file's")] = None,
    out: Annotated[Path | None, typer.Option(help="directory of the run; default runs/NAME-SEED")] = None,
    strict: Annotated[bool, typer.Option("--strict", help="exit with 1 if any part broke its contract")] = False,
    settings: Setting = None,
) -> None:
    """Run a pipeline in its world and write a directory that can be read later."""
    changes = read_settings("--set", settings or [])
    changes |= {key: value for key, value in (("decisions", decisions), ("seed", seed)) if value is not None}
    directory = None if out is None else out.absolute()
    chosen = Pipeline.read(pipeline).replaced(changes)
    directory = directory or (Path("runs") / f"{pipeline.stem}-{chosen.header.seed}").absolute()
    kept = _keep_with_progress(chosen, f"{pipeline.stem}, seed {chosen.header.seed}", directory)
    for note in kept.notes:
        typer.echo(f"tutorstudent: {note}", err=True)
    with suppress(BrokenPipeError, SystemExit):  # rich's word for it: nobody reads it any more; the run is written
        _print_finished(kept.finished)
        _say(f"written to {directory}")
    if strict and kept.finished.engine.incident_counts:
        raise typer.Exit(1)


@app.command()
@add_common_options
def schema(
    out: Annotated[Path | None, typer.Option(help="write it to this file, and say how a pipeline names it")] = None,
) -> None:
    """Print a JSON Schema of pipelines, composed from the installed plugins."""
    text = json.dumps(make_schema(Registry.discover()), indent=2)
    if out is None:
        _say(text)
        return
    with explain_write_errors(out):
        out.write_text(f"{text}\n", encoding="utf-8")
    _say(f"written to {out}; to use it in an editor, begin a pipeline with the line")
    _say(f"# yaml-language-server: $schema={out.name}")


def _keep_with_progress(pipeline: Pipeline, title: str, directory: Path) -> Kept:
    try:
        with claim(directory.resolve()) as partial, ProgressBar(title) as bar:
            kept = keep_run(pipeline, directory.resolve(), partial, HERE, [bar])
    except KeyboardInterrupt:
        typer.echo("interrupted before the first decision; nothing was written.", err=True)
        raise typer.Exit(130) from None
    failure = kept.finished.failure
    if failure is None:
        return kept
    raise RunEnded(failure, kept.folder) from failure.error


class RunEnded(Exception):
    """A run ended before its last decision; what was decided is kept."""

    def __init__(self, failure: Failure, folder: Path) -> None:
        super().__init__(f"{failure.problem.rstrip('.')}. {say_kept(folder)}")
        self.code = _find_code(failure)


def _find_code(failure: Failure) -> int:
    if isinstance(failure.error, KeyboardInterrupt):
        return 130
    if failure.is_owners and isinstance(failure.error, SystemExit) and isinstance(failure.error.code, int):
        return failure.error.code or 1
    return 2 if isinstance(failure.error, TutorStudentError) else 1


def _print_finished(finished: Finished) -> None:
    _print_summary(finished.summary)
    for line in describe_amplification(finished.decisions):
        _say(line)
    _print_incidents(finished.engine)
    for notice in finished.notices:
        _say(f"notice: {notice.says}")


def _print_summary(summary: dict[str, float]) -> None:
    table = Table("what", "value")
    for key, value in summary.items():
        whole = math.isfinite(value) and value == int(value)
        table.add_row(Text(key), f"{int(value):,}" if whole else f"{value:,.4g}")
    Console().print(table)


def _print_incidents(engine: Engine[Any, Any, Any]) -> None:
    newest = {(incident.part, incident.kind): incident.message for incident in engine.incidents}
    for key, count in sorted(engine.incident_counts.items()):
        message = f"; the newest: {newest[key]}" if key in newest else ""
        _say(f"incidents: {key[0]}: {key[1]}: {count}{message}")


def _say(text: str) -> None:
    typer.echo(text)


def main() -> NoReturn:
    """Run the command line; a `TutorStudentError` is a sentence and exit code 2."""
    code = watch_over(sys.argv[1:])
    end(_run_app() if code is None else code)


def _run_app() -> int:
    try:
        app()
    except (TutorStudentError, RunEnded) as error:
        if is_verbose():
            traceback.print_exc()
        typer.echo(f"tutorstudent: {error}", err=True)
        return error.code if isinstance(error, RunEnded) else 2
    except SystemExit as ended:
        return ended.code if isinstance(ended.code, int) else int(ended.code is not None)
    return 0
