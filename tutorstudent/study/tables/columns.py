"""The columns of the tables: one for each measure, in the table and the form that its declaration asks for."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from tutorstudent.core.words.measures import Measure
from tutorstudent.study.numbers.quantities import TIME, WAY, Quantity
from tutorstudent.study.tables.cells import (
    Cell,
    highest,
    mean,
    mean_sd,
    mean_sd_median,
    mean_sd_median_iqm,
    mean_sd_median_worst,
)

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


def make_columns(measures: Sequence[Measure]) -> dict[str, list[Column]]:
    """Return the columns of each table by its title: the sums of runs, then what tells more from faster."""
    found = {
        title: [make_column(item) for item in measures if item.better == better] for better, title in TITLES.items()
    }
    return found | {RATES: list(make_rate_columns(measures))}


def make_column(measure: Measure) -> Column:
    """Return the column of a measure: its spread over runs, with the worst run where that is what matters."""
    if measure.better == "more":
        return Column(Quantity(measure), mean_sd_median_iqm)
    if measure.summed == "max":
        return Column(Quantity(measure), highest)
    if measure.better == "less":
        return Column(Quantity(measure), mean_sd_median_worst)
    return Column(Quantity(measure), mean_sd_median)


def make_rate_columns(measures: Iterable[Measure]) -> Iterable[Column]:
    """Yield the columns by way and by time of every sum of which more or less is better, but for details."""
    for measure in measures:
        if measure.better and measure.summed == "sum" and not measure.detail:
            yield from (Column(Quantity(measure, over), mean_sd) for over in (WAY, TIME) if over.key != measure.name)


def make_digest_columns(measures: Iterable[Measure]) -> list[Column]:
    """Return the columns that a narrow terminal shows: what is no detail, in short cells."""
    brief = sorted((item for item in measures if not item.detail), key=lambda item: list(TITLES).index(item.better))
    short: dict[Cell, Cell] = {
        mean_sd_median_iqm: mean_sd,
        mean_sd_median_worst: mean_sd,
        mean_sd_median: mean,
        highest: highest,
    }
    return [made._replace(cell=short[made.cell]) for made in map(make_column, brief)]


def explain(columns: Iterable[Column]) -> str:
    """Return what the columns count, those that say it, each measure once.

    >>> explain([Column(Quantity(Measure("falls", description="how often it fell")), mean_sd)])
    'falls: how often it fell.'
    """
    measures = dict.fromkeys(column.quantity.measure for column in columns)
    return " ".join(f"{item.title}: {item.description}." for item in measures if item.description)
