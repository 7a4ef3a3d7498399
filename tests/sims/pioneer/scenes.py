"""Small scenes for the tests of the Pioneer world."""

from __future__ import annotations

from typing import Any

from tutorstudent.sims.pioneer.body import Pose
from tutorstudent.sims.pioneer.pioneer_world import PioneerWorld
from tutorstudent.sims.pioneer.types import DriveAction

SQUARE = [[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]]
EXACT = {"sonar_noise": 0.0, "sensor_latency": 0, "stall_latency": 0}
"""Options of a world that shows its state as it is."""
STOP = DriveAction(kind="stop")


def robot(controller: str, colour: str, x: float, y: float, heading_deg: float = 0.0) -> dict[str, Any]:
    return {
        "name": f"{controller} at {x} {y}",
        "controller": controller,
        "colour": colour,
        "x": x,
        "y": y,
        "heading_deg": heading_deg,
    }


def scene(x: float = 3.0, y: float = 3.0, heading_deg: float = 0.0, **more: Any) -> dict[str, Any]:
    """Return a scene of a 6 m square with the learner at a pose; `more` replaces or adds.

    `others` are further robots, `islands` and `arena` go into the walls, the rest into the scene.
    """
    walls = {"arena": more.pop("arena", SQUARE), "islands": more.pop("islands", {})}
    robots = [robot("learner", "green", x, y, heading_deg) | {"name": "learner"}, *more.pop("others", [])]
    return {"description": "a test", "walls": walls, "robots": robots} | more


def box(colour: str, x: float, y: float, side_m: float = 0.3, heading_deg: float = 0.0) -> dict[str, Any]:
    return {"colour": colour, "x": x, "y": y, "side_m": side_m, "heading_deg": heading_deg}


def forward(translation: float, duration_s: float = 0.0) -> DriveAction:
    return DriveAction(kind="forward", translation=translation, duration_s=duration_s)


def pose(world: PioneerWorld) -> Pose:
    """Return where the learner is."""
    return Pose(*world.sketch().poses[0][:3])
