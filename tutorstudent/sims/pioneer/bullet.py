"""All that this world asks of pybullet; the only file that imports it.

Every call goes through one object with pybullet's functions, handed in by whoever opens a `Bullet`. A benchmark hands
in a `CallLog` of it, and replays the bare calls later.
"""

from __future__ import annotations

import importlib
import math
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from tutorstudent.core.words.errors import PipelineError
from tutorstudent.sims.pioneer.body import CENTRE_M, HEIGHT_M, LENGTH_M, WIDTH_M, Pose
from tutorstudent.sims.pioneer.mesh import Mesh
from tutorstudent.sims.pioneer.sonar import HEIGHT_M as RAY_HEIGHT_M

CLEARANCE_M = 0.002
"""Two bodies nearer than this touch."""
RAY, WALL, SHAPE, PHYSICAL, FLOOR, WHEEL = 1, 64, 128, 256, 512, 1024
"""Collision groups. Rays see walls and shapes; physical bodies meet walls and each other; wheels roll on the floor."""

Rgba = tuple[float, float, float, float]
Points = Any
"""Ray ends: a sequence of (x, y, z) or an array of shape (n, 3); pybullet takes either."""
FAILED = -1
STDERR = 2


def load_pybullet() -> Any:
    """Return the pybullet module; PipelineError with the remedy where it is not installed."""
    try:
        with _silence_stderr():
            return importlib.import_module("pybullet")
    except ImportError:
        raise PipelineError(
            "world 'pioneer' needs pybullet; install it with: pip install 'tutorstudent[bullet]'"
        ) from None


@contextmanager
def _silence_stderr() -> Iterator[None]:
    """Keep pybullet's build time, which it prints from C when it is imported, off the terminal."""
    with Path(os.devnull).open("w", encoding="utf-8") as nowhere:
        kept = os.dup(STDERR)
        os.dup2(nowhere.fileno(), STDERR)
        try:
            yield
        finally:
            os.dup2(kept, STDERR)
            os.close(kept)


class Bullet:
    """One physics client with the scene's bodies in it.

    Args:
        api: The pybullet module, or something that stands in for it.
        gui: Open a window. Without it nothing is drawn.
    """

    def __init__(self, api: Any, gui: bool = False) -> None:
        self._client = api.connect(api.GUI if gui else api.DIRECT)
        if self._client == FAILED:
            raise PipelineError("pybullet could not open its window (option 'gui'); run with gui: false.")
        self.api = api
        self._cast = api.rayTestBatch
        self._set_pose = api.resetBasePositionAndOrientation
        self._closest = api.getClosestPoints

    @property
    def client(self) -> int:
        """Number of the physics client, for whoever calls pybullet besides; -1 once it is closed."""
        return int(self._client)

    def clear(self) -> None:
        """Remove every body."""
        self.api.resetSimulation(physicsClientId=self._client)

    def close(self) -> None:
        """Close the client; does nothing the second time."""
        if self._client != FAILED:
            self.api.disconnect(physicsClientId=self._client)
            self._client = FAILED

    def add_walls(self, mesh: Mesh) -> int:
        """Add the walls and everything else that never moves as one concave mesh; return its body.

        pybullet never frees the vertices that it is handed, so hand it the same mesh again.
        """
        shape = self.api.createCollisionShape(
            self.api.GEOM_MESH, vertices=mesh.vertices, indices=mesh.indices, physicsClientId=self._client
        )
        return self._static(shape, FAILED, WALL, RAY | PHYSICAL)

    def add_robot_shape(self, colour: Rgba) -> int:
        """Add a Pioneer that rays meet and nothing pushes; its origin is the rotation centre. Return its body."""
        size = [LENGTH_M / 2, WIDTH_M / 2, HEIGHT_M / 2]
        middle = [CENTRE_M, 0.0, HEIGHT_M / 2]
        shape = self.api.createCollisionShape(
            self.api.GEOM_BOX, halfExtents=size, collisionFramePosition=middle, physicsClientId=self._client
        )
        looks = self.api.createVisualShape(
            self.api.GEOM_BOX,
            halfExtents=size,
            visualFramePosition=middle,
            rgbaColor=colour,
            physicsClientId=self._client,
        )
        return self._static(shape, looks, SHAPE, RAY)

    def add_wall_picture(self, mesh: Mesh, colour: Rgba) -> None:
        """Add faces that are only drawn."""
        looks = self.api.createVisualShape(
            self.api.GEOM_MESH,
            vertices=mesh.vertices,
            indices=mesh.indices,
            normals=mesh.normals,
            rgbaColor=colour,
            physicsClientId=self._client,
        )
        self._static(FAILED, looks, 0, 0)

    def add_picture(self, size_m: tuple[float, float, float], pose: Pose, colour: Rgba) -> int:
        """Add a coloured cuboid on the floor that is only drawn; return its body."""
        looks = self.api.createVisualShape(
            self.api.GEOM_BOX, halfExtents=[side / 2 for side in size_m], rgbaColor=colour, physicsClientId=self._client
        )
        body = self._static(FAILED, looks, 0, 0)
        self.place(body, pose, size_m[2] / 2)
        return body

    def place(self, body: int, pose: Pose, height_m: float = 0.0) -> None:
        """Put a body's origin at a pose, upright and at rest."""
        x, y, heading = pose
        half = 0.5 * heading
        turn = (0.0, 0.0, math.sin(half), math.cos(half))
        self._set_pose(body, (x, y, height_m), turn, physicsClientId=self._client)

    def touch(self, body: int, other: int) -> bool:
        """Return whether two bodies are nearer than `CLEARANCE_M`."""
        return bool(self._closest(body, other, CLEARANCE_M, physicsClientId=self._client))

    def cast(self, starts: Points, ends: Points) -> list[float]:
        """Return the travelled fraction of each ray, 1 where it met nothing."""
        hits = self._cast(starts, ends, numThreads=1, physicsClientId=self._client)
        return [hit[2] for hit in hits]

    def render(
        self, pose: Pose, half_width: float, near_m: float, far_m: float, pixels: tuple[int, int]
    ) -> tuple[Any, Any]:
        """Return what a camera on the rotation centre sees: body of each pixel and its depth, m, shape (rows, columns).

        Args:
            pose: Of the robot.
            half_width: Tangent of half the horizontal field of view.
            near_m: Depth at which the image begins.
            far_m: Depth at which it ends.
            pixels: Columns and rows; pixels are square.
        """
        columns, rows = pixels
        x, y, heading = pose
        ahead = [x + math.cos(heading), y + math.sin(heading), RAY_HEIGHT_M]
        side = half_width * near_m
        top = side * rows / columns
        image = self.api.getCameraImage(
            columns,
            rows,
            viewMatrix=self.api.computeViewMatrix([x, y, RAY_HEIGHT_M], ahead, [0.0, 0.0, 1.0]),
            projectionMatrix=self.api.computeProjectionMatrix(-side, side, -top, top, near_m, far_m),
            renderer=self.api.ER_TINY_RENDERER,
            physicsClientId=self._client,
        )
        buffer = np.reshape(image[3], (rows, columns))
        return np.reshape(image[4], (rows, columns)), far_m * near_m / (far_m - (far_m - near_m) * buffer)

    def call(self, function: str, *args: Any, **kwargs: Any) -> Any:
        """Call any other function of pybullet on this client."""
        return getattr(self.api, function)(*args, physicsClientId=self._client, **kwargs)

    def load_urdf(self, path: Path, pose: Pose) -> int:
        """Load a URDF with its inertia as written; return its body."""
        turn = self.api.getQuaternionFromEuler([0.0, 0.0, pose.heading_rad])
        where = [pose.x_m, pose.y_m, 0.0]
        flags = self.api.URDF_USE_INERTIA_FROM_FILE
        return int(self.call("loadURDF", str(path), basePosition=where, baseOrientation=turn, flags=flags))

    def _static(self, shape: int, looks: int, group: int, mask: int) -> int:
        body = self.api.createMultiBody(
            0,
            baseCollisionShapeIndex=shape,
            baseVisualShapeIndex=looks,
            physicsClientId=self._client,
        )
        self.api.setCollisionFilterGroupMask(body, -1, group, mask, physicsClientId=self._client)
        return int(body)
