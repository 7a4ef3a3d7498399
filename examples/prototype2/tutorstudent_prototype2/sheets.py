"""Tables of text, as Markdown, as CSV and for the terminal."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from rich.console import Console
from rich.table import Table
from rich.text import Text

from tutorstudent_prototype2.summaries import Summary

NOTHING = "-"


class Sheet(NamedTuple):
    """A table with its title; the first column names the rows."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


class Section(NamedTuple):
    """A sheet, and what can be said about it."""

    sheet: Sheet
    reading: tuple[str, ...] = ()


def number(value: float) -> str:
    """Return a number as tables show it; a dash where there is none.

    >>> [number(value) for value in (0.0, 3.25, 84.6, 385.7, float("nan"))]
    ['0.0', '3.2', '84.6', '386', '-']
    """
    if not math.isfinite(value):
        return NOTHING
    return f"{value:.0f}" if abs(value) >= 100 else f"{round(value, 1) + 0.0:.1f}"  # no minus before a zero


def add_sign(value: float) -> str:
    """Return a difference.

    >>> [add_sign(value) for value in (2.04, -3.0, -0.04, float("nan"))]
    ['+2.0', '-3.0', '0.0', '-']
    """
    return f"+{number(value)}" if round(value, 1) > 0 else number(value)


def spread(mean: float, sd: float) -> str:
    """Return a mean with its standard deviation.

    >>> spread(84.6, 18.11)
    '84.6 ± 18.1'
    """
    return f"{number(mean)} ± {number(sd)}"


def interval(low: float, high: float, text: Any = number) -> str:
    """Return an interval; a dash where there is none.

    >>> interval(1.0, 3.5), interval(-1.0, 3.5, add_sign), interval(float("nan"), float("nan"))
    ('[1.0, 3.5]', '[-1.0, +3.5]', '-')
    """
    return f"[{text(low)}, {text(high)}]" if math.isfinite(low) and math.isfinite(high) else NOTHING


def difference(found: Summary | None) -> str:
    """Return a mean of differences with its interval; a dash where nothing was compared."""
    if found is None:
        return NOTHING
    return f"{add_sign(found.mean)} {interval(found.low, found.high, add_sign)}"


def yes(value: bool) -> str:
    """Return a verdict in a word."""
    return "yes" if value else "no"


def markdown(sections: Iterable[Section], heading: str) -> str:
    """Return a page of GitHub's Markdown."""
    parts = [f"# {heading}"]
    for sheet, reading in sections:
        lines = [sheet.header, ("---", *("---:" for _ in sheet.header[1:])), *sheet.rows]
        table = "\n".join("| " + " | ".join(cell.replace("|", r"\|") for cell in line) + " |" for line in lines)
        parts += [f"## {sheet.title}", table, *reading]
    return "\n\n".join(parts) + "\n"


def show(sections: Iterable[Section], console: Console) -> None:
    """Print the sheets and what can be said about them."""
    for sheet, reading in sections:
        table = Table(title=Text(sheet.title), title_justify="left", box=None, pad_edge=False, padding=(0, 2, 0, 0))
        for i, title in enumerate(sheet.header):
            table.add_column(Text(title), justify="right" if i else "left", no_wrap=not i)
        for row in sheet.rows:
            table.add_row(*map(Text, row))
        console.print(table)
        for line in reading:
            console.print(Text(line))
        console.print()


def write_csv(path: Path, lines: Sequence[Mapping[str, Any]]) -> None:
    """Write a row for each mapping; all have the same keys."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(lines[0]) if lines else [], lineterminator="\n")
        writer.writeheader()
        writer.writerows(lines)
