"""Every cell of tables 2, 4, 6 and 8 beside ours, with a verdict that nobody can argue with."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from tutorstudent.study import Run
from tutorstudent_prototype2.summaries import Summary, standard_error_of_difference, summarize
from tutorstudent_prototype2.thesis import RUNS, Row, prototype2, rows

ATTRACTORS = "attractors"
MEASURES = (ATTRACTORS, "collided", "contacts")
"""What a run summarizes: attractors found; decisions in which the robot's own motion was refused; and contacts, where
only the first refusal of each entanglement counts. The thesis does not say which of these it calls a collision."""
TITLES = {ATTRACTORS: "attractors found", "collided": "collided decisions", "contacts": "contacts"}


class Cell(NamedTuple):
    """A mean of the thesis beside ours."""

    row: Row
    measure: str
    """One of `MEASURES`."""
    thesis: float
    thesis_sd: float
    ours: Summary

    @property
    def within_sd(self) -> bool:
        """Whether our mean lies within the thesis's mean ± 1 standard deviation over its runs."""
        return abs(self.ours.mean - self.thesis) <= self.thesis_sd

    @property
    def within_errors(self) -> bool:
        """Whether the means differ by at most 2 standard errors of their difference; never for a single run."""
        error = standard_error_of_difference(self.ours.sd, self.ours.runs, self.thesis_sd, RUNS)
        return abs(self.ours.mean - self.thesis) <= 2 * error


class Score(NamedTuple):
    """How many of the twelve means of prototype 2A a prediction hits within the thesis's ± 1 standard deviation."""

    prediction: str
    measure: str
    hits: int
    cells: int


def cells(runs: Sequence[Run]) -> list[Cell]:
    """Return every cell of which we have runs, in the order of the thesis's tables.

    Args:
        runs: Of any environments and pipelines; those that no table has are left out.
    """
    found = []
    for row in rows():
        mine = [run for run in runs if (run.environment, run.variant) == (row.environment, row.pipeline)]
        for measure in MEASURES if mine else ():
            found.append(
                Cell(row, measure, *_read_printed(row, measure), summarize([run.summary[measure] for run in mine]))
            )
    return found


def scores(found: Sequence[Cell]) -> list[Score]:
    """Return how well our means predict the thesis's, beside what anybody could have said without running anything."""
    scored = []
    for measure in MEASURES:
        learned = [cell for cell in found if cell.measure == measure and cell.row.learning_phase is not None]
        scored += [
            _score("ours", learned, lambda cell: cell.ours.mean),
            _score("the thesis's prototype 2 x 3", learned, lambda cell: 3 * _alone(cell)),
            _score("2A = the thesis's prototype 2", learned, _alone),
        ]
        if measure != ATTRACTORS:
            scored.append(_score("always 6 collisions", learned, lambda _: 6.0))
    return scored


def _read_printed(row: Row, measure: str) -> tuple[float, float]:
    return (row.attractors, row.attractors_sd) if measure == ATTRACTORS else (row.collisions, row.collisions_sd)


def _alone(cell: Cell) -> float:
    return _read_printed(prototype2(cell.row.environment), cell.measure)[0]


def _score(prediction: str, found: Sequence[Cell], predicted: Callable[[Cell], float]) -> Score:
    hits = [abs(predicted(cell) - cell.thesis) <= cell.thesis_sd for cell in found]
    measure = next((cell.measure for cell in found), "")
    return Score(prediction, measure, sum(hits), len(hits))
