"""The student that keeps a budget of violations (docs/guide/budgeted.md)."""

from __future__ import annotations

from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.part import Component
from tutorstudent.plugins.budgeted.student import Budgeted


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the student."""
    return [Budgeted]
