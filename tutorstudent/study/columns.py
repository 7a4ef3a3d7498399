"""How the runs of one row become the text of one cell."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

from tutorstudent.study.statistics import Difference, spread

Cell = Callable[[Sequence[float]], str]
NOTHING = "-"


class Column(NamedTuple):
    """A column of a table: a number of every run, and how it is shown."""

    title: str
    key: str
    """Of a run's summary."""
    cell: Cell
    compared: bool = False
    """Beside it stands the paired difference to the tutor alone."""


def number(value: float) -> str:
    """Return a number with as many digits as a table needs.

    >>> [number(value) for value in (0.0, 0.04, 3.25, 84.6, 385.7)]
    ['0', '0.04', '3.2', '84.6', '386']
    """
    if value == 0 or not math.isfinite(value):
        return "0" if value == 0 else NOTHING
    digits = 0 if abs(value) >= 100 else 1 if abs(value) >= 1 else 2
    return f"{value:.{digits}f}"


def count(value: float) -> str:
    """Return a number that is whole in most tables: a count, or the median of counts.

    >>> [count(value) for value in (41.0, 28.5)]
    ['41', '28.5']
    """
    return f"{value:.0f}" if value.is_integer() else number(value)


def typical(values: Sequence[float]) -> str:
    """Mean, standard deviation and median.

    >>> typical([1.0, 2.0, 6.0])
    '3.0 ± 2.6 (2)'
    """
    runs = spread(values)
    return f"{number(runs.mean)} ± {number(runs.sd)} ({count(runs.median)})"


def about(values: Sequence[float]) -> str:
    """Mean and standard deviation.

    >>> about([1.0, 2.0, 6.0])
    '3.0 ± 2.6'
    """
    runs = spread(values)
    return f"{number(runs.mean)} ± {number(runs.sd)}"


def heavy_tailed(values: Sequence[float]) -> str:
    """Mean, standard deviation, median, and the worst run, which the others hide.

    >>> heavy_tailed([0.0, 0.0, 300.0])
    '100 ± 173 (0; max 300)'
    """
    runs = spread(values)
    return f"{number(runs.mean)} ± {number(runs.sd)} ({count(runs.median)}; max {count(runs.highest)})"


def mean(values: Sequence[float]) -> str:
    """Mean alone."""
    return number(spread(values).mean)


def highest(values: Sequence[float]) -> str:
    """The largest over all runs."""
    return count(float(max(values)))


def total(values: Sequence[float]) -> str:
    """The sum over all runs."""
    return count(float(sum(values)))


def percent(values: Sequence[float]) -> str:
    """Mean of shares.

    >>> percent([0.25, 0.75])
    '50 %'
    """
    return f"{100 * spread(values).mean:.0f} %"


def difference(paired: Difference | None) -> str:
    """Mean paired difference with its interval.

    >>> difference(Difference(10, -2.0, -3.5, 1.5))
    '-2.0 [-3.5, +1.5]'
    """
    if paired is None:
        return NOTHING
    if paired.pairs == 1:
        return f"{_signed(paired.mean)} (one pair)"
    return f"{_signed(paired.mean)} [{_signed(paired.low)}, {_signed(paired.high)}]"


def _signed(value: float) -> str:
    return f"+{number(value)}" if value > 0 else number(value)


def found(counters: Iterable[str]) -> list[Column]:
    """Return the columns about what was found: what the tutor counts, and what the world does."""
    return [
        *(Column(name, name, typical, compared=True) for name in counters),
        Column("encounters", "encounters", typical),
        Column("distance, m", "distance_m", typical),
    ]


def cost() -> list[Column]:
    """Return the columns about harm."""
    return [
        Column("collisions, per decision", "collided", heavy_tailed, compared=True),
        Column("collisions, per contact", "contacts", heavy_tailed),
        Column("violated, as the learner saw it", "violated", heavy_tailed),
        Column("hardest contact, m/s (max)", "contact_speed_mps", highest),
        Column("longest stall, decisions (max)", "longest_stall", highest),
    ]


def conduct() -> list[Column]:
    """Return the columns about what the parts did."""
    return [
        Column("simulated time, s (mean)", "time_s", mean),
        Column("amplified (mean)", "amplified_share", percent),
        Column("mean level", "mean_level", mean),
        Column("incidents (sum)", "incidents", total),
    ]


def digest(counters: Iterable[str]) -> list[Column]:
    """Return the few columns that fit a narrow terminal."""
    return [
        *(Column(name, name, about) for name in counters),
        Column("collided", "collided", about),
        Column("contacts", "contacts", about),
        Column("way, m", "distance_m", mean),
        Column("stall", "longest_stall", highest),
        Column("level", "mean_level", mean),
    ]
