"""What happened over the decisions of one run, from its recorded columns."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.recording import Arrays

Curve = NDArray[np.float64]


def entries(arrays: Arrays, situation: str) -> Curve:
    """Return how often the tutor had entered a situation after each decision, shape (decisions,).

    Counts as `tutorstudent.core.observers.Entries` does: a trial's end interrupts a stay.
    """
    codes = np.flatnonzero(arrays["situation_names"] == situation)
    inside = np.isin(arrays["situation"], codes)
    stayed = np.concatenate([[False], inside[:-1] & ~arrays["trial_ended"][:-1].astype(bool)])
    return np.cumsum(inside & ~stayed).astype(np.float64)


def event(arrays: Arrays, name: str) -> Curve | None:
    """Return the values of one of the world's events, shape (decisions,); None if the world has no such event."""
    found = np.flatnonzero(arrays["event_names"] == name)
    return np.asarray(arrays["events"][:, found[0]], dtype=np.float64) if len(found) else None


def harm(arrays: Arrays) -> Curve:
    """Return how many decisions had collided after each one; violated ones where the world knows no collisions."""
    collided = event(arrays, "collided")
    return np.cumsum(arrays["violated"].any(axis=1) if collided is None else collided > 0).astype(np.float64)


def level(arrays: Arrays, window: int) -> Curve:
    """Return the amplification level as a moving mean over the last `window` decisions, shape (decisions,)."""
    levels = np.asarray(arrays["resulting_level"], dtype=np.float64)
    sums = np.concatenate([[0.0], np.cumsum(levels)])
    ends = np.arange(1, len(levels) + 1)
    begins = np.maximum(0, ends - window)
    return np.asarray((sums[ends] - sums[begins]) / (ends - begins), dtype=np.float64)


def thinned(length: int, points: int = 160) -> NDArray[Any]:
    """Return at most `points` evenly spread positions, the first and the last among them.

    >>> thinned(5, 3).tolist()
    [0, 2, 4]
    """
    return np.unique(np.linspace(0, length - 1, min(length, points)).round().astype(int))
