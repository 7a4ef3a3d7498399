"""The drawing of an environment, kept as JSON beside the runs."""

from __future__ import annotations

import json
from pathlib import Path

from tutorstudent.core.files.durable import write_whole
from tutorstudent.core.roles.world import Sketch


def save_sketch(path: Path, sketch: Sketch) -> None:
    """Write a drawing as plain numbers, metres and radians."""
    data = {
        "polygons": [[[list(map(float, point)) for point in points], colour] for points, colour in sketch.polygons],
        "discs": [[list(map(float, centre)), float(radius), colour] for centre, radius, colour in sketch.discs],
        "poses": [[float(x), float(y), float(heading), colour] for x, y, heading, colour in sketch.poses],
    }
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, json.dumps(data) + "\n")


def load_sketch(path: Path) -> Sketch:
    """Read a drawing; an empty one where there is none."""
    if not path.exists():
        return Sketch()
    data = json.loads(path.read_text(encoding="utf-8"))
    return Sketch(
        polygons=[([(x, y) for x, y in points], colour) for points, colour in data["polygons"]],
        discs=[((centre[0], centre[1]), radius, colour) for centre, radius, colour in data["discs"]],
        poses=[(x, y, heading, colour) for x, y, heading, colour in data["poses"]],
    )
