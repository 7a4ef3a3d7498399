"""Tables as Markdown, as HTML and for the terminal."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

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


def make_terminal_table(table: Table) -> RichTable:
    """Return a table for the terminal; controls are set in italics."""
    drawn = RichTable(
        title=table.title, title_justify="left", title_style="bold", box=None, pad_edge=False, padding=(0, 2, 0, 0)
    )
    drawn.add_column("", no_wrap=True)
    for title in table.header:
        drawn.add_column(title, justify="right", vertical="bottom")
    for row in table.rows:
        name = Text(row.name, style="italic" if row.control else "bold")
        drawn.add_row(name, *(Text(cell) for cell in row.cells))
    return drawn
