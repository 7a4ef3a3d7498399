"""The columns of the tables."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from tutorstudent.study.cells import Cell, about, achieved, heavy_tailed, highest, mean, percent, total, typical
from tutorstudent.study.measures import Measure, per_time, per_way


class Column(NamedTuple):
    """A column of a table: a number of every run, and how the runs of a row are shown."""

    measure: Measure
    cell: Cell
    compared: bool = False
    """Beside it stands the paired difference to the tutor alone."""


def found(counters: Iterable[str]) -> list[Column]:
    """Return the columns about what was found: what the tutor counts, and what the world does."""
    return [
        *(Column(Measure(name, name), achieved, compared=True) for name in counters),
        _column("encounters", "encounters", typical),
        _column("distance, m", "distance_m", typical),
    ]


def cost() -> list[Column]:
    """Return the columns about harm."""
    return [
        Column(Measure("collisions, per decision", "collided"), heavy_tailed, compared=True),
        _column("collisions, per contact", "contacts", heavy_tailed),
        _column("violated, as the learner saw it", "violated", heavy_tailed),
        _column("hardest contact, m/s (max)", "contact_speed_mps", highest),
        _column("longest stall, decisions (max)", "longest_stall", highest),
    ]


def rates(counters: Iterable[str]) -> list[Column]:
    """Return the columns that tell more of everything from doing something better: by way and by time."""
    counted = [*((name, name) for name in counters), *HARMS]
    return [Column(per(title, key), about) for title, key in counted for per in (per_way, per_time)]


HARMS = (("collided decisions", "collided"), ("contacts", "contacts"), ("violated", "violated"))


def conduct() -> list[Column]:
    """Return the columns about what the parts did."""
    return [
        _column("simulated time, s (mean)", "time_s", mean),
        _column("named the tutor's kind (mean)", "match_rate", percent),
        _column("amplified (mean)", "amplified_share", percent),
        _column("mean level", "mean_level", mean),
        _column("incidents (sum)", "incidents", total),
    ]


def digest(counters: Iterable[str]) -> list[Column]:
    """Return the few columns that fit a narrow terminal."""
    return [
        *(_column(name, name, about) for name in counters),
        _column("collided", "collided", about),
        _column("contacts", "contacts", about),
        _column("way, m", "distance_m", mean),
        _column("stall", "longest_stall", highest),
        _column("level", "mean_level", mean),
    ]


def _column(title: str, key: str, cell: Cell) -> Column:
    return Column(Measure(title, key), cell)
