"""How numbers become the text of one cell."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from tutorstudent.study.numbers.pairs import Difference, Improvement
from tutorstudent.study.numbers.statistics import spread

Cell = Callable[[Sequence[float]], str]
NOTHING = "-"


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


def mean_sd_median_iqm(values: Sequence[float]) -> str:
    """Mean, standard deviation, median and interquartile mean.

    >>> mean_sd_median_iqm([1.0, 2.0, 6.0, 3.0])
    '3.0 ± 2.2 (2.5; IQM 2.5)'
    """
    runs = spread(values)
    return f"{mean_sd(values)} ({count(runs.median)}; IQM {number(runs.middle)})"


def mean_sd_median(values: Sequence[float]) -> str:
    """Mean, standard deviation and median.

    >>> mean_sd_median([1.0, 2.0, 6.0])
    '3.0 ± 2.6 (2)'
    """
    return f"{mean_sd(values)} ({count(spread(values).median)})"


def mean_sd(values: Sequence[float]) -> str:
    """Mean and standard deviation.

    >>> mean_sd([1.0, 2.0, 6.0])
    '3.0 ± 2.6'
    """
    runs = spread(values)
    return f"{number(runs.mean)} ± {number(runs.sd)}"


def mean_sd_median_worst(values: Sequence[float]) -> str:
    """Mean, standard deviation, median, and the worst run, which the others hide.

    >>> mean_sd_median_worst([0.0, 0.0, 300.0])
    '100 ± 173 (0; max 300)'
    """
    runs = spread(values)
    return f"{mean_sd(values)} ({count(runs.median)}; max {count(runs.highest)})"


def mean(values: Sequence[float]) -> str:
    """Mean alone."""
    return number(spread(values).mean)


def highest(values: Sequence[float]) -> str:
    """The largest over all runs."""
    return count(float(max(values)))


def add_sign(value: float) -> str:
    """Return a number with its sign.

    >>> add_sign(2.0), add_sign(-2.0), add_sign(0.0)
    ('+2.0', '-2.0', '0')
    """
    return f"+{number(value)}" if value > 0 else number(value)


def difference(paired: Difference | None) -> str:
    """Mean paired difference with its interval.

    >>> from tutorstudent.study.numbers.intervals import Interval
    >>> difference(Difference(10, -2.0, Interval(-3.5, 1.5)))
    '-2.0 [-3.5, +1.5]'
    >>> difference(Difference(2, -2.0, None))
    '-2.0 (2 pairs)'
    """
    if paired is None:
        return NOTHING
    if paired.interval is None:
        return f"{add_sign(paired.mean)} ({'one pair' if paired.pairs == 1 else f'{paired.pairs} pairs'})"
    return f"{add_sign(paired.mean)} [{add_sign(paired.interval.low)}, {add_sign(paired.interval.high)}]"


def correlation(r: float | None) -> str:
    """Pearson's r.

    >>> correlation(-0.314), correlation(None)
    ('-0.31', '-')
    """
    return NOTHING if r is None else f"{r:.2f}"


def improvement(found: Improvement | None) -> str:
    """Share of pairs that were better, with its interval; a dash where neither direction is.

    >>> from tutorstudent.study.numbers.intervals import Interval
    >>> improvement(Improvement(0.95, Interval(0.655, 1.0)))
    '95 % [66, 100]'
    """
    if found is None:
        return NOTHING
    low, high = found.interval
    return f"{100 * found.share:.0f} % [{100 * low:.0f}, {100 * high:.0f}]"


def probability(p: float | None) -> str:
    """A p value.

    >>> [probability(p) for p in (0.00042, 0.0312, 0.5, 1.0, None)]
    ['< 0.001', '0.031', '0.50', '1.00', '-']
    """
    if p is None:
        return NOTHING
    return "< 0.001" if p < 0.001 else f"{p:.3f}" if p < 0.1 else f"{p:.2f}"
