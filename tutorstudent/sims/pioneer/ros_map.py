"""Occupancy maps as ROS's map_server writes and reads them: a YAML file beside an image.

ROS 1 and ROS 2 differ in details; where they do, docs/fidelity.md says whom we follow.
"""

from __future__ import annotations

import difflib
import math
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal

import numpy as np
from pydantic import ConfigDict, Field, field_validator, model_validator

from tutorstudent.core.files.yamlfile import Document, parse_yaml, read_text
from tutorstudent.core.roles.world import Point
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.sims.pioneer.checking import validate
from tutorstudent.sims.pioneer.images import Pixels, read_pixels
from tutorstudent.sims.pioneer.mesh import MOST_CORNERS
from tutorstudent.sims.pioneer.outlines import Cells, Corner, count_corners, find_outlines
from tutorstudent.sims.pioneer.scene import Spec
from tutorstudent.sims.pioneer.scene_files import find_beside

SWITCH: Mapping[str, int] = {"0": 0, "no": 0, "false": 0, "off": 0, "1": 1, "yes": 1, "true": 1, "on": 1}
"""What map_server reads as a number or as yes or no."""


class RosMapFile(Spec):
    """The YAML file of a map; the names are map_server's. It leaves other keys alone, and so do we."""

    model_config = ConfigDict(extra="ignore")

    image: str = Field(min_length=1)
    resolution: float = Field(gt=0, description="m per pixel")
    origin: tuple[float, float, float] = Field(description="x (m), y (m), yaw (rad) of the lower left corner")
    negate: Literal[0, 1] = 0
    occupied_thresh: float = Field(0.65, ge=0, le=1)
    free_thresh: float = Field(0.196, ge=0, le=1)
    mode: Literal["trinary", "scale", "raw"] = "trinary"

    @field_validator("negate", mode="before")
    @classmethod
    def _read_switch(cls, value: Any) -> Any:
        return SWITCH.get(str(value).lower(), value)

    @field_validator("mode", mode="before")
    @classmethod
    def _read_mode(cls, value: Any) -> Any:
        return value.lower() if isinstance(value, str) else value

    @model_validator(mode="after")
    def _check_order(self) -> RosMapFile:
        if self.free_thresh > self.occupied_thresh:
            raise ValueError("free_thresh is above occupied_thresh")
        return self


def read_ros_map(path: Path) -> tuple[list[Point], list[list[Point]]]:
    """Return the outline of the whole map and the outlines of what is occupied, in metres.

    A point is occupied if it is inside an odd number of the latter: a wall that goes round a room has two outlines.
    Occupied is what is darker than ``occupied_thresh``; unknown cells are free. Choice: the map's edge is a wall.
    """
    document = parse_yaml(_replace_tabs(read_text(path)), str(path))
    _refuse_misspelt(document)
    spec = validate(RosMapFile, document)
    image = find_beside(document, ("image",), spec.image)
    cells = _find_occupied(read_pixels(image), spec)[::-1]
    corners = count_corners(cells)
    if corners > MOST_CORNERS:
        raise PipelineError(
            f"{image}: the outlines of what is occupied have {corners:,} corners; {MOST_CORNERS:,} are allowed. Remove "
            "speckles from the image, or save it with fewer pixels and a larger 'resolution'."
        )
    height, width = cells.shape
    whole = [(0, 0), (width, 0), (width, height), (0, height)]
    return _make_metres(whole, spec), [_make_metres(loop, spec) for loop in find_outlines(cells)]


def _replace_tabs(text: str) -> str:
    """Return the text with blanks for tabs, except where they indent: our YAML parser is stricter than map_server's."""
    return re.sub(r"(?<=\S)[ \t]+", lambda blanks: " " * len(blanks.group()), text)


def _refuse_misspelt(document: Document) -> None:
    """Raise PipelineError for an unknown key that resembles a missing one: map_server misses the latter too."""
    if not isinstance(document.data, dict):
        return
    missing = RosMapFile.model_fields.keys() - document.data.keys()
    for key in document.data.keys() - RosMapFile.model_fields.keys():
        near = difflib.get_close_matches(key, missing, n=1, cutoff=0.75)
        if near:
            raise PipelineError(
                f"{document.locate((key,))}: this key is unknown, and '{near[0]}' is missing; did you mean that?"
            )


def _find_occupied(pixels: Pixels, spec: RosMapFile) -> Cells:
    """Return which pixels are occupied.

    As in map_server, ``trinary`` takes transparency for one more colour, ``scale`` takes what is not opaque as unknown,
    and in ``raw`` the values are occupancies in percent.
    """
    values, most, alpha = pixels
    if spec.mode == "trinary" and alpha is not None:
        values, most = values + alpha.astype(np.uint16), most + 255
    light = np.arange(most + 1) / most
    dark = light if spec.negate else 1.0 - light
    if spec.mode == "raw":
        percent = 255.0 * (1.0 - dark)
        occupied = (percent > 100.0 * spec.occupied_thresh) & (percent <= 100.0)
    else:
        occupied = dark > spec.occupied_thresh
    cells: Cells = occupied[values]
    if spec.mode == "scale" and alpha is not None:
        cells &= alpha == 255
    return cells


def _make_metres(corners: list[Corner], spec: RosMapFile) -> list[Point]:
    x0, y0, yaw = spec.origin
    cos, sin = math.cos(yaw) * spec.resolution, math.sin(yaw) * spec.resolution
    return [(x0 + x * cos - y * sin, y0 + x * sin + y * cos) for x, y in corners]
