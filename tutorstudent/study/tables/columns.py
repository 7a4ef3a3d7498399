"""The columns of the tables."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from tutorstudent.study.numbers.measures import Measure, per_time, per_way
from tutorstudent.study.tables.cells import Cell, about, achieved, heavy_tailed, highest, mean, percent, total, typical


class Column(NamedTuple):
    """A column of a table: a number of every run, and how the runs of a row are shown."""

    measure: Measure
    cell: Cell
    compared: bool = False
    """Beside it stands the paired difference to the tutor alone."""


def found(counters: Iterable[str]) -> list[Column]:
    """Return the columns about what was found: what the tutor counts, and what the world does."""
    counted = [Column(Measure(name, name), achieved, compared=True) for name in counters]
    others = [_column("encounters", "encounters", typical), _column("distance, m", "distance_m", typical)]
    return [*counted, *_without(counted, others)]


def cost() -> list[Column]:
    """Return the columns about harm."""
    return [
        Column(Measure("collided decisions", "collided"), heavy_tailed, compared=True),
        _column("contacts", "contacts", heavy_tailed),
        _column("violated, as the learner saw it", "violated", heavy_tailed),
        _column("hardest contact, m/s (max)", "contact_speed_mps", highest),
        _column("longest stall, decisions (max)", "longest_stall", highest),
    ]


def rates(counters: Iterable[str]) -> list[Column]:
    """Return the columns that tell more of everything from doing something better: by way and by time."""
    counted = [*((name, name) for name in counters), *HARMS]
    made = [per(title, key) for title, key in dict(counted).items() for per in (per_way, per_time)]
    return [Column(measure, about) for measure in made if measure.key != measure.over]


HARMS = (("collided decisions", "collided"), ("contacts", "contacts"), ("violated", "violated"))


def conduct() -> list[Column]:
    """Return the columns about what the parts did."""
    return [
        _column("simulated time, s (mean)", "time_s", mean),
        _column("named the tutor's kind (mean)", "match_rate", percent),
        _column("raised by the amplifier (mean)", "amplified_share", percent),
        _column("mean level", "mean_level", mean),
        _column("incidents (sum)", "incidents", total),
    ]


def digest(counters: Iterable[str]) -> list[Column]:
    """Return the few columns that fit a narrow terminal."""
    counted = [_column(name, name, about) for name in counters]
    others = [
        _column("collided", "collided", about),
        _column("contacts", "contacts", about),
        _column("way, m", "distance_m", mean),
        _column("stall", "longest_stall", highest),
        _column("level", "mean_level", mean),
    ]
    return [*counted, *_without(counted, others)]


def _without(there: Iterable[Column], others: Iterable[Column]) -> list[Column]:
    """Return the other columns but for those whose number stands there already."""
    keys = [column.measure.key for column in there]
    return [column for column in others if column.measure.key not in keys]


def _column(title: str, key: str, cell: Cell) -> Column:
    return Column(Measure(title, key), cell)
