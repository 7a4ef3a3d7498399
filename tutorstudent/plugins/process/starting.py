"""Starts a program in a process group of its own, and ends the whole group even if we are killed."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import IO, Any, NamedTuple

from tutorstudent.plugins.process import watchdog
from tutorstudent.plugins.process.process_options import ProcessOptions

KILL_TIMEOUT_S = 10.0
"""How long to wait for an ended process; usually it takes a millisecond."""


class Started(NamedTuple):
    """A program with its watchdog and our ends of its pipes."""

    process: subprocess.Popen[bytes]
    watchdog: subprocess.Popen[bytes]
    streams: tuple[IO[Any], ...]
    """Standard input, output and error of the program."""
    owner: int
    """The process that started it; only that one may end it, not a fork of it."""

    @property
    def pipes(self) -> list[int]:
        """File descriptors of the streams; nonblocking."""
        return [stream.fileno() for stream in self.streams]


def start(options: ProcessOptions) -> Started:
    """Start the program without a shell, in a session of its own, with a watchdog that ends it when we are killed.

    Raises:
        OSError: It cannot be started.
    """
    process = subprocess.Popen(  # noqa: S603 - the owner of the pipeline names the program; no shell is involved
        options.program,
        cwd=options.cwd,
        env=os.environ | options.env,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        bufsize=0,
        start_new_session=True,
    )
    assert process.stdin and process.stdout and process.stderr  # noqa: S101, PT018 - they were asked for
    try:
        guard = _watch(process.pid)
    except OSError:
        _end_group(process)
        raise
    streams = (process.stdin, process.stdout, process.stderr)
    for stream in streams:
        os.set_blocking(stream.fileno(), False)
    return Started(process, guard, streams, os.getpid())


def put_down(started: Started) -> None:
    """End the program's whole group and the watchdog, and close the pipes. To be called once."""
    if started.owner != os.getpid():
        return
    for process in (started.process, started.watchdog):  # the watchdog last: what it guards must be gone
        _end_group(process)
    for stream in (*started.streams, started.watchdog.stdin):
        if stream is not None:
            stream.close()


def _watch(group: int) -> subprocess.Popen[bytes]:
    # Isolated and without site-packages, it starts in some ten milliseconds; its pipe closes when we end, however.
    return subprocess.Popen(  # noqa: S603 - our own script and a number
        [sys.executable, "-I", "-S", str(Path(watchdog.__file__)), str(group)],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )


def _end_group(process: subprocess.Popen[bytes]) -> None:
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(process.pid, signal.SIGKILL)  # the leader's number stays taken while its group has members
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(timeout=KILL_TIMEOUT_S)
