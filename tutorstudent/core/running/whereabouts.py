"""Where a run is: in which decision, and who is at work. What ends the process does not end this note."""

from __future__ import annotations

import json
import mmap
from typing import Any

SIZE = 8192
PLACES = (
    "the run's own work",
    "an observer: begin()",
    "{world}: reset()",
    "{world}: step()",
    "{tutor} or another part",
    "an observer: observe()",
    "close() of a part",
    "state_dict() of a part",
)
OWN, BEGIN, RESET, STEP, DECIDE, OBSERVE, CLOSE, SAVE = range(len(PLACES))


class Whereabouts:
    """A note in memory that is shared with processes that are forked afterwards, so that a parent can read it."""

    def __init__(self) -> None:
        self._memory = mmap.mmap(-1, SIZE)
        self._cells = memoryview(self._memory)[:16].cast("q")

    @property
    def decision(self) -> int:
        """The decision that is being taken; as many are complete."""
        return self._cells[0]

    def begin_decision(self, number: int) -> None:
        """Note down which decision is being taken."""
        self._cells[0] = number

    @property
    def place(self) -> int:
        """One of `PLACES`."""
        return self._cells[1]

    def enter(self, place: int) -> None:
        """Note down who works from now on."""
        self._cells[1] = place

    def describe(self, names: dict[str, str]) -> str:
        """Return who is at work, by the names of world and tutor."""
        return PLACES[self.place].format(**names)

    def note(self, words: dict[str, Any] | None) -> None:
        """Keep a few plain values, or forget them; `read` returns them."""
        data = json.dumps(words).encode()
        self._memory[16 : 20 + len(data)] = len(data).to_bytes(4, "little") + data

    def read(self) -> Any:
        """Return the plain values that were noted down last, or None."""
        length = int.from_bytes(self._memory[16:20], "little")
        return json.loads(self._memory[20 : 20 + length]) if length else None


HERE = Whereabouts()
"""Of the run of this process: a process that watches over runs makes one run at a time."""
