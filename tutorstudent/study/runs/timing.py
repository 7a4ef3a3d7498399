"""What a study cost: seconds of every run, and of every sitting. No result depends on it.

A run's ``timing.json`` stands in its folder; ``sittings.json`` stands in the study's, with an entry for each time that
the study was begun or resumed.
"""

from __future__ import annotations

import json
import time
from pathlib import Path
from typing import Any, NamedTuple

TIMING = "timing.json"
SITTINGS = "sittings.json"


class Spent(NamedTuple):
    """Seconds that something took."""

    wall_s: float
    cpu_s: float


class Stopwatch:
    """Measures from the moment at which it is made, wall and CPU seconds of this thread."""

    def __init__(self) -> None:
        self._wall_s, self._cpu_s = time.perf_counter(), time.thread_time()

    def read(self) -> Spent:
        """Return what has been spent so far."""
        return Spent(time.perf_counter() - self._wall_s, time.thread_time() - self._cpu_s)


class Sitting:
    """One uninterrupted part of a study, noted down after every run, since it may end at any moment."""

    def __init__(self, folder: Path, workers: int) -> None:
        self._path = folder / SITTINGS
        self._earlier = _read_entries(self._path)
        self._workers, self._runs, self._watch = workers, 0, Stopwatch()

    def note(self) -> None:
        """Note down that another run has ended."""
        self._runs += 1
        entry = {"workers": self._workers, "runs": self._runs, "wall_s": self._watch.read().wall_s}
        partial = self._path.with_name(f".{self._path.name}.partial")
        partial.write_text(json.dumps([*self._earlier, entry], indent=1) + "\n", encoding="utf-8")
        partial.replace(self._path)


def save_timing(folder: Path, spent: Spent) -> None:
    """Write what a run took into its folder."""
    (folder / TIMING).write_text(json.dumps(spent._asdict(), indent=1) + "\n", encoding="utf-8")


def load_timing(folder: Path) -> Spent:
    """Read what a run took; NaN where that is not known."""
    try:
        data = json.loads((folder / TIMING).read_text(encoding="utf-8"))
        return Spent(float(data["wall_s"]), float(data["cpu_s"]))
    except (OSError, ValueError, KeyError, TypeError):
        return Spent(float("nan"), float("nan"))


def read_sittings(folder: Path) -> list[float]:
    """Return the wall seconds of each sitting of a study, in their order."""
    return [entry["wall_s"] for entry in _read_entries(folder / SITTINGS)]


def _read_entries(path: Path) -> list[dict[str, Any]]:
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
        return [entry for entry in found if isinstance(entry["wall_s"], float)]
    except (OSError, ValueError, KeyError, TypeError):
        return []
