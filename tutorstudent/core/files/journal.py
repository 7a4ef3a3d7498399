"""The decisions of a run are written down while it runs, a block at a time, so that they outlive its process."""

from __future__ import annotations

import json
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np

from tutorstudent.core.files.durable import write_whole
from tutorstudent.core.roles.world import Step
from tutorstudent.core.running.arrays import Arrays, load_arrays, save_arrays
from tutorstudent.core.running.observers import Observer
from tutorstudent.core.running.recorder import NAMES, Recorder
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.core.words.turn import Turn

BLOCK = 1000
"""Decisions that are written down at once; as many may be lost with the process."""
RECORD = "run.json"
DECISIONS = "decisions.npz"
CUT_SHORT = "its process ended before it could say why"


class Journal(Observer):
    """Appends blocks of decisions to a folder; stands after the recorder."""

    name = "journal"

    def __init__(self, folder: Path, recorder: Recorder) -> None:
        super().__init__()
        self._folder, self._recorder, self._written = folder, recorder, 0

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> None:
        if self._recorder.count - self._written >= BLOCK:
            self.write()

    def write(self) -> None:
        """Write down what is not written yet.

        Raises:
            PipelineError: if that is not possible.
        """
        try:
            save_arrays(self._folder / f"block-{self._written:010}.npz", self._recorder.arrays(self._written))
        except OSError as error:
            reason = error.strerror or str(error)
            raise PipelineError(
                f"the decisions cannot be written: {reason}. Make room, or name another folder."
            ) from error
        self._written = self._recorder.count


def save_record(folder: Path, record: Mapping[str, Any]) -> None:
    """Write ``run.json``, whole."""
    write_whole(folder / RECORD, json.dumps(record, indent=2, sort_keys=True, allow_nan=False) + "\n")


def load_record(folder: Path) -> dict[str, Any]:
    """Return what ``run.json`` says; nothing where there is none that can be read."""
    try:
        found = json.loads((folder / RECORD).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def is_complete(record: Mapping[str, Any]) -> bool:
    """Return whether a run took all its decisions."""
    return bool(record.get("complete", True))


def join_blocks(folder: Path) -> int:
    """Make ``decisions.npz`` of the blocks in a folder, and remove them; return how many decisions there are."""
    paths = _find_blocks(folder)
    blocks = [load_arrays(path) for path in paths]
    if not blocks:
        return 0
    newest: Arrays = blocks[-1]  # names are numbered as they come, so the newest block has those of all
    rows = [name for name in newest if not name.endswith(NAMES)]
    joined = newest | {name: np.concatenate([block[name] for block in blocks]) for name in rows}
    save_arrays(folder / DECISIONS, joined)
    remove_blocks(folder)
    return len(joined["kind"])


def remove_blocks(folder: Path) -> None:
    """Remove the blocks, when everything stands in ``decisions.npz``."""
    for path in _find_blocks(folder):
        path.unlink()


def finish_cut_short(folder: Path, problem: str = "") -> int:
    """Make a readable run of what a process left that is gone; return how many decisions were kept."""
    with suppress(OSError):  # where nothing more can be written, the blocks and the first record stay
        decided = join_blocks(folder)
        record = load_record(folder)
        said = problem or record.get("problem", CUT_SHORT)
        save_record(folder, record | {"complete": False, "problem": said, "decided": decided})
    return int(load_record(folder).get("decided", 0))


def _find_blocks(folder: Path) -> list[Path]:
    return sorted(folder.glob("block-*.npz"))
