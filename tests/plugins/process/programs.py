"""Programs that answer, and programs that do everything else. Each is the body of a small Python script.

`GOOD` answers a number with a hundredth of it; `hostile` puts a body of one's own in place of its answer.
"""

from __future__ import annotations

import os
import sys
import textwrap
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tutorstudent.core.roles.binding import Binding
from tutorstudent.plugins.process import ProcessTutor

UNIT = {"components": {"value": {"low": -1, "high": 1}}}

FRAME = """\
import json, os, signal, subprocess, sys, time

def say(text):
    sys.stdout.write(text + "\\n")
    sys.stdout.flush()

def answer(number, value, **more):
    say(json.dumps({"type": "action", "number": number, "action": {"value": value}, **more}))

def messages():
    for line in iter(sys.stdin.readline, ""):
        yield json.loads(line)

said = 0
"""
LOOP = """\
for message in messages():
    kind, number, state = message["type"], message.get("number"), message.get("state")
    if kind == "hello":
        say('{"type":"hello","protocol":1}')
    if kind == "decide":
        said += 1
"""
GOOD = "answer(number, state / 100)"


def python(script: str) -> list[str]:
    """Return the command that runs a script, quickly."""
    return [sys.executable, "-I", "-S", "-c", script]


def answering(body: str = GOOD) -> list[str]:
    """Return a program that does `body` with every decision: it has number, state, said (counted from 1), answer."""
    return python(FRAME + LOOP + textwrap.indent(textwrap.dedent(body), " " * 8))


def tutor(program: list[str], **options: Any) -> ProcessTutor:
    """Return a bound tutor of one number, with a deadline that the tests can wait for."""
    values = {"action": UNIT, "deadline_s": 0.2, "close_timeout_s": 0.2, "backoff_s": 0.0} | options
    made = ProcessTutor(program=program, **values)
    made.bind(Binding(7, "tutor", made.action))
    return made


def eventually(holds: Callable[[], bool], within_s: float = 20.0) -> bool:
    """Wait until something holds; the bound is for machines that stand still."""
    until_s = time.monotonic() + within_s
    while not holds() and time.monotonic() < until_s:
        time.sleep(0.01)
    return holds()


def runs(pid: int) -> bool:
    """Return whether a process runs; one that ended and waits for its parent does not."""
    try:
        status = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8")
    except FileNotFoundError:
        return False
    return status.rpartition(")")[2].split()[0] not in "ZX"


def descriptors() -> int:
    """Return how many files this process holds open."""
    return len(os.listdir("/proc/self/fd"))  # noqa: PTH208 - names only
