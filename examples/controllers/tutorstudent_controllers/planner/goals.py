"""What is counted of the planner."""

from __future__ import annotations

from tutorstudent.core.observers import Entries


class Goals(Entries):
    """Counts the goals that were reached."""

    name = "goals"
    situation = "Arrived"
    counted = "goals"
