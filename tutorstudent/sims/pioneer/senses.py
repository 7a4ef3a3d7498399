"""What the learner senses: sonar, blobs and stall, each as old as its latency."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import Protocol

import numpy as np

from tutorstudent.sims.pioneer.body import Pose, footprint
from tutorstudent.sims.pioneer.bullet import Bullet
from tutorstudent.sims.pioneer.layout import Layout
from tutorstudent.sims.pioneer.motion import Shapes
from tutorstudent.sims.pioneer.sonar import SONARS, ReadNoise, SonarRing
from tutorstudent.sims.pioneer.types import Blob, PioneerState
from tutorstudent.sims.pioneer.vision import BlobCamera
from tutorstudent.sims.pioneer.world_options import PioneerOptions

BLOB_COLOURS = ("red", "blue")
"""Attractors and repulsers (Thesis 3.3.1); other colours are not reported."""


class Camera(Protocol):
    """Something that sees blobs."""

    def look(self, poses: Sequence[Pose]) -> tuple[Blob, ...]:
        """Return what is seen with the robots, whose shapes stand there, at these poses."""


class RayCamera:
    """The blob sensor by geometry and occlusion rays.

    Args:
        bullet: Where the rays are cast.
        layout: The scene.
        camera: Its geometry.
    """

    def __init__(self, bullet: Bullet, layout: Layout, camera: BlobCamera) -> None:
        self._bullet = bullet
        self._camera = camera
        self._learner = layout.learner
        self._boxes = [box for box in layout.boxes if box.colour in BLOB_COLOURS]
        self._movers = find_coloured(layout, BLOB_COLOURS)

    def look(self, poses: Sequence[Pose]) -> tuple[Blob, ...]:
        things = [*self._boxes, *(footprint(poses[i], colour) for i, colour in self._movers)]
        sight = self._camera.look(poses[self._learner], things)
        if not sight.views:
            return ()
        return self._camera.make_blobs(sight, self._bullet.cast(sight.starts, sight.ends))


class Senses:
    """Remembers where everything was, and senses it as it was then.

    Args:
        bullet: Where the rays are cast.
        shapes: Bodies of the robots.
        learner: Index of the robot that senses.
        camera: Sees the blobs.
        options: Latencies, in ticks, and the sonar's range and noise.
        rng: The sonar's own random numbers.
    """

    def __init__(
        self,
        bullet: Bullet,
        shapes: Shapes,
        learner: int,
        camera: Camera,
        options: PioneerOptions,
        rng: np.random.Generator,
    ) -> None:
        self._bullet = bullet
        self._shapes = shapes
        self._learner = learner
        self._camera = camera
        self._ring = SonarRing(range(len(SONARS)), options.sonar_range_m)
        self._noise = ReadNoise(options.sonar_noise, len(SONARS), options.sonar_range_m, [rng])
        self._past: deque[Sequence[Pose]] = deque(maxlen=options.sensor_latency + 1)
        self._stalls: deque[bool] = deque(maxlen=options.stall_latency + 1)
        self._bumped = False
        """Whether any tick since the last state was reported as stalled."""

    def remember(self, poses: Sequence[Pose], stalled: bool) -> None:
        """Note the poses, a new sequence each time, and the learner's stall after a tick, or at the start."""
        self._past.append(poses)
        self._stalls.append(stalled)
        self._bumped |= self._stalls[0]

    def sense(self) -> PioneerState:
        """Return what is sensed now; at the start of a trial, where nothing older is known, what was there first."""
        poses = self._past[0]
        self._shapes.show(poses)
        fractions = self._bullet.cast(*self._ring.make_rays([poses[self._learner]]))
        ranges = self._noise.read(self._ring.ranges_m(fractions))[0]
        ranges.setflags(write=False)
        bumped, self._bumped = self._bumped, False
        return PioneerState(sonar_m=ranges, blobs=self._camera.look(poses), stalled=self._stalls[0], bumped=bumped)


def find_coloured(layout: Layout, colours: Sequence[str]) -> list[tuple[int, str]]:
    """Return index and colour of the robots, the learner left out, that have one of the colours."""
    robots = enumerate(layout.robots)
    return [(i, robot.colour) for i, robot in robots if robot.colour in colours and i != layout.learner]
