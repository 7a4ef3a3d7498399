"""The streamlined algorithm: the student learns levels only (Thesis 5.2.1)."""

from __future__ import annotations

from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.part import Component
from tutorstudent.plugins.streamlined.codec import LevelAmpbit
from tutorstudent.plugins.streamlined.modifier import Modifier

__all__ = ["LevelAmpbit", "Modifier"]


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the streamlined algorithm's codec and selector."""
    return [LevelAmpbit, Modifier]
