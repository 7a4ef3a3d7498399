"""Where the robots of a trial start."""

from __future__ import annotations

from tutorstudent.core.roles.binding import make_stream
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.sims.pioneer.body import Pose
from tutorstudent.sims.pioneer.layout import Layout
from tutorstudent.sims.pioneer.stage import Stage

TRIES = 100
"""Draws of start poses before the scene is called too narrow."""


def find_start_poses(stage: Stage, layout: Layout, jitter_m: float, seed: int) -> list[Pose]:
    """Return free start poses: those of the scene, moved by up to `jitter_m` in x and y (Thesis 4.2: the same places).

    Raises:
        PipelineError: A robot stands in something solid in the scene itself, or wherever it was moved.
    """
    stage.refuse_taken(layout.starts)
    if jitter_m == 0.0:
        return list(layout.starts)
    streams = [make_stream(seed, f"pioneer.{robot.name}.start") for robot in layout.robots]
    for _ in range(TRIES):
        moves = (rng.uniform(-jitter_m, jitter_m, 2).tolist() for rng in streams)
        poses = [Pose(x + dx, y + dy, turn) for (x, y, turn), (dx, dy) in zip(layout.starts, moves, strict=True)]
        if not any(stage.find_taken(poses)):
            return poses
    raise PipelineError(
        f"world 'pioneer': option 'pose_jitter_m' is {jitter_m}, and {TRIES} draws found no free start; lower it."
    )
