"""What the tree looks at, in the Pioneer's own terms."""

from __future__ import annotations

import math
from typing import NamedTuple

from tutorstudent.sims.pioneer.types import PioneerState


class Percept(NamedTuple):
    """A state as the leaves see it; nothing that is not seen is near."""

    ahead_m: float
    """Smallest range of the four sonars within 30 degrees of the heading."""
    behind_m: float
    """Smallest range of the four sonars behind."""
    left_m: float
    """Mean range of the four sonars on the left; compare it with the right's."""
    right_m: float
    red_m: float
    red_rad: float
    """Bearing of the nearest red thing, left positive."""
    blue_m: float
    blue_rad: float
    stalled: bool


def perceive(state: PioneerState) -> Percept:
    """Return what the tree sees in a state."""
    ranges_m = [0.0 if math.isnan(range_m) else float(range_m) for range_m in state.sonar_m]
    return Percept(
        min(ranges_m[2:6]),
        min(ranges_m[10:14]),
        sum(ranges_m[:4]) / 4,
        sum(ranges_m[4:8]) / 4,
        *_nearest(state, "red"),
        *_nearest(state, "blue"),
        state.stalled,
    )


def _nearest(state: PioneerState, colour: str) -> tuple[float, float]:
    seen = [(blob.range_m, blob.bearing_rad) for blob in state.blobs if blob.colour == colour]
    return min(seen, default=(math.inf, 0.0))
