"""Attractors found, counted from the tutor's situation (Thesis 4.2)."""

from __future__ import annotations

from tutorstudent.core.running.observers import Entries


class Attractors(Entries):
    """Counts entries into Prey Spin: the robot got so close to a prey that it turns away (Thesis 3.3.1)."""

    name = "attractors"
    situation = "Prey Spin"
    counted = "attractors"
