"""What is counted of the tree."""

from __future__ import annotations

import tutorstudent as ts


class Meetings(ts.Entries):
    """Counts how often the tree came near something red and began to turn away from it."""

    name = "meetings"
    situation = "Turn from red"
    counted = "meetings"
