"""What a Pioneer with a localiser and a map says, and how a path follower drives it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from tutorstudent.sims.pioneer.types import DriveAction, PioneerState

Point = tuple[float, float]
Outlines = tuple[tuple[Point, ...], ...]


class ArcAction(DriveAction):
    """A drive along an arc: translation and rotation are amplified together, so that the robot stays on its arc."""

    amplification = {
        "stop": {},
        "forward": {("translation", "rotation"): "outward"},
        "backward": {},
        "left": {"rotation": "+"},
        "right": {"rotation": "-"},
    }


@dataclass(frozen=True, slots=True)
class Pose:
    """A place on the map, metres, and a heading, radians counter-clockwise from +x."""

    x_m: float
    y_m: float
    heading_rad: float

    def locate(self, point: Point) -> tuple[float, float]:
        """Return distance (m) and bearing (rad, left positive, in [-pi, pi]) of a point."""
        x_m, y_m = point[0] - self.x_m, point[1] - self.y_m
        bearing_rad = math.remainder(math.atan2(y_m, x_m) - self.heading_rad, math.tau)
        return math.hypot(x_m, y_m), bearing_rad


@dataclass(frozen=True, slots=True)
class LocatedState(PioneerState):
    """What the Pioneer senses, where its localiser says it is, and the map that the localiser uses."""

    pose: Pose
    outlines: Outlines
    """Outlines of everything that stands still, metres; the same object throughout a trial."""

    @classmethod
    def examples(cls) -> list[Any]:
        """Return the Pioneer's states in a square room."""
        room = (((0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)),)
        return [
            cls(state.sonar_m, state.blobs, state.stalled, Pose(4.0, 4.0, heading_rad), room)
            for state in PioneerState.examples()
            for heading_rad in (0.0, 2.0)
        ]
