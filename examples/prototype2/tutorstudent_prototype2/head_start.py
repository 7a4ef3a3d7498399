"""Whether a student that was trained elsewhere learns more quickly: what is measured, and the one table."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tutorstudent.study import Run
from tutorstudent_prototype2.sheets import NOTHING, Section, Sheet, difference, number
from tutorstudent_prototype2.summaries import INTERVALS, Summary, pair_up, summarize

ALONE, FRESH, TRANSPLANTED = "prototype2", "from-nothing", "transplanted"
PREY_SPIN = "Prey Spin"
"""The tutor's situation that counts as an attractor found when it is entered."""

Measured = Mapping[str, float]
BySeed = Mapping[int, Measured]


def head_start(title: str, runs: Sequence[Run], first: int) -> Section:
    """Return the table of all runs, with what it says.

    Args:
        title: Of the sheet.
        runs: Of the variants `ALONE`, `FRESH` and `TRANSPLANTED`, with their decisions on disk.
        first: How many decisions the beginning of a run has, in which "more quickly" (5.2.3) would show.
    """
    found = {
        name: {run.seed: measure(run, first) for run in runs if run.variant == name}
        for name in (ALONE, FRESH, TRANSPLANTED)
    }
    measures = next((list(values) for group in found.values() for values in group.values()), [])
    more = {measure: _more(found, measure) for measure in measures}
    rows = tuple(
        (measure, *(_mean(group.values(), measure) for group in found.values()), difference(more[measure]))
        for measure in measures
    )
    columns = f"Means over runs; difference: transplanted less from nothing, paired by seed, with the {INTERVALS}."
    return Section(Sheet(title, ("", *found, "difference"), rows), (columns, _reading(more)))


def measure(run: Run, first: int) -> Measured:
    """Return what is compared of one run, by title; NaN where there is nothing to measure."""
    arrays = run.arrays()
    found = {
        "attractors": entries(arrays["situation"] == _index(arrays["situation_names"], PREY_SPIN)),
        "collided decisions": arrays["events"][:, _index(arrays["event_names"], "collided")],
    }
    counts = {
        f"{name}, {words}": float(counted[:end].sum())
        for name, counted in found.items()
        for words, end in ((f"first {first} decisions", first), ("all", None))
    }
    return counts | {
        f"match rate, first {first} decisions, %": 100 * _match_rate(arrays, first),
        "match rate, all, %": 100 * _match_rate(arrays, None),
        f"mean level, first {first} decisions": float(arrays["resulting_level"][:first].mean()),
        "mean level, all": float(arrays["resulting_level"].mean()),
    }


def entries(there: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return where a situation begins, shape (decisions,).

    >>> entries(np.array([True, True, False, True])).tolist()
    [True, False, False, True]
    """
    return there & ~np.concatenate(([False], there[:-1]))


def _match_rate(arrays: Mapping[str, NDArray[Any]], end: int | None) -> float:
    if (arrays["proposed_kind"] < 0).all():  # a student that names no kinds
        return math.nan
    return float((arrays["proposed_kind"] == arrays["kind"])[:end].mean())


def _index(names: NDArray[np.str_], name: str) -> int:
    found = np.flatnonzero(names == name)
    return int(found[0]) if len(found) else -1


def _mean(group: Iterable[Measured], measure: str) -> str:
    values = [values[measure] for values in group]
    return number(summarize(values).mean) if values else NOTHING


def _more(found: Mapping[str, BySeed], measure: str) -> Summary | None:
    ours, theirs = ({seed: values[measure] for seed, values in found[name].items()} for name in (TRANSPLANTED, FRESH))
    return pair_up(ours, theirs)


def _reading(more: Mapping[str, Summary | None]) -> str:
    measure = next(iter(more), "")
    head = more.get(measure)
    if head is None:
        return "There are no pairs to compare."
    if head.low > 0:
        return f"A head start shows: {measure}."
    return f"{'The contrary of a' if head.high < 0 else 'No'} head start shows: {measure}."
