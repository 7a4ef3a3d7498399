"""The Pioneer world, seen by a robot that has a map and a localiser."""

from __future__ import annotations

import numpy as np

import tutorstudent as ts
from tutorstudent.sims.pioneer.pioneer_world import PioneerWorld
from tutorstudent.sims.pioneer.types import DriveAction, PioneerState
from tutorstudent.sims.pioneer.world_options import PioneerOptions
from tutorstudent_controllers.planner.state import LocatedState, Outlines, Pose


class LocatedOptions(PioneerOptions):
    """The Pioneer world's options, and how good the localiser is."""

    scene: str = ts.Field("cave-box", description="a scene with one robot, shipped or the path of a YAML file")
    place_noise_m: float = ts.Field(0.02, ge=0, le=1, description="standard deviation of x and y, m")
    heading_noise_rad: float = ts.Field(0.02, ge=0, le=1, description="standard deviation of the heading, rad")


class LocatedWorld(PioneerWorld):
    """The Pioneer world whose states also say where the robot is and what stands where.

    The pose is the one at the end of the decision before, with noise: a localiser needs its time. The map is exact.
    """

    name = "located-pioneer"
    Options = LocatedOptions
    options: LocatedOptions

    def reset(self, seed: int) -> LocatedState:
        state = super().reset(seed)
        sketch = self.sketch()
        if len(sketch.poses) != 1:
            raise ts.PipelineError(
                f"world '{self.name}': the scene '{self.options.scene}' has {len(sketch.poses)} robots; its map would "
                "soon be wrong. Give a scene with the learner alone, such as cave-box."
            )
        x_m, y_m, heading_rad, colour = sketch.poses[0]
        self._outlines: Outlines = tuple(tuple(outline) for outline, of in sketch.polygons if of != colour)
        self._pose = Pose(x_m, y_m, heading_rad)
        self._errors = np.random.default_rng(np.random.SeedSequence(seed).spawn(1)[0])
        return self._locate(state)

    def step(self, action: DriveAction) -> ts.Step[PioneerState]:
        done = super().step(action)
        located = self._locate(done.state)
        self._pose = Pose(*(done.events[key] for key in ("x_m", "y_m", "heading_rad")))
        return done._replace(state=located)

    def _locate(self, state: PioneerState) -> LocatedState:
        x, y, heading = self._errors.standard_normal(3)
        pose = Pose(
            self._pose.x_m + self.options.place_noise_m * x,
            self._pose.y_m + self.options.place_noise_m * y,
            self._pose.heading_rad + self.options.heading_noise_rad * heading,
        )
        return LocatedState(state.sonar_m, state.blobs, state.stalled, pose, self._outlines, bumped=state.bumped)
