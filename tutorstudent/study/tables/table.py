"""What a table is, before anybody draws it."""

from __future__ import annotations

from typing import NamedTuple


class Row(NamedTuple):
    """A variant with its cells."""

    name: str
    control: bool
    cells: tuple[str, ...]


class Table(NamedTuple):
    """A table as text; how it is drawn is the medium's affair."""

    title: str
    header: tuple[str, ...]
    rows: tuple[Row, ...]
    note: str = ""
    """How to read it; stands below."""
