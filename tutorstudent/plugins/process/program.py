"""A running program behind three pipes. Nothing here waits longer than it should, whatever the program does."""

from __future__ import annotations

import contextlib
import os
import selectors
import time
import weakref
from subprocess import TimeoutExpired

from tutorstudent.plugins.process.process_options import ProcessOptions
from tutorstudent.plugins.process.starting import Started, put_down, start

CHUNK = 65536
KEPT = 2000
"""Bytes of standard error that are kept, for messages."""
PENDING = 64 * 1024 * 1024
"""Bytes that may wait for a program that does not read."""
TICK_S = 0.02
"""How often a silent program is checked: one that died may have left its pipes to a child."""


class Trouble(Exception):
    """The program cannot go on: it ended, or its output makes no sense. Never raised outside this plugin."""


class Program:
    """Starts the program; raises `Trouble` if it cannot be started.

    Standard error is read whenever anything else is, and only its end is kept. Nothing is read between decisions: a
    program that writes more than a pipe holds has to wait.
    """

    def __init__(self, options: ProcessOptions) -> None:
        self._options = options
        try:
            self._started: Started = start(options)
        except (OSError, ValueError) as error:
            raise Trouble(f"it could not be started: {error}") from None
        self._put_down = weakref.finalize(self, put_down, self._started)  # also where nobody closes us, and at exit
        self.started_s = time.monotonic()
        self.greeted = False
        self._heard, self._outgoing, self._tail = bytearray(), bytearray(), b""
        self._input, self._output, self._errors = self._started.pipes
        self._selector = selectors.DefaultSelector()
        for pipe in (self._output, self._errors):
            self._selector.register(pipe, selectors.EVENT_READ)
        self._mute = self._deaf = False

    def send(self, line: bytes) -> None:
        """Send a line; what does not fit into the pipe follows while an answer is awaited."""
        if len(self._outgoing) > PENDING:
            raise Trouble("it does not read what it is told")
        self._outgoing += line
        self._write()

    def receive(self, until_s: float) -> bytes | None:
        """Return the next line, or None if there is none before that time of the monotonic clock.

        Raises:
            Trouble: The program ended, closed its output, or says too long a line.
        """
        while (line := self._take_line()) is None:
            left_s = until_s - time.monotonic()
            moved = self._exchange(min(max(left_s, 0.0), TICK_S))
            if self._mute or not (moved or self._started.process.poll() is None):
                raise Trouble(self._describe_ending())
            if left_s <= 0:
                return self._take_line()
        return line

    def quote_errors(self) -> str:
        """Return the end of its standard error as a sentence to append; empty if there is none."""
        text = self._tail.decode("utf-8", "backslashreplace")
        lines = [line.strip() for line in text.splitlines()[-5:] if line.strip()]
        return f" Its standard error ends: {' | '.join(lines)}" if lines else ""

    def close(self, farewell: bytes) -> None:
        """Ask the program to end, then tell it to, then end it with all that it started."""
        grace_s = self._options.close_timeout_s
        with contextlib.suppress(Trouble):
            self.send(farewell)
        self._await_end(grace_s)
        if self._started.process.poll() is None:
            self._started.process.terminate()
            self._await_end(grace_s)
        self.kill()

    def kill(self) -> None:
        """End the program and all that it started, at once."""
        self._selector.close()
        self._put_down()

    def _await_end(self, grace_s: float) -> None:
        until_s = time.monotonic() + grace_s
        while self._started.process.poll() is None and time.monotonic() < until_s:
            if not self._outgoing:
                self._stop_writing()
            self._exchange(TICK_S)
            self._heard.clear()
        self._stop_writing()

    def _take_line(self) -> bytes | None:
        end, limit = self._heard.find(b"\n"), self._options.max_line_bytes
        if (len(self._heard) if end < 0 else end) > limit:
            raise Trouble(f"it said a line of more than {limit} bytes (max_line_bytes)")
        if end < 0:
            return None
        line = bytes(self._heard[:end])
        del self._heard[: end + 1]
        return line

    def _exchange(self, timeout_s: float) -> bool:
        """Read and write what is ready; return whether anything was."""
        ready = self._selector.select(timeout_s) if self._selector.get_map() else []
        if not ready and not self._selector.get_map():
            time.sleep(timeout_s)
        for key, _ in ready:
            if key.fd == self._input:
                self._write()
            else:
                self._read(key.fd)
        return bool(ready)

    def _read(self, pipe: int) -> None:
        try:
            chunk = os.read(pipe, CHUNK)
        except BlockingIOError:
            return
        if not chunk:
            self._selector.unregister(pipe)
            self._mute = self._mute or pipe == self._output
        elif pipe == self._output:
            self._heard += chunk
        else:
            self._tail = (self._tail + chunk)[-KEPT:]

    def _write(self) -> None:
        if self._deaf:
            self._outgoing.clear()
            return
        try:
            del self._outgoing[: os.write(self._input, self._outgoing)]
        except BlockingIOError:
            pass
        except BrokenPipeError:
            self._stop_writing()
            return
        if self._outgoing and self._input not in self._selector.get_map():
            self._selector.register(self._input, selectors.EVENT_WRITE)
        elif not self._outgoing and self._input in self._selector.get_map():
            self._selector.unregister(self._input)

    def _stop_writing(self) -> None:
        if not self._deaf:
            self._deaf = True
            if self._input in self._selector.get_map():
                self._selector.unregister(self._input)
            self._started.streams[0].close()
        self._outgoing.clear()

    def _describe_ending(self) -> str:
        try:
            status = self._started.process.wait(timeout=5 * TICK_S)
        except TimeoutExpired:
            return "it closed its standard output"
        finally:
            self._hear_the_last()
        return f"it was ended by signal {-status}" if status < 0 else f"it ended with exit status {status}"

    def _hear_the_last(self) -> None:
        for _ in range(CHUNK // KEPT):
            if not self._exchange(0.0):
                return
