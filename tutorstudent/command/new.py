"""`tutorstudent plugins new`: a working plugin to start from."""

from __future__ import annotations

import json
import shlex
from pathlib import Path
from typing import Annotated

import typer

from tutorstudent.core.files.registry import ROLES, Registry
from tutorstudent.templates.naming import make_names
from tutorstudent.templates.writing import write_plugin


def new(
    role: Annotated[str, typer.Argument(help=f"what it is: {', '.join(ROLES)}")],
    name: Annotated[str, typer.Argument(help="what pipelines call it, such as wall-follower")],
    out: Annotated[
        Path | None, typer.Option(help="folder of the new package; default: its name", show_default=False)
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="print JSON")] = False,
) -> None:
    """Write a package with a small working part, its tests and a pipeline, ready to be installed."""
    names = make_names(role, name, Registry.discover())
    folder = out or Path(names.name)
    written = [str(path) for path in write_plugin(names, folder)]
    if as_json:
        typer.echo(json.dumps({**names._asdict(), "folder": str(folder), "written": written}, indent=2))
        return
    for path in written:
        typer.echo(f"wrote {path}")
    typer.echo(
        "next:\n"
        f"  cd {shlex.quote(str(folder))}\n"
        "  pip install --no-build-isolation --no-deps -e .      (needs hatchling; with a network: pip install -e .)\n"
        "  python -m pytest\n"
        f"  tutorstudent plugins check {names.name}\n"
        "  tutorstudent compare pipeline.yaml --runs 2 --decisions 1000 --out studies/first"
    )
