"""Gymnasium's own controllers of its bipedal walker and its lunar lander."""

from __future__ import annotations

import tutorstudent as ts
from tutorstudent_controllers.box2d.bits import ObservationBits
from tutorstudent_controllers.box2d.lander import LanderHeuristic
from tutorstudent_controllers.box2d.walker import WalkerHeuristic
from tutorstudent_controllers.box2d.worlds import Lander, Walker


@ts.hookimpl
def tutorstudent_components() -> list[type[ts.Component]]:
    """Return worlds, tutors and encoder."""
    return [Walker, Lander, WalkerHeuristic, LanderHeuristic, ObservationBits]
