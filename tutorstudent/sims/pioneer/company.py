"""The other robots of a trial: all sense in one batch of rays, each acts every tick."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tutorstudent.core.roles.binding import make_stream
from tutorstudent.sims.pioneer.actors import SONARS, Predator, Prey, Sensed, sense
from tutorstudent.sims.pioneer.body import Pose, footprint
from tutorstudent.sims.pioneer.bullet import Bullet
from tutorstudent.sims.pioneer.layout import Layout
from tutorstudent.sims.pioneer.motion import FREE, Command, Shapes
from tutorstudent.sims.pioneer.scene import Robot
from tutorstudent.sims.pioneer.sonar import ReadNoise, SonarRing
from tutorstudent.sims.pioneer.vision import BlobCamera, Sight
from tutorstudent.sims.pioneer.world_options import PioneerOptions


class Company:
    """All robots but the learner.

    Args:
        bullet: Where the rays are cast.
        shapes: Bodies of all robots.
        layout: The scene.
        options: How they move and sense.
        seed: Seed of the trial; each robot's numbers are keyed by its name.
    """

    def __init__(self, bullet: Bullet, shapes: Shapes, layout: Layout, options: PioneerOptions, seed: int) -> None:
        self._bullet = bullet
        self._shapes = shapes
        self._learner = layout.learner
        self._members = [i for i in range(len(layout.robots)) if i != self._learner]
        self._hunters = [i for i in self._members if layout.robots[i].controller == "predator"]
        self._actors = [_make_actor(layout.robots[i], options, seed) for i in self._members]
        streams = [make_stream(seed, f"pioneer.{layout.robots[i].name}.sonar") for i in self._members]
        self._noise = ReadNoise(options.sonar_noise, len(SONARS), options.sonar_range_m, streams)
        self._ring = SonarRing(SONARS, options.sonar_range_m, len(self._members))
        self._camera = BlobCamera(np.deg2rad(options.camera_fov_deg), options.camera_range_m, options.camera_columns)
        self._speed = (options.full_speed_mps, float(np.deg2rad(options.full_turn_degps)))
        self._every = options.actor_ticks
        self._ticks = 0
        self._sensed: list[Sensed] = []

    def command(self, poses: Sequence[Pose], stopped: Sequence[int], commands: list[Command]) -> None:
        """Write this tick's command of every member into `commands`, by the robots' order.

        Args:
            poses: Where all robots are.
            stopped: What stopped each robot in the last tick.
            commands: One for each robot of the scene; the learner's is left alone.
        """
        if not self._members:
            return
        if self._ticks == 0 or self._ticks % self._every == 1 % self._every:
            self._sensed = self._sense(poses)
        self._ticks += 1
        full_speed, full_turn = self._speed
        for index, actor, known in zip(self._members, self._actors, self._sensed, strict=True):
            translation, rotation = actor.act(known, stopped[index] != FREE)
            commands[index] = (translation * full_speed, rotation * full_turn)

    def _sense(self, poses: Sequence[Pose]) -> list[Sensed]:
        self._shapes.show(poses)
        starts, ends = self._ring.make_rays([poses[i] for i in self._members])
        sights = self._find_sights(poses)
        for sight in sights.values():
            starts, ends = np.concatenate((starts, sight.starts)), np.concatenate((ends, sight.ends))
        fractions = self._bullet.cast(starts, ends)
        rays = len(self._members) * len(SONARS)
        ranges = self._noise.read(self._ring.ranges_m(fractions[:rays])).tolist()
        bearings = self._find_bearings(sights, fractions[rays:])
        return [sense(row, bearings.get(i)) for i, row in zip(self._members, ranges, strict=True)]

    def _find_sights(self, poses: Sequence[Pose]) -> dict[int, Sight]:
        """Return what each hunter could see of the learner, where it could see any."""
        if not self._hunters:
            return {}
        learner = footprint(poses[self._learner], "green")
        sights = {i: self._camera.look(poses[i], [learner]) for i in self._hunters}
        return {i: sight for i, sight in sights.items() if sight.views}

    def _find_bearings(self, sights: dict[int, Sight], fractions: Sequence[float]) -> dict[int, float]:
        """Return the bearing of the learner for each hunter that sees it."""
        found = {}
        for at, (i, sight) in enumerate(sights.items()):
            blobs = self._camera.make_blobs(sight, fractions[at * self._camera.columns :])
            if blobs:
                found[i] = blobs[0].bearing_rad
        return found


def _make_actor(robot: Robot, options: PioneerOptions, seed: int) -> Prey:
    rng = make_stream(seed, f"pioneer.{robot.name}.controller")
    return Predator(options.predator, rng) if robot.controller == "predator" else Prey(options.prey, rng)
