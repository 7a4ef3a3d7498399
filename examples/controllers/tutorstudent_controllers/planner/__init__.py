"""A deliberative controller: A* over a grid map and pure pursuit, on a Pioneer with a localiser."""

from __future__ import annotations

import tutorstudent as ts
from tutorstudent_controllers.planner.goals import Goals
from tutorstudent_controllers.planner.tutor import GridPlanner
from tutorstudent_controllers.planner.world import LocatedWorld


@ts.hookimpl
def tutorstudent_components() -> list[type[ts.Component]]:
    """Return world, tutor and observer."""
    return [LocatedWorld, GridPlanner, Goals]
