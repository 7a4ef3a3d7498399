"""A behaviour tree of py-trees on the Pioneer: reactive branches, with sequences that remember what they were doing."""

from __future__ import annotations

import tutorstudent as ts
from tutorstudent_controllers.tree.meetings import Meetings
from tutorstudent_controllers.tree.tutor import Tree


@ts.hookimpl
def tutorstudent_components() -> list[type[ts.Component]]:
    """Return tutor and observer."""
    return [Tree, Meetings]
