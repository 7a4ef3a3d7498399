"""How far an amplification moves a component (Thesis 3.3.2, 5.2.2)."""

from __future__ import annotations

from tutorstudent.core.component import Component
from tutorstudent.core.hookspecs import hookimpl
from tutorstudent.core.leaves import change


@change("additive")
def Additive(amplification: float, magnitude: float) -> float:  # noqa: ARG001, N802 - it becomes a class
    """Move by level x amount, whatever the tutor's magnitude (Thesis 3.3.2).

    >>> Additive().fraction(0.3, 0.5)
    0.3
    """
    return amplification


@change("multiplicative")
def Multiplicative(amplification: float, magnitude: float) -> float:  # noqa: N802 - it becomes a class
    """Move by level x amount of the tutor's own magnitude: base x (1 + level x amount).

    >>> Multiplicative().fraction(0.3, 0.5)
    0.15
    """
    return amplification * magnitude


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the shipped changes."""
    return [Additive, Multiplicative]
