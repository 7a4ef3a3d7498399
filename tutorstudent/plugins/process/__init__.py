"""Controllers in another program: any language, any environment, behind a line protocol (docs/process-protocol.md)."""

from __future__ import annotations

from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.part import Component
from tutorstudent.plugins.process.tutor import ProcessTutor

__all__ = ["ProcessTutor"]


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the tutor."""
    return [ProcessTutor]
