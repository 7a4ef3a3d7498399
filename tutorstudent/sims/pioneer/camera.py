"""The camera that renders an image, and the choice between it and the one of rays."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tutorstudent.sims.pioneer.body import CENTRE_M, LENGTH_M, Pose
from tutorstudent.sims.pioneer.bullet import Bullet
from tutorstudent.sims.pioneer.layout import Layout
from tutorstudent.sims.pioneer.senses import BLOB_COLOURS, Camera, RayCamera, find_coloured
from tutorstudent.sims.pioneer.stage import Stage
from tutorstudent.sims.pioneer.types import Blob
from tutorstudent.sims.pioneer.vision import BlobCamera
from tutorstudent.sims.pioneer.world_options import PioneerOptions

COLUMNS, ROWS = 160, 8
"""Pixels; 160 columns as in the thesis's simulator, and only the rows near the horizon."""
HORIZON = ROWS // 2 - 1
"""The row at the camera's own height: the renderer samples a pixel at its lower left corner."""
NEAR_M = LENGTH_M / 2 + CENTRE_M + 0.001
"""The image begins just before the robot's own body."""


def make_camera(options: PioneerOptions, bullet: Bullet, layout: Layout, stage: Stage) -> Camera:
    """Return the camera that the options name."""
    field_of_view = math.radians(options.camera_fov_deg)
    if options.camera == "rendered":
        return RenderedCamera(bullet, layout, stage, field_of_view, options.camera_range_m)
    return RayCamera(bullet, layout, BlobCamera(field_of_view, options.camera_range_m, options.camera_columns))


class RenderedCamera:
    """Renders what is before the learner and finds coloured bodies in the row of the horizon.

    Bodies are told apart by the renderer's mask, and ranges come from its depth image, so light does not matter.

    Args:
        bullet: Renders the image.
        layout: The scene.
        stage: Its bodies.
        field_of_view_rad: Full opening angle, less than pi.
        range_m: How far it sees.
    """

    def __init__(self, bullet: Bullet, layout: Layout, stage: Stage, field_of_view_rad: float, range_m: float) -> None:
        self._bullet = bullet
        self._learner = layout.learner
        self._range_m = range_m
        boxes = zip(stage.boxes, (box.colour for box in layout.boxes), strict=True)
        robots = ((stage.shapes.bodies[i], colour) for i, colour in find_coloured(layout, BLOB_COLOURS))
        self._bodies = [*((body, colour) for body, colour in boxes if colour in BLOB_COLOURS), *robots]
        self._half = math.tan(field_of_view_rad / 2)
        lines = np.linspace(self._half, -self._half, COLUMNS + 1)[:-1]
        half_pixel = self._half / COLUMNS
        self._bearing = np.arctan(lines)
        self._width = np.arctan(lines + half_pixel) - np.arctan(lines - half_pixel)

    def look(self, poses: Sequence[Pose]) -> tuple[Blob, ...]:
        mask, depth = self._bullet.render(poses[self._learner], self._half, NEAR_M, self._range_m, (COLUMNS, ROWS))
        blobs = (self._make_blob(body, colour, mask[HORIZON], depth[HORIZON]) for body, colour in self._bodies)
        return tuple(sorted((blob for blob in blobs if blob is not None), key=lambda blob: blob.range_m))

    def _make_blob(self, body: int, colour: str, mask: Any, depth: Any) -> Blob | None:
        ranges = depth / np.cos(self._bearing)
        seen = np.flatnonzero((mask == body) & (ranges <= self._range_m))
        if not seen.size:
            return None
        widths = self._width[seen]
        bearing = float(np.average(self._bearing[seen], weights=widths))
        return Blob(colour, bearing, float(ranges[seen].min()), float(widths.sum()))
