"""How far an amplification moves a component (Thesis 3.3.2, 5.2.2)."""

from __future__ import annotations

from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.leaves import Change
from tutorstudent.core.roles.part import Component


class Additive(Change):
    """Move by level x amount, whatever the tutor's magnitude (Thesis 3.3.2).

    >>> Additive().fraction(0.3, 0.5)
    0.3
    """

    name = "additive"

    def fraction(self, amplification: float, magnitude: float) -> float:
        return amplification


class Multiplicative(Change):
    """Move by level x amount of the tutor's own magnitude: base x (1 + level x amount).

    >>> Multiplicative().fraction(0.3, 0.5)
    0.15
    """

    name = "multiplicative"

    def fraction(self, amplification: float, magnitude: float) -> float:
        return amplification * magnitude


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the shipped changes."""
    return [Additive, Multiplicative]
