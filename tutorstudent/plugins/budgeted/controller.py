"""The budget controller: one number that rises slowly and falls with every violation of its own.

This is the conformal controller of "Conformal Decision Theory" (Lekeufack, Angelopoulos, Bajcsy, Jordan, Malik,
2024), after "Adaptive Conformal Inference" (Gibbs and Candes, 2021), with a faster climb before the first violation.
What holds, and under which conditions: docs/guide/budgeted.md.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

UNAMPLIFIED = 2**62
"""Decisions since the last amplified one, where there was none."""


@dataclass(frozen=True, slots=True)
class Pace:
    """How fast the level moves."""

    budget: float
    """Own violations per decision, in (0, 1)."""
    fall: float
    """Levels for each own violation, > 0."""
    climb: float
    """Levels per decision before the first own violation, >= 0."""
    window: int
    """Decisions after an amplified one in which a violation is laid to it, >= 0."""


class BudgetController:
    """Says how high to go, from whether anything was violated.

    An *own* violation is one that comes at most `window` decisions after one that it asked to amplify and that was
    amplified, or at such a decision. Any other is the controller's, and says nothing about amplification.

    Before the first own violation the level rises by `climb` a decision; from then on by fall x budget, and each own
    violation takes `fall` away. It does not rise where less was executed than was asked for. The level may fall below
    0: what was spent beyond the budget is made up for.
    """

    def __init__(self, pace: Pace, level: float) -> None:
        self.pace = pace
        self.level = level
        """A real number; its whole part is asked for."""
        self.own = 0
        """Own violations so far."""
        self.decisions = 0
        """Decisions that taught something."""
        self.asked = 0
        """What was asked for last."""
        self._since = UNAMPLIFIED

    def ask(self, highest: int) -> int:
        """Return the level to ask for, 0 to `highest`; what is beyond it is given up."""
        if self.level >= highest + 1:
            self.level = math.nextafter(highest + 1, 0.0)
        self.asked = int(self.level) if self.level > 0.0 else 0
        return self.asked

    def pass_over(self, executed_level: int) -> None:
        """Take in a decision that teaches nothing, but was executed."""
        self._since = 0 if self.asked and executed_level else self._since + 1

    def learn(self, executed_level: int, violated: bool) -> None:
        """Take in what a decision led to."""
        self.pass_over(executed_level)
        self.decisions += 1
        pace = self.pace
        if violated and self._since <= pace.window:
            self.own += 1
            self.level -= pace.fall * (1.0 - pace.budget)
        elif executed_level >= self.asked:
            self.level += pace.fall * pace.budget if self.own else pace.climb

    def forget(self) -> None:
        """Begin a trial: nothing that comes is laid to what was amplified before it."""
        self._since = UNAMPLIFIED
