"""The drives by name."""

from __future__ import annotations

from collections.abc import Sequence

from tutorstudent.sims.pioneer.body import Pose
from tutorstudent.sims.pioneer.bullet import Bullet
from tutorstudent.sims.pioneer.dynamics import DynamicDrive, PlanarDrive, WheeledDrive
from tutorstudent.sims.pioneer.motion import Drive, KinematicDrive
from tutorstudent.sims.pioneer.stage import Stage
from tutorstudent.sims.pioneer.world_options import PioneerOptions

DYNAMIC: dict[str, type[DynamicDrive]] = {"planar": PlanarDrive, "wheeled": WheeledDrive}


def make_drive(options: PioneerOptions, bullet: Bullet, stage: Stage, starts: Sequence[Pose]) -> Drive:
    """Return the drive that the options name, with its robots at their start poses."""
    if options.drive == "kinematic":
        return KinematicDrive(bullet, stage.walls, stage.shapes, starts, options.tick_s)
    return DYNAMIC[options.drive](bullet, stage.walls, starts, options.tick_s, options.physics_hz)
