"""Setting a scene up in Bullet: one mesh for all that never moves, one shape for each robot."""

from __future__ import annotations

from collections.abc import Sequence

from tutorstudent.core.words.errors import PipelineError
from tutorstudent.sims.pioneer.body import Pose, Rectangle
from tutorstudent.sims.pioneer.bullet import Bullet, Rgba
from tutorstudent.sims.pioneer.layout import Layout
from tutorstudent.sims.pioneer.mesh import HEIGHT_M
from tutorstudent.sims.pioneer.motion import FREE, WALLS, KinematicDrive, Shapes
from tutorstudent.sims.pioneer.outlines import is_inside, make_edges

PAINT: dict[str, Rgba] = {
    "red": (0.85, 0.1, 0.1, 1.0),
    "green": (0.1, 0.6, 0.2, 1.0),
    "blue": (0.1, 0.2, 0.85, 1.0),
    "yellow": (0.9, 0.8, 0.1, 1.0),
    "grey": (0.5, 0.5, 0.5, 1.0),
}


class Stage:
    """The bodies of a scene.

    Args:
        bullet: Where they are put; emptied first.
        layout: The scene.

    Attributes:
        walls: Body of all that never moves.
        shapes: Bodies of the robots.
        boxes: Bodies that show the boxes, in the scene's order; nothing meets them.
    """

    def __init__(self, bullet: Bullet, layout: Layout) -> None:
        bullet.clear()
        self._bullet = bullet
        self._layout = layout
        self._arena = make_edges([layout.arena])
        self._solids = [make_edges(solid) for solid in layout.solids]
        self.walls = bullet.add_walls(layout.mesh)
        self.shapes = Shapes(bullet, [bullet.add_robot_shape(PAINT[robot.colour]) for robot in layout.robots])
        for picture in layout.pictures:
            bullet.add_wall_picture(picture, PAINT["grey"])
        self.boxes = tuple(
            bullet.add_picture(_make_size(box), _make_pose(box), PAINT[box.colour]) for box in layout.boxes
        )

    def refuse_taken(self, poses: Sequence[Pose]) -> None:
        """Raise PipelineError if a robot would start in something solid."""
        for index, taken in enumerate(self.find_taken(poses)):
            if taken:
                robot, pose = self._layout.robots[index], poses[index]
                raise PipelineError(
                    f"scene: robot '{robot.name}' cannot start at x {pose.x_m:.2f} m, y {pose.y_m:.2f} m, "
                    f"heading {pose.heading_rad:.2f} rad: {taken}; move it."
                )

    def find_taken(self, poses: Sequence[Pose]) -> list[str]:
        """Return what stands where each robot would start, empty where nothing does."""
        probe = KinematicDrive(self._bullet, self.walls, self.shapes, poses, 1.0)
        self.shapes.show(poses)
        return [self._find_taken(probe, index, pose) for index, pose in enumerate(poses)]

    def _find_taken(self, probe: KinematicDrive, index: int, pose: Pose) -> str:
        here = (pose.x_m, pose.y_m)
        if not is_inside(here, self._arena):
            return "that is outside the arena"
        if any(is_inside(here, solid) for solid in self._solids):
            return "that is inside an island"
        touched = probe.touches(index)
        if touched == FREE:
            return ""
        return "it touches a wall or a box" if touched == WALLS else f"it touches '{self._layout.robots[touched].name}'"


def _make_size(box: Rectangle) -> tuple[float, float, float]:
    return (2 * box.half_length_m, 2 * box.half_width_m, HEIGHT_M)


def _make_pose(box: Rectangle) -> Pose:
    return Pose(box.x_m, box.y_m, box.heading_rad)
