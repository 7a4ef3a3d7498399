"""A plugin whose world breaks down in every way, at a decision of one's choice; installed by the tests."""

from __future__ import annotations

import ctypes
import os
import resource
import signal
import sys
import threading
import time
from typing import Any

import tutorstudent as ts

Force = ts.scalar(-1, 1)


def fill_the_disk() -> None:
    """From now on no file can be longer than 3,000 bytes."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (3000, resource.RLIM_INFINITY))


def leave_a_thread() -> None:
    threading.Thread(target=time.sleep, args=(600,), name="pump").start()


def stall() -> None:
    """Say that it stands still, and wait for whatever comes."""
    print("stalled", file=sys.stderr, flush=True)
    time.sleep(600)


DEEDS: dict[str, Any] = {
    "raise": lambda: [][0],
    "leave": lambda: sys.exit(0),
    "exit": lambda: os._exit(0),
    "crash": lambda: ctypes.string_at(0),
    "term": lambda: os.kill(os.getpid(), signal.SIGTERM),
    "kill": lambda: os.kill(os.getpid(), signal.SIGKILL),
    "full": fill_the_disk,
    "move": lambda: os.chdir("/"),
    "thread": leave_a_thread,
    "stall": stall,
    "tuple": lambda: (1.0, 0.0, False, False, {}),
    "word": lambda: ts.Step(1.0, {"heat": None}),
    "none": lambda: None,
}


class Broken(ts.World[float, Any]):
    """A number that grows."""

    name = "broken"
    action = Force
    event_names = {"heat": "sum"}

    class Options(ts.Options):
        how: str = ts.Field("never", description="what happens")
        at: int = ts.Field(0, description="in which decision")
        deadly_from: float = ts.Field(0.0, description="in runs whose first random number is so large")

    def setup(self) -> None:
        self._is_meant = float(self.rng.random()) >= self.options.deadly_from

    def reset(self, seed: int) -> float:
        self._number = 0
        return 0.0

    def step(self, action: Any) -> Any:
        number, self._number = self._number, self._number + 1
        said = None
        if number == self.options.at and self.options.how in DEEDS and self._is_meant:
            said = DEEDS[self.options.how]()
            if self.options.how == "none":
                return None
        return said or ts.Step(float(number), {"heat": 1.0})

    def close(self) -> None:
        super().close()
        if self.options.how == "close":
            raise RuntimeError("the door is stuck")


class Steady(ts.Tutor[float, Any]):
    """Always the same; it breaks down where it is told to."""

    name = "steady"
    action = Force

    class Options(ts.Options):
        fails_at: int = ts.Field(-1, description="in which decision it raises")

    def setup(self) -> None:
        self._number = 0

    def act(self, state: float) -> Any:
        self._number += 1
        if self._number - 1 == self.options.fails_at:
            raise OSError("no route to the arm")
        return Force(value=0.25)


@ts.condition("hot")
def hot(state: float) -> bool:
    return state % 7 == 6


@ts.hookimpl
def tutorstudent_components() -> list[type[ts.Component]]:
    return [Broken, Steady, hot]
