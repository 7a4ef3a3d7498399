"""The Pioneer world: a simulated Pioneer 2 DX among walls, prey and predators (Thesis 4.1)."""

from __future__ import annotations

from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.part import Component
from tutorstudent.sims.pioneer.pioneer_world import PioneerWorld


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Provide the world."""
    return [PioneerWorld]
