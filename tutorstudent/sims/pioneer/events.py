"""What really happened in a decision: ground truth that the state does not show."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from tutorstudent.core.words.measures import Measure, Summary
from tutorstudent.sims.pioneer.body import REACH_M, Pose, Rectangle, footprint
from tutorstudent.sims.pioneer.motion import FREE, Command

EVENTS: Mapping[str, Summary | Measure] = {
    "stalled_ticks": Measure(
        "stalled_ticks",
        "stalled ticks",
        better="less",
        description="ticks of the simulation in which the learner's own motion was refused",
        detail=True,
    ),
    "collided": "sum",
    "longest_stall": Measure(
        "longest_stall",
        "longest stall",
        unit="decisions",
        better="less",
        summed="max",
        description="most decisions in a row that collided; many mean that it was trapped",
        detail=True,
    ),
    "contacts": "sum",
    "contact_speed_mps": Measure(
        "contact_speed_mps",
        "hardest contact",
        unit="m/s",
        better="less",
        summed="max",
        description="speed that was commanded when a collision began",
        detail=True,
    ),
    "hit_by_others": Measure(
        "hit_by_others",
        "hit by others",
        description="how often another robot ran into the learner",
        detail=True,
    ),
    "encounters": Measure(
        "encounters", better="more", description="how often it came near to something red", detail=True
    ),
    "distance_m": "sum",
    "time_s": "sum",
    "x_m": "last",
    "y_m": "last",
    "heading_rad": "last",
}
"""Stalled: the learner's own motion was refused. A contact is a stalled tick after a free one; ``hit_by_others`` counts
the same for other robots that the learner stopped. ``collided`` is 1 if any tick of the decision stalled, and
``longest_stall`` is how many decisions in a row have collided by now. ``heading_rad`` is in (-pi, pi], while the
heading of a pose counts on."""


class Tally:
    """Counts the events of one robot, tick by tick, and hands them out by decision.

    Args:
        learner: Index of the robot.
        pose: Its start pose.
        tick_s: Length of a tick.
        encounters: Counts the encounters.
    """

    def __init__(self, learner: int, pose: Pose, tick_s: float, encounters: Encounters) -> None:
        self._learner = learner
        self._pose = pose
        self._tick_s = tick_s
        self._encounters = encounters
        self._was_stalled = False
        self._collided_in_a_row = 0
        self._hitting: frozenset[int] = frozenset()
        self._contact_speed_mps = self._distance_m = 0.0
        self._stalled = self._contacts = self._hits = self._encountered = self._ticks = 0

    def add(self, poses: Sequence[Pose], stopped: Sequence[int], command: Command, red: Sequence[Pose]) -> None:
        """Count one tick.

        Args:
            poses: Where the robots are after it.
            stopped: What stopped each of them.
            command: What the learner was told.
            red: Where the red robots are after it.
        """
        pose = poses[self._learner]
        self._distance_m += math.hypot(pose.x_m - self._pose.x_m, pose.y_m - self._pose.y_m)
        self._pose = pose
        self._ticks += 1
        self._encountered += self._encounters.count(pose, red)
        self._add_stall(stopped[self._learner] != FREE, abs(command[0]))
        hitting = frozenset(i for i, by in enumerate(stopped) if by == self._learner)
        self._hits += len(hitting - self._hitting)
        self._hitting = hitting

    def take(self) -> dict[str, float]:
        """Return the events since the last time, by the names of `EVENTS`."""
        self._collided_in_a_row = self._collided_in_a_row + 1 if self._stalled else 0
        events = {
            "stalled_ticks": float(self._stalled),
            "collided": float(self._stalled > 0),
            "longest_stall": float(self._collided_in_a_row),
            "contacts": float(self._contacts),
            "contact_speed_mps": self._contact_speed_mps,
            "hit_by_others": float(self._hits),
            "encounters": float(self._encountered),
            "distance_m": self._distance_m,
            "time_s": self._ticks * self._tick_s,
            "x_m": self._pose.x_m,
            "y_m": self._pose.y_m,
            "heading_rad": wrap_rad(self._pose.heading_rad),
        }
        self._clear()
        return events

    def _add_stall(self, stalled: bool, speed_mps: float) -> None:
        if stalled:
            self._stalled += 1
            if not self._was_stalled:
                self._contacts += 1
                self._contact_speed_mps = max(self._contact_speed_mps, speed_mps)
        self._was_stalled = stalled

    def _clear(self) -> None:
        self._stalled = self._contacts = self._hits = self._encountered = self._ticks = 0
        self._distance_m = self._contact_speed_mps = 0.0


class Encounters:
    """Counts crossings of a radius round red things, with hysteresis.

    Distances run from the robot's rotation centre to the thing's surface. A thing counts again once the robot was
    farther away than the release radius. What is near when counting begins is no encounter.

    Args:
        pose: Where the robot begins.
        boxes: Red boxes.
        robots: Where the red robots begin.
        radius_m: Nearer than this is an encounter.
        release_m: Farther than this ends it; not less than `radius_m`.
    """

    def __init__(
        self, pose: Pose, boxes: Sequence[Rectangle], robots: Sequence[Pose], radius_m: float, release_m: float
    ) -> None:
        self._boxes = tuple(boxes)
        self._radius_m = radius_m
        self._release_m = release_m
        self._inside = [False] * (len(boxes) + len(robots))
        self.count(pose, robots)

    def count(self, pose: Pose, robots: Sequence[Pose]) -> int:
        """Return the number of red things that the robot has come near to since the last time."""
        entered = 0
        for i, box in enumerate(self._boxes):
            if self._enters(i, pose, box, box.half_length_m + box.half_width_m):
                entered += 1
        for i, robot in enumerate(robots, len(self._boxes)):
            if self._enters(i, pose, robot, REACH_M):
                entered += 1
        return entered

    def _enters(self, index: int, pose: Pose, thing: Rectangle | Pose, size_m: float) -> bool:
        inside = self._inside[index]
        reach = self._release_m + size_m
        if abs(thing.x_m - pose.x_m) > reach or abs(thing.y_m - pose.y_m) > reach:
            self._inside[index] = False
            return False
        body = thing if isinstance(thing, Rectangle) else footprint(thing, "red")
        distance = body.distance_m(pose.x_m, pose.y_m)
        self._inside[index] = distance <= self._release_m if inside else distance < self._radius_m
        return self._inside[index] and not inside


def wrap_rad(angle_rad: float) -> float:
    """Return the same direction in (-pi, pi].

    >>> wrap_rad(-math.pi) == wrap_rad(3 * math.pi) == math.pi
    True
    """
    wrapped = math.remainder(angle_rad, math.tau)
    return wrapped if wrapped > -math.pi else math.pi
