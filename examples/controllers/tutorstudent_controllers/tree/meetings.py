"""What is counted of the tree."""

from __future__ import annotations

from tutorstudent.core.observers import Entries


class Meetings(Entries):
    """Counts how often the tree came near something red and began to turn away from it."""

    name = "meetings"
    situation = "Turn from red"
    counted = "meetings"
