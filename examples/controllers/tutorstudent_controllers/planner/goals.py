"""What is counted of the planner."""

from __future__ import annotations

import tutorstudent as ts


class Goals(ts.Entries):
    """Counts the goals that were reached."""

    name = "goals"
    situation = "Arrived"
    counted = "goals"
