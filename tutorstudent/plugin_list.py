"""`tutorstudent plugins list`: what is installed, and what could not be loaded and why."""

from __future__ import annotations

import json
from typing import Annotated, Any

import typer
from rich.console import Console
from rich.table import Table
from rich.text import Text

from tutorstudent.core.registry import Registry


def plugins_list(
    as_json: Annotated[bool, typer.Option("--json", help="print JSON")] = False,
    strict: Annotated[bool, typer.Option("--strict", help="exit with 1 if any plugin could not be loaded")] = False,
    verbose: Annotated[bool, typer.Option("--verbose", "-v", help="show the tracebacks of broken plugins")] = False,
) -> None:
    """List the installed components, and the plugins that could not be loaded with reason and remedy."""
    registry = Registry.discover()
    if as_json:
        typer.echo(json.dumps(as_values(registry), indent=2))
    else:
        _print(registry, verbose)
    if strict and registry.broken:
        raise typer.Exit(1)


def as_values(registry: Registry) -> dict[str, Any]:
    """Return the list as plain values."""
    return {
        "components": [
            {
                "role": cls.role,
                "name": cls.name,
                "plugin": entry_point,
                "distribution": distribution,
                "description": summary(cls),
            }
            for cls, entry_point, distribution in registry
        ],
        "broken": [
            {"plugin": plugin, "distribution": distribution, "reason": reason, "remedy": remedy}
            for plugin, distribution, reason, remedy, _ in registry.broken
        ],
    }


def summary(cls: type[Any]) -> str:
    """Return the first line of a class's documentation."""
    return (cls.__doc__ or "").strip().split("\n")[0]


def _print(registry: Registry, verbose: bool) -> None:
    table = Table("role", "name", "plugin", "distribution", "what it is")
    for cls, entry_point, distribution in registry:
        table.add_row(*map(Text, (cls.role, cls.name, entry_point, distribution, summary(cls))))
    Console().print(table)
    for broken in registry.broken:
        typer.echo(f"not loaded: '{broken.entry_point}' ({broken.distribution}): {broken.reason} {broken.remedy}")
        if verbose:
            typer.echo(broken.trace)
