"""The columns of the tables: one for each measure, in the table and the form that its declaration asks for."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from tutorstudent.core.words.measures import Measure
from tutorstudent.study.numbers.quantities import TIME, WAY, Quantity
from tutorstudent.study.tables.cells import Cell, about, achieved, heavy_tailed, highest, mean, typical

TITLES = {"more": "What was found", "less": "What it cost", None: "What the parts did"}
"""The table of a measure, by what is better."""
RATES = "By way and by time"


class Column(NamedTuple):
    """A column of a table: a number of every run, and how the runs of a row are shown."""

    quantity: Quantity
    cell: Cell

    @property
    def title(self) -> str:
        """The heading; says what is shown where it is not the spread over runs."""
        return self.quantity.title + (" (max)" if self.cell is highest else "")

    @property
    def is_compared(self) -> bool:
        """Whether the paired difference to the tutor alone stands beside it."""
        return self.quantity.better != 0 and self.quantity.over is None


def columns_by_table(measures: Sequence[Measure]) -> dict[str, list[Column]]:
    """Return the columns of each table by its title: the sums of runs, then what tells more from faster."""
    found = {title: [column(item) for item in measures if item.better == better] for better, title in TITLES.items()}
    return found | {RATES: list(rates(measures))}


def column(measure: Measure) -> Column:
    """Return the column of a measure: its spread over runs, with the worst run where that is what matters."""
    if measure.better == "more":
        return Column(Quantity(measure), achieved)
    if measure.summed == "max":
        return Column(Quantity(measure), highest)
    if measure.better == "less":
        return Column(Quantity(measure), heavy_tailed)
    return Column(Quantity(measure), typical)


def rates(measures: Iterable[Measure]) -> Iterable[Column]:
    """Yield the columns by way and by time of every sum of which more or less is better, but for details."""
    for measure in measures:
        if measure.better and measure.summed == "sum" and not measure.detail:
            yield from (Column(Quantity(measure, over), about) for over in (WAY, TIME) if over.key != measure.name)


def digest(measures: Iterable[Measure]) -> list[Column]:
    """Return the columns that a narrow terminal shows: what is no detail, in short cells."""
    shown = sorted((item for item in measures if not item.detail), key=lambda item: list(TITLES).index(item.better))
    short: dict[Cell, Cell] = {achieved: about, heavy_tailed: about, typical: mean, highest: highest}
    return [made._replace(cell=short[made.cell]) for made in map(column, shown)]


def explain(columns: Iterable[Column]) -> str:
    """Return what the columns count, those that say it, each measure once.

    >>> explain([Column(Quantity(Measure("falls", description="how often it fell")), about)])
    'falls: how often it fell.'
    """
    measures = dict.fromkeys(column.quantity.measure for column in columns)
    return " ".join(f"{item.title}: {item.description}." for item in measures if item.description)
