"""Drives with forces: a planar body under velocity control, and driven wheels on a floor."""

from __future__ import annotations

import abc
import math
from collections.abc import Sequence
from pathlib import Path

from tutorstudent.sims.pioneer.body import CENTRE_M, HEIGHT_M, LENGTH_M, WIDTH_M, Pose
from tutorstudent.sims.pioneer.bullet import FLOOR, PHYSICAL, WALL, WHEEL, Bullet
from tutorstudent.sims.pioneer.motion import FREE, WALLS, Command, Drive

MASS_KG = 9.0
"""Mass of a Pioneer 2 DX by its data sheet."""
PROGRESS = 0.5
"""A robot that touches something is stalled when it made less than this share of its commanded motion."""


class DynamicDrive(Drive):
    """Robots are bodies with mass; a tick is some steps of physics.

    A robot is stopped in a tick if it touches something at the end of it and made less than half of the way, or of the
    turn if no way was commanded. Choice, see docs/fidelity.md.

    Args:
        bullet: Where the bodies live.
        walls: Body of all that never moves.
        poses: Start poses.
        tick_s: Length of a tick.
        physics_hz: Steps of physics in a second; a tick has a whole number of them.
    """

    def __init__(self, bullet: Bullet, walls: int, poses: Sequence[Pose], tick_s: float, physics_hz: float) -> None:
        self.poses = list(poses)
        self._bullet = bullet
        self._walls = walls
        self._tick_s = tick_s
        self._steps = max(1, round(tick_s * physics_hz))
        bullet.call("setTimeStep", tick_s / self._steps)
        self._bodies = [self._add(pose) for pose in poses]

    def tick(self, commands: Sequence[Command]) -> list[int]:
        before = list(self.poses)
        for _ in range(self._steps):
            for body, command in zip(self._bodies, commands, strict=True):
                self._push(body, command)
            self._bullet.call("stepSimulation")
        self.poses = [self._find_pose(body, old) for body, old in zip(self._bodies, before, strict=True)]
        return [self._find_stop(i, before[i], command) for i, command in enumerate(commands)]

    @abc.abstractmethod
    def _add(self, pose: Pose) -> int:
        """Add a robot; return its body."""

    @abc.abstractmethod
    def _push(self, body: int, command: Command) -> None:
        """Do what the command asks for in one step of physics."""

    @abc.abstractmethod
    def _find_pose(self, body: int, before: Pose) -> Pose:
        """Return the pose of the rotation centre after a tick."""

    def _find_stop(self, index: int, before: Pose, command: Command) -> int:
        touched = self._find_touched(self._bodies[index])
        return touched if touched != FREE and self._is_short(before, self.poses[index], command) else FREE

    def _find_touched(self, body: int) -> int:
        for contact in self._bullet.call("getContactPoints", body):
            other = contact[2]
            if other == self._walls:
                return WALLS
            if other in self._bodies:
                return self._bodies.index(other)
        return FREE

    def _is_short(self, before: Pose, after: Pose, command: Command) -> bool:
        speed, turn = command
        dx, dy = after.x_m - before.x_m, after.y_m - before.y_m
        way = dx * math.cos(before.heading_rad) + dy * math.sin(before.heading_rad)
        if speed != 0.0:
            return way / (speed * self._tick_s) < PROGRESS
        return turn != 0.0 and (after.heading_rad - before.heading_rad) / (turn * self._tick_s) < PROGRESS


class PlanarDrive(DynamicDrive):
    """A body that slides over the plane and is given its commanded velocity before every step of physics."""

    def _add(self, pose: Pose) -> int:
        size = [LENGTH_M / 2, WIDTH_M / 2, HEIGHT_M / 2]
        shape = self._bullet.call(
            "createCollisionShape",
            self._bullet.api.GEOM_BOX,
            halfExtents=size,
            collisionFramePosition=[CENTRE_M, 0.0, 0.0],
        )
        body = int(self._bullet.call("createMultiBody", MASS_KG, shape, basePosition=[0.0, 0.0, HEIGHT_M / 2]))
        self._bullet.call("setCollisionFilterGroupMask", body, -1, PHYSICAL, WALL | PHYSICAL)
        self._bullet.call("changeDynamics", body, -1, lateralFriction=0.2, linearDamping=0.0, angularDamping=0.0)
        self._bullet.place(body, pose, HEIGHT_M / 2)
        return body

    def _push(self, body: int, command: Command) -> None:
        speed, turn = command
        heading = _yaw(self._bullet.call("getBasePositionAndOrientation", body)[1])
        velocity = [speed * math.cos(heading), speed * math.sin(heading), 0.0]
        self._bullet.call("resetBaseVelocity", body, velocity, [0.0, 0.0, turn])

    def _find_pose(self, body: int, before: Pose) -> Pose:
        (x, y, _), turn = self._bullet.call("getBasePositionAndOrientation", body)
        pose = Pose(x, y, _unwrap(_yaw(turn), before.heading_rad))
        self._bullet.place(body, pose, HEIGHT_M / 2)
        return pose


class WheeledDrive(DynamicDrive):
    """Two driven wheels and two casters on a floor with gravity; body and wheels are those of `pioneer.urdf`."""

    WHEEL_RADIUS_M = 0.0825
    TRACK_M = 0.357
    """Effective track of the P2DX driver."""
    TORQUE_NM = 2.0
    WHEELS = (0, 1)
    """Joints of the left and the right wheel."""

    def __init__(self, bullet: Bullet, walls: int, poses: Sequence[Pose], tick_s: float, physics_hz: float) -> None:
        bullet.call("setGravity", 0.0, 0.0, -9.81)
        floor = bullet.call("createMultiBody", 0, bullet.call("createCollisionShape", bullet.api.GEOM_PLANE))
        bullet.call("setCollisionFilterGroupMask", floor, -1, FLOOR, WHEEL | PHYSICAL)
        bullet.call("changeDynamics", floor, -1, lateralFriction=1.0)
        super().__init__(bullet, walls, poses, tick_s, physics_hz)

    def tick(self, commands: Sequence[Command]) -> list[int]:
        for body, (speed, turn) in zip(self._bodies, commands, strict=True):
            side = 0.5 * turn * self.TRACK_M
            self._bullet.call(
                "setJointMotorControlArray",
                body,
                self.WHEELS,
                self._bullet.api.VELOCITY_CONTROL,
                targetVelocities=[(speed - side) / self.WHEEL_RADIUS_M, (speed + side) / self.WHEEL_RADIUS_M],
                forces=[self.TORQUE_NM, self.TORQUE_NM],
            )
        return super().tick(commands)

    def _add(self, pose: Pose) -> int:
        body = self._bullet.load_urdf(Path(__file__).parent / "pioneer.urdf", pose)
        self._bullet.call("setCollisionFilterGroupMask", body, -1, PHYSICAL, WALL | PHYSICAL | FLOOR)
        for wheel in self.WHEELS:
            self._bullet.call("setCollisionFilterGroupMask", body, wheel, WHEEL, FLOOR)
        return body

    def _push(self, body: int, command: Command) -> None:
        """Nothing: the motors hold their speed."""

    def _find_pose(self, body: int, before: Pose) -> Pose:
        (x, y, _), turn = self._bullet.call("getBasePositionAndOrientation", body)
        heading = _unwrap(_yaw(turn), before.heading_rad)
        return Pose(x - CENTRE_M * math.cos(heading), y - CENTRE_M * math.sin(heading), heading)


def _yaw(turn: Sequence[float]) -> float:
    x, y, z, w = turn
    return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


def _unwrap(heading: float, before: float) -> float:
    """Return the same direction, counted on from `before`."""
    return before + math.remainder(heading - before, math.tau)
