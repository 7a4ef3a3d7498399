"""One trial: everything that lives from one reset to the next."""

from __future__ import annotations

from tutorstudent.core.roles.binding import make_stream
from tutorstudent.core.roles.world import Sketch
from tutorstudent.sims.pioneer.body import footprint
from tutorstudent.sims.pioneer.bullet import Bullet
from tutorstudent.sims.pioneer.camera import make_camera
from tutorstudent.sims.pioneer.company import Company
from tutorstudent.sims.pioneer.drives import make_drive
from tutorstudent.sims.pioneer.events import Encounters, Tally
from tutorstudent.sims.pioneer.layout import Layout
from tutorstudent.sims.pioneer.motion import FREE, Command
from tutorstudent.sims.pioneer.senses import Senses, find_coloured
from tutorstudent.sims.pioneer.stage import Stage
from tutorstudent.sims.pioneer.starts import find_start_poses
from tutorstudent.sims.pioneer.types import PioneerState
from tutorstudent.sims.pioneer.world_options import PioneerOptions


class Trial:
    """The scene with its robots, from their start poses on.

    Args:
        bullet: Emptied and filled anew, so that a trial does not depend on what came before.
        layout: The scene.
        options: Of the world.
        seed: The same seed makes the same trial.
    """

    def __init__(self, bullet: Bullet, layout: Layout, options: PioneerOptions, seed: int) -> None:
        stage = Stage(bullet, layout)
        starts = find_start_poses(stage, layout, options.pose_jitter_m, seed)
        self._layout = layout
        self._learner = layout.learner
        self._red = [i for i, _ in find_coloured(layout, ["red"])]
        self._drive = make_drive(options, bullet, stage, starts)
        self._company = Company(bullet, stage.shapes, layout, options, seed)
        self._senses = Senses(
            bullet,
            stage.shapes,
            layout.learner,
            make_camera(options, bullet, layout, stage),
            options,
            make_stream(seed, f"pioneer.{layout.robots[layout.learner].name}.sonar"),
        )
        self._tally = Tally(self._learner, starts[self._learner], options.tick_s, self._make_encounters(options))
        self._commands: list[Command] = [(0.0, 0.0)] * len(starts)
        self._stopped = [FREE] * len(starts)
        self._senses.remember(tuple(starts), False)

    def tick(self, command: Command) -> None:
        """Move every robot for one tick, the learner by `command`."""
        drive = self._drive
        self._commands[self._learner] = command
        self._company.command(drive.poses, self._stopped, self._commands)
        self._stopped = drive.tick(self._commands)
        self._senses.remember(tuple(drive.poses), self._stopped[self._learner] != FREE)
        self._tally.add(drive.poses, self._stopped, command, [drive.poses[i] for i in self._red])

    def sense(self) -> PioneerState:
        """Return what the learner senses now."""
        return self._senses.sense()

    def take_events(self) -> dict[str, float]:
        """Return what happened since the last time."""
        return self._tally.take()

    def sketch(self) -> Sketch:
        """Return a drawing of walls, boxes and robots."""
        layout = self._layout
        robots = list(zip(self._drive.poses, layout.robots, strict=True))
        shapes = [*layout.boxes, *(footprint(pose, robot.colour) for pose, robot in robots)]
        return Sketch(
            polygons=[
                *((outline, "black") for outline in (layout.arena, *layout.islands)),
                *((shape.corners(), shape.colour) for shape in shapes),
            ],
            poses=[(*pose, robot.colour) for pose, robot in robots],
        )

    def _make_encounters(self, options: PioneerOptions) -> Encounters:
        poses = self._drive.poses
        boxes = [box for box in self._layout.boxes if box.colour == "red"]
        radii = (options.encounter_radius_m, options.encounter_release_m)
        return Encounters(poses[self._learner], boxes, [poses[i] for i in self._red], *radii)
