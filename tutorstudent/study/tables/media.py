"""Tables as Markdown, as HTML and for the terminal."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping
from html import escape

from rich.console import Group
from rich.table import Table as RichTable
from rich.text import Text

from tutorstudent.study.tables.table import Table


def make_markdown(table: Table) -> str:
    """Return a table as GitHub's Markdown."""
    header = ["", *table.header]
    lines = [header, ["---", *("---:" for _ in table.header)]]
    lines += [[f"*{row.name}*" if row.control else f"**{row.name}**", *row.cells] for row in table.rows]
    body = "\n".join("| " + " | ".join(cell.replace("|", r"\|") for cell in line) + " |" for line in lines)
    note = f"\n{table.note}\n" if table.note else ""
    return f"**{table.title}**\n\n{body}\n{note}"


def make_html(table: Table, colours: Mapping[str, str]) -> str:
    """Return a table with its note as HTML; `colours` has a CSS colour for each variant."""
    head = "".join(f'<th scope="col">{escape(title)}</th>' for title in table.header)
    rows = []
    for row in table.rows:
        swatch = f'<i class="swatch" style="background:{colours[row.name]}"></i>'
        cells = "".join(f"<td>{escape(cell)}</td>" for cell in row.cells)
        kind = ' class="control"' if row.control else ""
        rows.append(f'<tr{kind}><th scope="row">{swatch}{escape(row.name)}</th>{cells}</tr>')
    note = f'\n<p class="note">{escape(table.note)}</p>' if table.note else ""
    return (
        f'<div class="scroll" tabindex="0" role="region" aria-label="{escape(table.title)}"><table>'
        f"<thead><tr><td></td>{head}</tr></thead><tbody>{''.join(rows)}</tbody></table></div>{note}"
    )


GAP = 2
"""Between columns of the terminal's tables, letters."""


def make_terminal_table(table: Table, width: int = 80) -> Group:
    """Return a table for a terminal so many letters wide; controls are set in italics.

    A table that is too wide becomes several, one below the other, each with the names of its rows.
    """
    titles = [
        textwrap.fill(title, _find_width(table, i), break_long_words=False, break_on_hyphens=False)
        for i, title in enumerate(table.header)
    ]
    widths = [max(_find_width(table, i), *map(len, title.split("\n"))) + GAP for i, title in enumerate(titles)]
    room = width - GAP - max((len(row.name) for row in table.rows), default=0)
    return Group(*(_make_part(table, titles, part) for part in _split_columns(widths, room)))


def _find_width(table: Table, column: int) -> int:
    return max((len(row.cells[column]) for row in table.rows), default=1)


def _split_columns(widths: list[int], room: int) -> Iterator[list[int]]:
    """Yield the columns that stand beside each other, as many as there is room for."""
    part: list[int] = []
    for column, width in enumerate(widths):
        if part and sum(widths[i] for i in part) + width > room:
            yield part
            part = []
        part.append(column)
    yield part


def _make_part(table: Table, titles: list[str], columns: list[int]) -> RichTable:
    title = table.title if 0 in columns or not columns else None
    drawn = RichTable(
        title=title, title_justify="left", title_style="bold", box=None, pad_edge=False, padding=(0, GAP, 0, 0)
    )
    drawn.add_column("", no_wrap=True)
    for column in columns:
        drawn.add_column(Text(titles[column]), justify="right", vertical="bottom")
    for row in table.rows:
        name = Text(row.name, style="italic" if row.control else "bold")
        drawn.add_row(name, *(Text(row.cells[column]) for column in columns))
    return drawn
