"""What prototype 2 looks at: the clearances round the robot, and the nearest prey and predator."""

from __future__ import annotations

import math
from typing import NamedTuple

from tutorstudent.core.words.errors import ContractError
from tutorstudent.sims.pioneer.types import Blob, PioneerState

PREY = "red"
PREDATOR = "blue"
UNSEEN = (math.inf, 0.0)
SONARS = 16
SONAR_RANGE_M = 5.0


class Percept(NamedTuple):
    """A state as the rules and the encoders see it. Computed once per decision.

    A reading that is not a number counts as 0: something is right there. Choice: see docs/fidelity.md.
    """

    front_m: float
    """Smallest range of the four sonars ahead (2 to 5)."""
    view_m: float
    """Smaller range of the two sonars straight ahead (3 and 4): how far the robot can look out."""
    left_m: float
    """Smallest range of sonars 0 and 1."""
    right_m: float
    """Smallest range of sonars 6 and 7."""
    back_m: float
    """Smallest range of the four sonars behind (10 to 13)."""
    left_space_m: float
    """Sum of the four ranges left of the heading (0 to 3); compare it with the right's."""
    right_space_m: float
    """Sum of the four ranges right of the heading (4 to 7)."""
    prey_m: float
    """Distance of the nearest prey; infinite where none is seen."""
    prey_rad: float
    """Bearing of the nearest prey, left positive; 0 where none is seen."""
    predator_m: float
    """Distance of the nearest predator; infinite where none is seen."""
    predator_rad: float
    """Bearing of the nearest predator, left positive; 0 where none is seen."""
    stalled: bool
    """The robot's own motion was refused, as the robot reports it."""

    @property
    def left_is_open(self) -> bool:
        """Whether there is more space to the left than to the right."""
        return self.left_space_m > self.right_space_m

    @property
    def prey_seen(self) -> bool:
        """Whether any prey is in view."""
        return self.prey_m < math.inf

    @property
    def predator_seen(self) -> bool:
        """Whether any predator is in view."""
        return self.predator_m < math.inf


def perceive(state: PioneerState) -> Percept:
    """Return what prototype 2 sees in a state.

    Raises:
        ContractError: If there are not 16 sonar ranges.
    """
    sonar = _read_ranges(state)
    a, b, c, d, e, f, g, h = sonar[:8]
    # By position, since this runs once per decision and once per encoding.
    return Percept(
        min(c, d, e, f),
        min(d, e),
        min(a, b),
        min(g, h),
        min(sonar[10:14]),
        a + b + c + d,
        e + f + g + h,
        *_find_nearest(state.blobs, PREY),
        *_find_nearest(state.blobs, PREDATOR),
        bool(state.stalled),
    )


def _read_ranges(state: PioneerState) -> list[float]:
    ranges: list[float] = state.sonar_m.tolist()
    if len(ranges) != SONARS:
        raise ContractError(f"prototype 2 reads {SONARS} sonar ranges; the state has {len(ranges)}.")
    if math.isfinite(sum(ranges)):
        return ranges
    return [min(_read_number(distance), SONAR_RANGE_M) for distance in ranges]


def _find_nearest(blobs: tuple[Blob, ...], colour: str) -> tuple[float, float]:
    """Return distance and bearing of the nearest blob of a colour."""
    nearest = UNSEEN
    for blob in blobs:
        if blob.colour == colour:
            nearest = min(nearest, (_read_number(blob.range_m), _read_number(blob.bearing_rad)))
    return nearest


def _read_number(reading: float) -> float:
    return 0.0 if math.isnan(reading) else reading
