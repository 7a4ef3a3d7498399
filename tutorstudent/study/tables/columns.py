"""The columns of the tables."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from tutorstudent.study.numbers.measures import Measure, measure_per_time, measure_per_way
from tutorstudent.study.tables.cells import (
    Cell,
    highest,
    mean,
    mean_sd,
    mean_sd_median,
    mean_sd_median_iqm,
    mean_sd_median_worst,
    percent,
    total,
)


class Column(NamedTuple):
    """A column of a table: a number of every run, and how the runs of a row are shown."""

    measure: Measure
    cell: Cell
    compared: bool = False
    """Beside it stands the paired difference to the tutor alone."""


def make_found_columns(counters: Iterable[str]) -> list[Column]:
    """Return the columns about what was found: what the tutor counts, and what the world does."""
    counted = [Column(Measure(name, name), mean_sd_median_iqm, compared=True) for name in counters]
    others = [
        _make_column("encounters", "encounters", mean_sd_median),
        _make_column("distance, m", "distance_m", mean_sd_median),
    ]
    return [*counted, *_leave_out(counted, others)]


def make_cost_columns() -> list[Column]:
    """Return the columns about harm."""
    return [
        Column(Measure("collided decisions", "collided"), mean_sd_median_worst, compared=True),
        _make_column("contacts", "contacts", mean_sd_median_worst),
        _make_column("violated, as the learner saw it", "violated", mean_sd_median_worst),
        _make_column("hardest contact, m/s (max)", "contact_speed_mps", highest),
        _make_column("longest stall, decisions (max)", "longest_stall", highest),
    ]


def make_rate_columns(counters: Iterable[str]) -> list[Column]:
    """Return the columns that tell more of everything from doing something better: by way and by time."""
    counted = [*((name, name) for name in counters), *HARMS]
    made = [per(title, key) for title, key in dict(counted).items() for per in (measure_per_way, measure_per_time)]
    return [Column(measure, mean_sd) for measure in made if measure.key != measure.over]


HARMS = (("collided decisions", "collided"), ("contacts", "contacts"), ("violated", "violated"))


def make_conduct_columns() -> list[Column]:
    """Return the columns about what the parts did."""
    return [
        _make_column("simulated time, s (mean)", "time_s", mean),
        _make_column("named the tutor's kind (mean)", "match_rate", percent),
        _make_column("raised by the amplifier (mean)", "amplified_share", percent),
        _make_column("mean level", "mean_level", mean),
        _make_column("incidents (sum)", "incidents", total),
    ]


def make_digest_columns(counters: Iterable[str]) -> list[Column]:
    """Return the few columns that fit a narrow terminal."""
    counted = [_make_column(name, name, mean_sd) for name in counters]
    others = [
        _make_column("collided", "collided", mean_sd),
        _make_column("contacts", "contacts", mean_sd),
        _make_column("way, m", "distance_m", mean),
        _make_column("stall", "longest_stall", highest),
        _make_column("level", "mean_level", mean),
    ]
    return [*counted, *_leave_out(counted, others)]


def _leave_out(there: Iterable[Column], others: Iterable[Column]) -> list[Column]:
    """Return the other columns but for those whose number stands there already."""
    keys = [column.measure.key for column in there]
    return [column for column in others if column.measure.key not in keys]


def _make_column(title: str, key: str, cell: Cell) -> Column:
    return Column(Measure(title, key), cell)
