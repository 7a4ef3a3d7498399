"""A scene in metres: what is solid, what is coloured, who stands where."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from tutorstudent.core.roles.world import Point
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.sims.pioneer.body import Pose, Rectangle
from tutorstudent.sims.pioneer.mesh import MOST_CORNERS, Mesh, make_circle, make_facades, make_prisms, thicken
from tutorstudent.sims.pioneer.ros_map import read_ros_map
from tutorstudent.sims.pioneer.scene import Box, Circle, Robot, RosMap, Walls
from tutorstudent.sims.pioneer.scene_files import find_scene, read_scene

Outline = list[Point]


@dataclass(frozen=True, slots=True)
class Layout:
    """A scene in metres and radians."""

    arena: Outline
    solids: tuple[tuple[Outline, ...], ...]
    """What is solid in the arena: each thing with all its outlines, those of its holes too."""
    boxes: tuple[Rectangle, ...]
    robots: tuple[Robot, ...]
    starts: tuple[Pose, ...]
    """Start poses of the robots, in their order."""

    mesh: Mesh
    """Everything solid, the outer wall included."""
    pictures: tuple[Mesh, ...]
    """The walls, to be drawn."""

    @property
    def islands(self) -> tuple[Outline, ...]:
        """The outlines of all that is solid in the arena."""
        return tuple(outline for solid in self.solids for outline in solid)

    @property
    def learner(self) -> int:
        """Index of the robot that is taught."""
        return next(i for i, robot in enumerate(self.robots) if robot.controller == "learner")


def load_layout(
    scene: str, side_m: float | None = None, box_side_m: float | None = None, box_places: Sequence[Point] = ()
) -> Layout:
    """Read a scene and return it in metres.

    Args:
        scene: A shipped name or a path.
        side_m: Side of the square instead of the scene's own; only for scenes in percent.
        box_side_m: Side of every box instead of the scene's own.
        box_places: Where the boxes stand instead of the scene's own places, in their order and in its units.
    """
    path = find_scene(scene)
    spec, walls = read_scene(path)
    if side_m is not None and spec.units != "percent":
        raise PipelineError(
            f"world 'pioneer': option 'side_m' scales scenes in percent, but {path} is in metres; leave it out."
        )
    side_m = side_m or spec.side_m
    if side_m is None and isinstance(walls, Walls) and walls.units == "percent":
        raise PipelineError(f"{path}: the walls are in percent, so side_m is required.")
    units = {"metres": 1.0, "percent": (side_m or math.nan) / 100.0}
    unit_m = units[spec.units]
    arena, solids = _read_map(walls) if isinstance(walls, RosMap) else _make_walls(walls, units)
    starts = tuple(Pose(robot.x * unit_m, robot.y * unit_m, math.radians(robot.heading_deg)) for robot in spec.robots)
    places = _choose_places(spec.boxes, box_places, path)
    boxes = [_make_box(box, at, unit_m, box_side_m or box.side_m) for box, at in zip(spec.boxes, places, strict=True)]
    islands = [outline for solid in solids for outline in solid]
    outlines = [arena, thicken(arena), *islands, *(box.corners() for box in boxes)]
    _check_size(outlines, path)
    pictures = tuple(make_facades([arena, *islands]))
    return Layout(arena, tuple(solids), tuple(boxes), tuple(spec.robots), starts, make_prisms(outlines), pictures)


def _check_size(outlines: Sequence[Outline], path: Path) -> None:
    corners = sum(len(outline) for outline in outlines)
    if corners > MOST_CORNERS:
        raise PipelineError(
            f"{path}: walls and boxes have {corners:,} corners together; {MOST_CORNERS:,} are allowed. Leave some out."
        )


def _choose_places(boxes: Sequence[Box], places: Sequence[Point], path: Path) -> Sequence[Point]:
    if not boxes or not places:
        return [(box.x, box.y) for box in boxes]
    if len(places) != len(boxes):
        raise PipelineError(
            f"world 'pioneer': option 'box_places' has {len(places)} places, but {path} has {len(boxes)} boxes; "
            "give one place for each."
        )
    return places


def _read_map(walls: RosMap) -> tuple[Outline, list[tuple[Outline, ...]]]:
    arena, outlines = read_ros_map(Path(walls.ros_map))
    return arena, [tuple(outlines)]


def _make_walls(walls: Walls, units: Mapping[str, float]) -> tuple[Outline, list[tuple[Outline, ...]]]:
    unit_m = units[walls.units]
    return _make_outline(walls.arena, unit_m), [(_make_outline(shape, unit_m),) for shape in walls.islands.values()]


def _make_outline(shape: Circle | list[Point], unit_m: float) -> Outline:
    if isinstance(shape, Circle):
        return make_circle(shape.centre[0] * unit_m, shape.centre[1] * unit_m, shape.radius * unit_m)
    return [(x * unit_m, y * unit_m) for x, y in shape]


def _make_box(box: Box, at: Point, unit_m: float, side_m: float) -> Rectangle:
    heading = math.radians(box.heading_deg)
    half = side_m / 2
    return Rectangle(box.colour, at[0] * unit_m, at[1] * unit_m, math.cos(heading), math.sin(heading), half, half)
