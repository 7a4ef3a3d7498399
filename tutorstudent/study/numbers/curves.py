"""What happened over the decisions of one run, from its recorded columns."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.running.arrays import Arrays
from tutorstudent.core.running.observers import VIOLATED
from tutorstudent.core.running.recorder import NO_LEVEL
from tutorstudent.core.words.measures import Measure

Curve = NDArray[np.float64]


def find_entries(arrays: Arrays, situation: str) -> NDArray[np.bool_]:
    """Return in which decisions the tutor entered a situation, shape (decisions,).

    Counts as `tutorstudent.core.running.observers.Entries` does: a trial's end interrupts a stay.
    """
    codes = np.flatnonzero(arrays["situation_names"] == situation)
    return find_beginnings(np.isin(arrays["situation"], codes), arrays)


def find_beginnings(inside: NDArray[np.bool_], arrays: Arrays) -> NDArray[np.bool_]:
    """Return where something begins that is inside or not, shape (decisions,); it ends with a trial."""
    stayed = np.concatenate([[False], inside[:-1] & ~arrays["trial_ended"][:-1].astype(bool)])
    return np.asarray(inside & ~stayed, dtype=bool)


def read_event(arrays: Arrays, name: str) -> Curve | None:
    """Return the values of one of the world's events, shape (decisions,); None if the world has no such event."""
    return _find_column(arrays, "events", "event_names", name)


def read_series(arrays: Arrays, name: str) -> Curve | None:
    """Return a measure's numbers, shape (decisions,), NaN where there was none; None if the run did not record it."""
    if name.startswith(VIOLATED):
        return _find_column(arrays, "violated", "condition_names", name.removeprefix(VIOLATED))
    if name in SERIES:
        return SERIES[name](arrays)
    measured = _find_column(arrays, "measures", "measure_names", name)
    return read_event(arrays, name) if measured is None else measured


def _find_column(arrays: Arrays, columns: str, names: str, name: str) -> Curve | None:
    found = np.flatnonzero(arrays.get(names, np.zeros(0)) == name)
    return np.asarray(arrays[columns][:, found[0]], dtype=np.float64) if len(found) else None


def count_by_decision(arrays: Arrays, name: str, situation: str) -> Curve | None:
    """Return how much of something was counted in each decision, shape (decisions,).

    Args:
        arrays: Of a run.
        name: Of the count.
        situation: Whose entries are counted; empty for the measure of that name.

    Returns:
        None if that was not recorded, or is less than nothing at times: its total would not only grow.
    """
    if situation:
        return find_entries(arrays, situation).astype(np.float64)
    values = read_series(arrays, name)
    return values if values is not None and np.all(values >= 0) else None


def read_points(arrays: Arrays) -> NDArray[np.float64] | None:
    """Return where the learner was after each decision, shape (decisions, 2), metres; None if that is not known."""
    x, y = read_event(arrays, "x_m"), read_event(arrays, "y_m")
    return None if x is None or y is None else np.column_stack([x, y])


def find_harm(arrays: Arrays) -> NDArray[np.bool_]:
    """Return which decisions collided, shape (decisions,); violated ones where the world knows no collisions."""
    collided = read_event(arrays, "collided")
    return np.asarray(arrays["violated"].any(axis=1) if collided is None else collided > 0, dtype=bool)


def read_level(arrays: Arrays) -> Curve:
    """Return the amplification level of every decision, shape (decisions,)."""
    return np.asarray(arrays["resulting_level"], dtype=np.float64)


def find_matches(arrays: Arrays) -> Curve | None:
    """Return in which decisions the student named the tutor's kind, shape (decisions,); None if it never named any."""
    proposed = arrays["proposed_kind"]
    return np.asarray(proposed == arrays["kind"], dtype=np.float64) if np.any(proposed != NO_LEVEL) else None


SERIES: dict[str, Callable[[Arrays], Curve | None]] = {
    "violated": lambda arrays: np.asarray(arrays["violated"].any(axis=1), dtype=np.float64),
    "mean_level": read_level,
    "executed_ratio": lambda arrays: arrays.get("executed_ratio"),  # runs of earlier versions have none
    "match_rate": find_matches,
    "amplified_share": lambda arrays: np.asarray(
        arrays["resulting_level"] > arrays["selected_level"], dtype=np.float64
    ),
    "taught": lambda arrays: np.asarray(arrays["taught_level"] != NO_LEVEL, dtype=np.float64),
    "incidents": lambda arrays: np.asarray(arrays["incidents"], dtype=np.float64),
}
"""What every run measures stands in columns of its own."""


def sum_up(happened: NDArray[np.bool_] | Curve) -> Curve:
    """Return how often something had happened, or how much of it, after each decision, shape (decisions,)."""
    return np.cumsum(happened, dtype=np.float64)


def thin_out(length: int, points: int = 160) -> NDArray[Any]:
    """Return at most `points` evenly spread positions, the first and the last among them.

    >>> thin_out(5, 3).tolist()
    [0, 2, 4]
    """
    return np.unique(np.linspace(0, length - 1, min(length, points)).round().astype(int))


DECISIONS = 1_000
"""A point of a learning curve covers this many decisions. Choice: see docs/fidelity.md."""
FEWEST = 5
"""Runs in which that would make fewer points than this are cut into `TENTHS`."""
TENTHS = 10


def make_edges(decisions: int) -> NDArray[np.int_]:
    """Return where bins begin and end, shape (bins + 1,): as many thousands as a run has, or its tenths.

    What is left over of a thousand is spread over all bins, so that no bin is shorter than the others by more than one.

    >>> make_edges(6_000).tolist(), make_edges(30).tolist()
    ([0, 1000, 2000, 3000, 4000, 5000, 6000], [0, 3, 6, 9, 12, 15, 18, 21, 24, 27, 30])
    """
    bins = decisions // DECISIONS if decisions >= FEWEST * DECISIONS else min(TENTHS, decisions)
    return np.linspace(0, decisions, bins + 1).round().astype(int)


def make_middles(decisions: int) -> Curve:
    """Return the middle of every bin, in decisions."""
    ends = make_edges(decisions)
    return np.asarray((ends[:-1] + ends[1:]) / 2, dtype=np.float64)


def average_bins(values: NDArray[np.float64]) -> Curve:
    """Return the mean in every bin of something that each decision has, shape (bins,).

    >>> average_bins(np.array([0.0, 1.0, 1.0, 0.0])).tolist()
    [0.0, 1.0, 1.0, 0.0]
    """
    ends = make_edges(len(values))
    sums = np.concatenate([[0.0], np.cumsum(values)])[ends]
    return np.asarray(np.diff(sums) / np.diff(ends), dtype=np.float64)


def make_learning_curve(values: Curve, measure: Measure) -> Curve:
    """Return what a measure came to in every bin, shape (bins,); NaN in a bin without a number.

    Sums are for `DECISIONS` decisions, whatever the width of a bin; shares are in percent.

    >>> values = np.array([1.0, np.nan, 3.0, 5.0])
    >>> make_learning_curve(values, Measure("speed", summed="max")).tolist()
    [1.0, nan, 3.0, 5.0]
    """
    if measure.summed == "sum":
        return DECISIONS * average_bins(np.nan_to_num(values))
    there = np.isfinite(values)
    if measure.summed == "max":
        highest = np.fmax.reduceat(np.where(there, values, -np.inf), make_edges(len(values))[:-1])
        return np.where(np.isfinite(highest), highest, np.nan)
    shares = average_bins(there.astype(np.float64))
    means = average_bins(np.where(there, values, 0.0)) / np.where(shares > 0, shares, np.nan)
    return means * (100 if measure.unit == "%" else 1)


def name_curve(measure: Measure) -> str:
    """Return what a learning curve shows.

    >>> name_curve(Measure("falls")), name_curve(Measure("speed", unit="m/s", summed="mean"))
    ('falls per 1,000 decisions', 'speed, m/s')
    """
    if measure.summed != "sum":
        return measure.heading
    return f"{measure.heading} per {DECISIONS:,}{'' if measure.heading.endswith('decisions') else ' decisions'}"


def describe_point(decisions: int) -> str:
    """Return in words what a point of a learning curve covers.

    >>> describe_point(10_000), describe_point(60)
    ('1,000 decisions', 'a tenth of the run, 6 decisions')
    """
    bins = len(make_edges(decisions)) - 1
    if bins == decisions:
        return "a decision"
    width = f"{round(decisions / bins):,} decisions"
    return width if decisions >= FEWEST * DECISIONS else f"a tenth of the run, {width}"
