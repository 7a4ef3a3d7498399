"""The thesis's numbers as data: tables 2, 4, 6 and 8, and the percentages of tables 3, 5, 7 and 9, as printed."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

DATA = Path(__file__).parent / "data"
RUNS = 10
"""Trial runs of each controller in each environment (4.2)."""
DECISIONS = 10_000
"""Decisions of each (4.2)."""
PIPELINES: Mapping[int | None, str] = {
    None: "prototype2",
    2500: "prototype2a",
    5000: "prototype2a-5000",
    7500: "prototype2a-7500",
}
"""Which of our pipelines a learning phase belongs to; prototype 2 has none."""


class Row(NamedTuple):
    """A row of table 2, 4, 6 or 8: means and standard deviations over the runs."""

    table: int
    environment: str
    learning_phase: int | None
    collisions: float
    collisions_sd: float
    attractors: float
    attractors_sd: float

    @property
    def pipeline(self) -> str:
        """Name of our pipeline."""
        return PIPELINES[self.learning_phase]


class Improvement(NamedTuple):
    """A row of table 3, 5, 7 or 9: prototype 2A against prototype 2, percent of prototype 2's mean."""

    table: int
    environment: str
    learning_phase: int
    collisions_percent: float | None
    """How many fewer; None where the thesis prints none."""
    attractors_percent: float
    """How many more."""


class Remark(NamedTuple):
    """What a sentence of the thesis says, and what its own tables say."""

    section: str
    says: str
    tables: str


@cache
def rows() -> tuple[Row, ...]:
    """Return tables 2, 4, 6 and 8."""
    return tuple(
        Row(
            int(line["table"]),
            line["environment"],
            int(line["learning_phase"]) if line["learning_phase"] else None,
            *(float(line[key]) for key in ("collisions", "collisions_sd", "attractors", "attractors_sd")),
        )
        for line in _lines("thesis.csv")
    )


@cache
def improvements() -> tuple[Improvement, ...]:
    """Return tables 3, 5, 7 and 9."""
    return tuple(
        Improvement(
            int(line["table"]),
            line["environment"],
            int(line["learning_phase"]),
            float(line["collisions_percent"]) if line["collisions_percent"] else None,
            float(line["attractors_percent"]),
        )
        for line in _lines("improvements.csv")
    )


def prototype2(environment: str) -> Row:
    """Return the row of the tutor alone."""
    return next(row for row in rows() if row.environment == environment and row.learning_phase is None)


def prototype2a() -> list[Row]:
    """Return the twelve rows of prototype 2A."""
    return [row for row in rows() if row.learning_phase is not None]


def cell(environment: str, pipeline: str) -> dict[str, float]:
    """Return the thesis's means of an environment and one of our pipelines, as ``attractors`` and ``collisions``."""
    row = next(row for row in rows() if (row.environment, row.pipeline) == (environment, pipeline))
    return {"attractors": row.attractors, "collisions": row.collisions}


def percent_more(before: float, after: float) -> float:
    """Return by how many percent of `before` something has grown; NaN where there was nothing.

    >>> percent_more(8.0, 10.0)
    25.0
    """
    return 100.0 * (after - before) / before if before else float("nan")


def _lines(name: str) -> list[dict[str, str]]:
    with (DATA / name).open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))
