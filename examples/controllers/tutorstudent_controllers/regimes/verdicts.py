"""What a cell shows: own violations against the budget, gain against the blind twin and the best fixed level."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tutorstudent.study import Run
from tutorstudent_controllers.paired import Difference, difference
from tutorstudent_controllers.regimes.registered import Cell, Registered
from tutorstudent_controllers.regimes.running import BLIND, BUDGETED, RAMP, name_level

Numbers = NDArray[np.float64]


class Measured(NamedTuple):
    """What the runs of one variant came to, by seed."""

    gain: Numbers
    violated: Numbers
    """Violated decisions."""


class Verdict(NamedTuple):
    """One cell."""

    cell: str
    runs: int
    alone: Measured
    budgeted: Measured
    blind: Measured
    ramp: Measured
    """One level more while the tutor's kind stays: no learning."""
    best: int
    """The level with the highest mean gain among those whose own violations keep the budget; 0 is the tutor alone."""
    fixed: Measured
    """Of that level."""
    own: float
    """Mean own violations of `budgeted`: beyond the tutor alone's."""
    allowed: float
    """The budget, in decisions of a run."""
    against: Mapping[int, tuple[Difference, Difference]]
    """Paired differences of gain and violated decisions to every constant level, the tutor alone among them."""

    @property
    def keeps_budget(self) -> float:
        """Own violations as a multiple of the budget."""
        return self.own / self.allowed

    @property
    def share_of_best(self) -> float:
        """Gain as a share of the best fixed level's in hindsight; NaN where that gained nothing."""
        return _divide(self.budgeted, self.fixed)

    @property
    def share_of_blind(self) -> float:
        """Gain as a share of the blind twin's; NaN where that gained nothing."""
        return _divide(self.budgeted, self.blind)

    @property
    def times_fewer(self) -> float | None:
        """How many times as many own violations the blind twin has; None where that has none."""
        theirs = float(self.blind.violated.mean() - self.alone.violated.mean())
        return theirs / max(self.own, 0.5) if theirs > 0.5 else None  # none of our own would be a ratio without end


def judge(registered: Registered, runs: Sequence[Run]) -> list[Verdict]:
    """Return the verdict of every cell of which there are whole pairs."""
    found = {(run.environment, run.variant, run.seed): run.summary for run in runs}
    return [made for cell in registered.cells if (made := _judge(registered, cell, found)) is not None]


def _judge(
    registered: Registered, cell: Cell, found: Mapping[tuple[str, str, int], Mapping[str, float]]
) -> Verdict | None:
    levels = (0, *cell.levels)
    names = [*map(name_level, levels), BUDGETED, BLIND, RAMP]
    seeds = [seed for seed in registered.seeds if all((cell.name, name, seed) in found for name in names)]
    if not seeds:
        return None

    def measure(name: str) -> Measured:
        summaries = [found[cell.name, name, seed] for seed in seeds]
        return Measured(
            np.array([summary[cell.goal] for summary in summaries]),
            np.array([summary["violated"] for summary in summaries]),
        )

    constants = {level: measure(name_level(level)) for level in levels}
    alone, budgeted = constants[0], measure(BUDGETED)
    allowed = registered.budget * registered.decisions
    own = {level: float(item.violated.mean() - alone.violated.mean()) for level, item in constants.items()}
    best = max((level for level in levels if own[level] <= allowed), key=lambda level: constants[level].gain.mean())
    against = {
        level: (_compare(budgeted.gain, item.gain), _compare(budgeted.violated, item.violated))
        for level, item in constants.items()
    }
    mine = float(budgeted.violated.mean() - alone.violated.mean())
    return Verdict(
        cell.name,
        len(seeds),
        alone,
        budgeted,
        measure(BLIND),
        measure(RAMP),
        best,
        constants[best],
        mine,
        allowed,
        against,
    )


def _divide(ours: Measured, theirs: Measured) -> float:
    mean = theirs.gain.mean()
    return float(ours.gain.mean() / mean) if mean > 0 else math.nan


def _compare(ours: Numbers, theirs: Numbers) -> Difference:
    return difference(ours.tolist(), theirs.tolist())
