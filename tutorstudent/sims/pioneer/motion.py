"""How robots move: what a drive is, and the kinematic drive of the thesis's simulator."""

from __future__ import annotations

import abc
import math
from collections.abc import Sequence

from tutorstudent.sims.pioneer.body import REACH_M, Pose
from tutorstudent.sims.pioneer.bullet import Bullet

Command = tuple[float, float]
"""Speed (m/s, forward positive) and turning speed (rad/s, left positive)."""

FREE, WALLS = -2, -1
"""What stopped a robot: nothing, or something that never moves; 0 and above is another robot."""

NEAR_M = 2 * REACH_M + 0.01
"""Robots whose rotation centres are farther apart cannot touch."""


class Shapes:
    """The bodies that rays meet, one for each robot. They are put wherever the robots are, or were.

    Args:
        bullet: Where the bodies live.
        bodies: One for each robot.
    """

    def __init__(self, bullet: Bullet, bodies: Sequence[int]) -> None:
        self.bodies = tuple(bodies)
        self._place = bullet.place
        self._shown: list[Pose | None] = [None] * len(bodies)

    def show(self, poses: Sequence[Pose]) -> None:
        """Put every body at its pose."""
        for i, pose in enumerate(poses):
            self.show_one(i, pose)

    def show_one(self, index: int, pose: Pose) -> None:
        """Put one body at its pose, unless it is shown there."""
        if self._shown[index] is not pose:
            self._shown[index] = pose
            self._place(self.bodies[index], pose)


class Drive(abc.ABC):
    """Moves all robots of a scene, one tick of the clock at a time.

    Attributes:
        poses: Where the robots are now.
    """

    poses: list[Pose]

    @abc.abstractmethod
    def tick(self, commands: Sequence[Command]) -> list[int]:
        """Move every robot for one tick; return what stopped each: `FREE`, `WALLS` or the index of a robot."""


class KinematicDrive(Drive):
    """No forces: a step whose end pose touches anything is refused whole (Stage 1.3, facts of Thesis 4.1).

    Robots move one after the other. Standing still is never refused.

    Args:
        bullet: Where the bodies live.
        walls: Body of all that never moves.
        shapes: Bodies of the robots.
        poses: Start poses.
        tick_s: Length of a tick.
    """

    def __init__(self, bullet: Bullet, walls: int, shapes: Shapes, poses: Sequence[Pose], tick_s: float) -> None:
        self.poses = list(poses)
        self._bullet = bullet
        self._walls = walls
        self._shapes = shapes
        self._tick_s = tick_s

    def tick(self, commands: Sequence[Command]) -> list[int]:
        return [self._move(i, command) for i, command in enumerate(commands)]

    def touches(self, index: int) -> int:
        """Return what the robot's shape touches where it is shown; other robots are where they are now."""
        body = self._shapes.bodies[index]
        if self._bullet.touch(body, self._walls):
            return WALLS
        x, y, _ = self.poses[index]
        for other, pose in enumerate(self.poses):
            if abs(pose[0] - x) < NEAR_M and abs(pose[1] - y) < NEAR_M and other != index:
                self._shapes.show_one(other, pose)
                if self._bullet.touch(body, self._shapes.bodies[other]):
                    return other
        return FREE

    def _move(self, index: int, command: Command) -> int:
        speed, turn = command
        if speed == 0.0 and turn == 0.0:
            return FREE
        before = self.poses[index]
        x, y, heading = before
        step = speed * self._tick_s
        after = Pose(x + step * math.cos(heading), y + step * math.sin(heading), heading + turn * self._tick_s)
        self.poses[index] = after
        self._shapes.show_one(index, after)
        stopped = self.touches(index)
        if stopped != FREE:
            self.poses[index] = before
            self._shapes.show_one(index, before)
        return stopped
