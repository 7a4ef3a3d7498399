"""The options of `tutorstudent compare`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

Pipelines = Annotated[list[Path] | None, typer.Argument(help="Pipeline files to compare, YAML.", show_default=False)]
Runs = Annotated[int, typer.Option(min=1, help="Runs of each pipeline and control in each environment.")]
Decisions = Annotated[
    int | None, typer.Option(min=1, max=1_000_000_000, help="Decisions of a run; default: what the files say.")
]
Workers = Annotated[int, typer.Option(min=1, help="Processes; the results are the same for any number.")]
Out = Annotated[Path, typer.Option(help="Folder for all results; new or empty, unless --resume.")]
Resume = Annotated[
    bool,
    typer.Option("--resume", help="Go on with the study in --out: run what is not complete. Needs no pipelines."),
]
Vary = Annotated[str | None, typer.Option(help="One environment for each value: world.scene=chase-avoid,cave-box.")]
Settings = Annotated[list[str] | None, typer.Option("--set", help="Set key=value in every pipeline; may be repeated.")]
Controls = Annotated[bool, typer.Option("--controls/--no-controls", help="Run the controls beside them.")]
Goal = Annotated[str, typer.Option(help="What a run should maximise; default: what observers or the world count.")]
HarmBudget = Annotated[
    float,
    typer.Option(min=0, max=1, help="Share of decisions in which the best constant level may violate a condition."),
]
SearchRuns = Annotated[
    int, typer.Option(min=0, help="Runs of each level in the search for the best; 0: level 4, unsearched.")
]
Seed = Annotated[int, typer.Option(min=0, help="Seed of run 0; run i has this + i, whatever the files say.")]
BackendName = Annotated[str, typer.Option("--backend", help="Who runs the jobs: loky (this machine), dask or ray.")]
Address = Annotated[str, typer.Option(help="HOST:PORT of a dask or ray cluster; default: one on this machine.")]

PLANNED = ("runs", "decisions", "vary", "settings", "controls", "goal", "harm_budget", "search_runs", "seed")
"""Those that make a plan."""


def find_repeated(context: typer.Context) -> list[str]:
    """Return the options on the command line that a plan decides already."""
    found = [parameter for parameter in context.command.params if parameter.name in PLANNED]
    sources = [(parameter.opts[0], context.get_parameter_source(parameter.name or "")) for parameter in found]
    return [option for option, source in sources if source is not None and source.name == "COMMANDLINE"]
