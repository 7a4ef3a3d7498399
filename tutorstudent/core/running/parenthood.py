"""A process that works for another one does not outlive it, whatever ends that one."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable

POLL_S = 0.2
_WATCHED: set[int] = set()


def watch_parent(parent: int, orphaned: Callable[[], object]) -> None:
    """Call a function, in a thread of its own, once the process of that number is no longer the parent of this one."""
    if parent in _WATCHED:
        return
    _WATCHED.add(parent)
    threading.Thread(target=_watch, args=(parent, orphaned), daemon=True).start()


def _watch(parent: int, orphaned: Callable[[], object]) -> None:
    while os.getppid() == parent:
        time.sleep(POLL_S)
    orphaned()
