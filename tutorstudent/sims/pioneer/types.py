"""The Pioneer's vocabulary: what it is told and what it senses. Pure; imports no simulator.

Conventions: metres, seconds, radians; x forward, y left, angles counter-clockwise; +translation is forward, +rotation
is left (Thesis 3.3.1).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.words.actions import Action, AmplificationMap, component


class DriveAction(Action):
    """Translation, rotation and duration, as prototype 2 commands its robot (Thesis 3.3.1).

    Translation and rotation are fractions of the robot's full speed; duration 0 means one decision of the world, and an
    hour is the longest, so that a world always answers. The amplifier moves translation or rotation away from zero and
    never the duration (Thesis 3.3.4).
    """

    kind: Literal["stop", "forward", "backward", "left", "right"]
    translation: float = component(-1.0, 1.0, default=0.0, description="fraction of full speed, forward positive")
    rotation: float = component(-1.0, 1.0, default=0.0, description="fraction of full turning speed, left positive")
    duration_s: float = component(0.0, 3600.0, default=0.0, unit="s", description="how long to hold the command")

    amplification: ClassVar[AmplificationMap] = {
        "stop": {},
        "forward": {"translation": "+"},
        "backward": {"translation": "-"},
        "left": {"rotation": "+"},
        "right": {"rotation": "-"},
    }


@dataclass(frozen=True, slots=True)
class Blob:
    """A coloured thing in the camera's view."""

    colour: str
    """``red`` (prey, attractor) or ``blue`` (predator, repulser), Thesis 3.3.1."""
    bearing_rad: float
    """Direction of its visible middle from the robot's heading, left positive."""
    range_m: float
    """Distance from the camera to its visible surface."""
    width_rad: float
    """Angle that its visible part fills."""


@dataclass(frozen=True, slots=True)
class PioneerState:
    """What the Pioneer senses now."""

    sonar_m: NDArray[np.float64]
    """Ranges of the 16 sonars, shape (16,), metres, read-only; sonar 0 looks left, 3 and 4 ahead, 7 right."""
    blobs: tuple[Blob, ...]
    """What the camera sees, nearest first."""
    stalled: bool
    """The robot's own motion was refused in the newest tick, as the robot reports it (possibly late)."""
    bumped: bool = field(default=False, kw_only=True)
    """It reported that for any tick since the state before, the newest included."""

    @classmethod
    def examples(cls) -> list[PioneerState]:
        """Return states to try parts with: free, near walls on each side, stalled, prey and predator near and far."""
        ranges = (np.full(16, 5.0), np.zeros(16), np.linspace(0.05, 5.0, 16), np.linspace(5.0, 0.05, 16))
        red, blue = Blob("red", 0.4, 0.7, 0.3), Blob("blue", -0.4, 0.3, 0.5)
        views = ((), (red,), (blue, red), (Blob("red", -1.0, 4.0, 0.05), Blob("blue", 0.0, 6.0, 0.04)))
        for sonar_m in ranges:
            sonar_m.setflags(write=False)
        walled = [(sonar_m, sonar_m is ranges[1]) for sonar_m in ranges]
        return [cls(sonar_m, blobs, stall, bumped=stall) for sonar_m, stall in walled for blobs in views]
