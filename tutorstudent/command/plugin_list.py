"""`tutorstudent plugins list`: what is installed, and what could not be loaded and why."""

from __future__ import annotations

import json
import math
import shutil
import sys
import textwrap
from collections.abc import Iterator, Sequence
from typing import Annotated, Any

import typer

from tutorstudent.command.common_options import is_verbose
from tutorstudent.core.files.registry import Registry

HEADER = ("role", "name", "plugin", "what it is")
INDENT = "  "
LEAST_ROOM = 40
"""Where a description has less room than this beside its name, it goes below."""


def plugins_list(
    as_json: Annotated[bool, typer.Option("--json", help="print JSON")] = False,
    strict: Annotated[bool, typer.Option("--strict", help="exit with 1 if any plugin could not be loaded")] = False,
) -> None:
    """List the installed parts, and the plugins that could not be loaded with reason and remedy."""
    registry = Registry.discover()
    if as_json:
        typer.echo(json.dumps(collect_values(registry), indent=2))
    else:
        # A line each where no person reads, so that grep finds a name with what it is.
        width = shutil.get_terminal_size().columns if sys.stdout.isatty() else math.inf
        typer.echo("\n".join(format_page(registry, width)))
        _print_broken(registry)
    if strict and registry.broken:
        raise typer.Exit(1)


def collect_values(registry: Registry) -> dict[str, Any]:
    """Return the list as plain values."""
    return {
        "parts": [
            {
                "role": cls.role,
                "name": cls.name,
                "plugin": entry_point,
                "distribution": distribution,
                "description": read_first_line(cls),
            }
            for cls, entry_point, distribution in registry
        ],
        "broken": [
            {
                "plugin": broken.entry_point,
                "distribution": broken.distribution,
                "reason": broken.reason,
                "remedy": broken.remedy,
            }
            for broken in registry.broken
        ],
    }


def read_first_line(cls: type[Any]) -> str:
    """Return the first line of a class's documentation."""
    return (cls.__doc__ or "").strip().split("\n")[0]


def format_page(registry: Registry, width: float) -> Iterator[str]:
    """Yield the lines of the list for people, a paragraph for each distribution. No name is ever cut.

    Args:
        registry: What is installed.
        width: Of the terminal, in letters; infinite for a line each.
    """
    found = list(registry)
    for distribution in dict.fromkeys(item.distribution for item in found):
        here = [item for item in found if item.distribution == distribution]
        names = _align([HEADER[:-1], *((cls.role, cls.name, plugin) for cls, plugin, _ in here)])
        texts = [HEADER[-1], *(read_first_line(cls) for cls, _, _ in here)]
        yield distribution
        for name, text in zip(names, texts, strict=True):
            yield from _describe(f"{INDENT}{name}{INDENT}", text, width)
        yield ""


def _align(rows: Sequence[Sequence[str]]) -> list[str]:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [INDENT.join(word.ljust(width) for word, width in zip(row, widths, strict=True)) for row in rows]


def _describe(name: str, text: str, width: float) -> list[str]:
    """Return the lines of a part: the description beside its name, or below it where there is little room."""
    if width == math.inf:
        return [f"{name}{text}".rstrip()]
    room = int(width) - len(name)
    if room >= LEAST_ROOM:
        first, *rest = textwrap.wrap(text, room) or [""]
        return [f"{name}{first}".rstrip(), *(" " * len(name) + line for line in rest)]
    below = textwrap.wrap(text, max(LEAST_ROOM, int(width)), initial_indent=3 * INDENT, subsequent_indent=3 * INDENT)
    return [name.rstrip(), *below]


def _print_broken(registry: Registry) -> None:
    for broken in registry.broken:
        typer.echo(f"not loaded: {broken.explain()}")
        if is_verbose():
            typer.echo(broken.trace)
