"""A command that runs worlds works in a process of its own, so that whatever ends that process ends in a sentence.

The first process only waits. It passes signals on, and where the other one is gone without a word, it keeps what is
there and says what happened. Where the system cannot fork, there is only one process.
"""

from __future__ import annotations

import _thread
import os
import signal
import sys
import threading
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from types import FrameType
from typing import Any, NoReturn

from tutorstudent.core.files.keeping import rescue, say_kept
from tutorstudent.core.running.parenthood import watch_parent
from tutorstudent.core.running.whereabouts import HERE
from tutorstudent.core.words.errors import TutorStudentError

COMMANDS = ("run", "compare")
FAILED = 1
SIGNALS = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
PATIENCE_S = 30.0
"""How long a process may go on whose parent is gone."""


def watch_over(words: Sequence[str]) -> int | None:
    """Go on in a process of its own if the words name a command that runs worlds.

    Returns:
        None in the process that is to do the work; in the one that waited, the exit code.
    """
    command = next((word for word in words if not word.startswith("-")), "")
    if command not in COMMANDS or not can_fork():
        return None
    for stream in (sys.stdout, sys.stderr):
        _flush(stream)
    parent, child = os.getpid(), os.fork()
    if child == 0:
        for number in SIGNALS:
            signal.signal(number, _stop)
        watch_parent(parent, _leave)
        return None
    return _wait(child)


def can_fork() -> bool:
    """Return whether a second process can take over as this one is."""
    # Not threading.active_count(): that does not know the threads that others started without it.
    return hasattr(os, "fork") and _thread._count() == 0


def _stop(number: int, _: FrameType | None) -> NoReturn:
    raise SystemExit(128 + number)


def _leave() -> None:
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(PATIENCE_S)
    os._exit(FAILED)


def _wait(child: int) -> int:
    def forward(number: int, _: FrameType | None) -> None:
        with suppress(ProcessLookupError):
            os.kill(child, number)

    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the terminal tells the whole group
    for number in SIGNALS:
        signal.signal(number, forward)
    _, status = os.waitpid(child, 0)
    code = os.waitstatus_to_exitcode(status)
    left = HERE.read()
    if code < 0 or left is not None:
        return _report(code, left)
    return code


def _report(code: int, left: dict[str, Any] | None) -> int:
    how = f"was ended by {_name_signal(-code)}" if code < 0 else f"ended at once, with exit status {code}"
    said = f"the process {how}."
    if left is not None:
        who = HERE.describe(left) if "world" in left else "the making of a part"
        said = f"decision {HERE.decision}: the process {how}, in {who}."
        with suppress(TutorStudentError):
            said = f"{said} {say_kept(rescue(Path(left['partial']), Path(left['folder']), said))}"
    sys.stderr.write(f"tutorstudent: {said}\n")
    return 128 - code if code < 0 else max(code, FAILED)


def _name_signal(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def end(code: int) -> NoReturn:
    """End this process, even if a plugin's thread does not end."""
    for stream in (sys.stdout, sys.stderr):
        _flush(stream)
    others = [thread for thread in threading.enumerate() if thread is not threading.main_thread() and not thread.daemon]
    for thread in others:
        thread.join(1.0 / len(others))
    alive = [thread.name for thread in others if thread.is_alive()]
    if alive:
        with suppress(OSError, ValueError):
            sys.stderr.write(f"tutorstudent: a plugin left the thread '{alive[0]}' running; it is ended now.\n")
            sys.stderr.flush()
        os._exit(code)
    sys.exit(code)


def _flush(stream: Any) -> None:
    if stream is None:  # it was closed before the program began
        return
    try:
        stream.flush()
    except (OSError, ValueError):  # whoever read it has gone: what is left is not to be tried again at the end
        with suppress(OSError, ValueError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
