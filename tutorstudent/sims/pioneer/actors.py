"""The other robots (Thesis 4.1): a prey that wanders, a predator that seeks and chases. Subsumption-like: the first
layer that has something to say commands the robot.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from tutorstudent.core.roles.part import Field, Options

Drive = tuple[float, float]
"""Translation and rotation, fractions of full speed."""

SONARS = range(8)
"""The front half of the ring, which is all that an actor reads."""


class PreyOptions(Options):
    """How a prey moves. Choice: the thesis names the behaviour only (docs/fidelity.md)."""

    forward: float = Field(0.9, ge=0, le=1, description="translation when the way is free, fraction of full speed")
    turn: float = Field(0.3, ge=0, le=1, description="rotation when it is not, fraction of full turning speed")
    front_m: float = Field(0.4, ge=0, le=5, description="it turns away when sonars 2..5 read less, m")
    clear_m: float = Field(0.7, ge=0, le=5, description="it goes on when sonars 2..5 read more, m")
    side_m: float = Field(0.15, ge=0, le=5, description="it bears away when sonars 0, 1, 6 or 7 read less, m")


class PredatorOptions(PreyOptions):
    """How a predator moves: as a prey does, and after the learner when it sees it."""

    forward: float = Field(0.1, ge=0, le=1, description="translation, fraction of full speed")
    turn: float = Field(0.25, ge=0, le=1, description="rotation, fraction of full turning speed")
    stop_m: float = Field(0.3, ge=0, le=5, description="it lets go of the learner when sonars 2..5 read less, m")
    aim_rad: float = Field(0.2, ge=0, le=3.2, description="it drives when the learner is this near to ahead, rad")


class Sensed(NamedTuple):
    """What an actor knows."""

    ahead_m: float
    """Least reading of the sonars 2 to 5."""
    left_m: float
    """Least reading of the sonars 0 and 1."""
    right_m: float
    """Least reading of the sonars 6 and 7."""
    open_side: float
    """1 where the left sonars read more in all, -1 where the right ones do."""
    learner_rad: float | None
    """Bearing of the learner, or None if it is not seen."""


def sense(sonar_m: Sequence[float], learner_rad: float | None) -> Sensed:
    """Return what the readings of `SONARS` and the bearing of the learner mean to an actor."""
    a, b, c, d, e, f, g, h = sonar_m
    return Sensed(min(c, d, e, f), min(a, b), min(g, h), 1.0 if a + b + c + d > e + f + g + h else -1.0, learner_rad)


class Prey:
    """Wanders: recover from a stall, turn away from what is ahead, bear away from what is beside, drive on in arcs.

    Args:
        options: Speeds and distances.
        rng: Its own random numbers.
    """

    def __init__(self, options: PreyOptions, rng: np.random.Generator) -> None:
        self._options = options
        self._rng = rng
        self._recovery_left = 0
        self._recovery: Drive = (0.0, 0.0)
        self._spin = 0.0
        self._arc_left = 0
        self._arc = 0.0
        self.layers: tuple[Callable[[Sensed, bool], Drive | None], ...] = (self.recover, self.turn_away, self.bear_away)

    def act(self, known: Sensed, stalled: bool) -> Drive:
        """Return the command for one tick."""
        for layer in self.layers:
            command = layer(known, stalled)
            if command is not None:
                return command
        return self.wander()

    def recover(self, known: Sensed, stalled: bool) -> Drive | None:
        """After a refused move, 3 to 9 ticks back (70 %) or forward at half speed with a random turn."""
        if stalled:
            self._recovery_left = int(self._rng.integers(3, 10))
            way = -0.5 if self._rng.random() < 0.7 else 0.5
            self._recovery = (way * self._options.forward, float(self._rng.uniform(-1.0, 1.0)) * self._options.turn)
        if self._recovery_left == 0:
            return None
        self._recovery_left -= 1
        return self._recovery

    def turn_away(self, known: Sensed, stalled: bool) -> Drive | None:
        """Something is ahead: turn to the side that is more open, and the same way until the front is clear."""
        if self._spin and known.ahead_m > self._options.clear_m:
            self._spin = 0.0
        if not self._spin and known.ahead_m < self._options.front_m:
            self._spin = known.open_side
        return (0.0, self._spin * self._options.turn) if self._spin else None

    def bear_away(self, known: Sensed, stalled: bool) -> Drive | None:
        """Something is beside: half speed in an arc away from it."""
        if min(known.left_m, known.right_m) >= self._options.side_m:
            return None
        away = -1.0 if known.left_m < known.right_m else 1.0
        return (0.5 * self._options.forward, away * self._options.turn)

    def wander(self) -> Drive:
        """Drive on, in a new arc every 50 ticks or so."""
        if self._arc_left == 0:
            self._arc_left = int(self._rng.integers(40, 61))
            self._arc = max(-1.0, min(1.0, 0.4 * self._options.turn * float(self._rng.standard_normal())))
        self._arc_left -= 1
        return (self._options.forward, self._arc)


class Predator(Prey):
    """Wanders as a prey does until it sees the learner; then turns to it and drives at it."""

    def __init__(self, options: PredatorOptions, rng: np.random.Generator) -> None:
        super().__init__(options, rng)
        self._hunt = options
        self.layers = (self.recover, self.chase, self.turn_away, self.bear_away)

    def chase(self, known: Sensed, stalled: bool) -> Drive | None:
        """Turn on the spot until the learner is ahead, then drive; let go when something is too near to drive."""
        if known.learner_rad is None or known.ahead_m < self._hunt.stop_m:
            return None
        self._spin = 0.0
        if abs(known.learner_rad) > self._hunt.aim_rad:
            return (0.0, self._hunt.turn if known.learner_rad > 0 else -self._hunt.turn)
        return (self._hunt.forward, 0.0)
