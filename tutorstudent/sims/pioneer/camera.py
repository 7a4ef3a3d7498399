"""The camera by name, and the camera that renders an image."""

from __future__ import annotations

import math

from tutorstudent.sims.pioneer.bullet import Bullet
from tutorstudent.sims.pioneer.layout import Layout
from tutorstudent.sims.pioneer.options import PioneerOptions
from tutorstudent.sims.pioneer.senses import Camera, RayCamera
from tutorstudent.sims.pioneer.vision import BlobCamera


def make_camera(options: PioneerOptions, bullet: Bullet, layout: Layout) -> Camera:
    """Return the camera that the options name."""
    geometry = BlobCamera(math.radians(options.camera_fov_deg), options.camera_range_m, options.camera_columns)
    return RayCamera(bullet, layout, geometry)
