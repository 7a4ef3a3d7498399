"""Prototype 2, the tutor of the thesis's application, and encoders of what it senses (Thesis 3.3.1, 3.3.2)."""

from __future__ import annotations

from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.part import Component
from tutorstudent.plugins.prototype2.attractors import Attractors
from tutorstudent.plugins.prototype2.encoders import Bits, SituationBits, Thermometer
from tutorstudent.plugins.prototype2.tutor import Prototype2


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the tutor, its encoders and the observer that counts attractors."""
    return [Prototype2, Bits, SituationBits, Thermometer, Attractors]


__all__ = ["Attractors", "Bits", "Prototype2", "SituationBits", "Thermometer"]
