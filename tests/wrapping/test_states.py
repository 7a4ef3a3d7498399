"""The controller sees the owner's own state; parts see copies of what they read."""

from __future__ import annotations

import dataclasses
import io
import threading
from collections import deque
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest

import tutorstudent as ts
from tutorstudent.core.words.snapshots import Hidden, Snapshot, take_snapshot

UNIT = ts.scalar(-1, 1)


class Sensors(dict[str, Any]):
    """A mapping with a method of its own."""

    def nearest(self) -> float:
        return min(self["scan"])


class Slotted:
    __slots__ = ("lock", "scan")

    def __init__(self) -> None:
        self.scan, self.lock = [3.0], threading.Lock()


class Point(NamedTuple):
    x: float
    trail: list[float]


@dataclasses.dataclass(frozen=True)
class Reading:
    y: float
    trail: list[float]


class Robot:
    """An object with everything in it that owners have."""

    def __init__(self) -> None:
        self.scan = [1.0, 2.0]
        self.lock = threading.Lock()
        self.me = self

    @property
    def nearest(self) -> float:
        return min(self.scan)

    def is_near(self) -> bool:
        return self.nearest < 1.5


def circle() -> list[Any]:
    ring: list[Any] = [1.0]
    ring.append(ring)
    return ring


STATES: dict[str, Any] = {
    "a subclass of dict": lambda: Sensors(scan=[1.0, 2.0]),
    "an object": Robot,
    "an object with slots": Slotted,
    "a dataclass": lambda: Reading(1.0, [2.0]),
    "a named tuple": lambda: Point(1.0, [2.0]),
    "a list that holds itself": circle,
    "a lock in a mapping": lambda: {"y": 1.0, "lock": threading.Lock()},
    "a stream": lambda: {"y": 1.0, "file": io.StringIO("text")},
    "a generator": lambda: {"y": 1.0, "rest": iter(())},
    "an array": lambda: np.zeros(3),
    "an array of objects": lambda: np.array([[1.0], Robot()], dtype=object),
    "a deque": lambda: deque([1.0, [2.0]], maxlen=5),
    "a lock": threading.Lock,
    "nothing": lambda: None,
    "a namespace": lambda: SimpleNamespace(y=1.0, inner=SimpleNamespace(z=[2.0])),
}


@pytest.mark.parametrize("name", STATES)
def test_the_controller_is_asked_with_the_very_object(name: str) -> None:
    asked: list[Any] = []
    state = STATES[name]()
    loop = ts.wrap(lambda own: asked.append(own) or 0.5, action=UNIT, condition=lambda shown: False)
    for _ in range(3):
        loop.step(state)
    assert 3 == len(asked)
    assert all(own is state for own in asked)
    assert {} == loop.engine.incident_counts


def test_a_controller_may_work_in_the_owners_buffer() -> None:
    buffer = np.full(2, 0.5)

    def controller(own: Any) -> float:
        np.subtract(own, 0.1, out=own)
        return float(own[0])

    loop = ts.wrap(controller, action=UNIT, condition=lambda shown: bool(shown[0] > 9))
    for _ in range(3):
        loop.step(buffer)
    assert [0.2, 0.2] == pytest.approx(buffer.tolist())
    assert {} == loop.engine.incident_counts


WRITES: dict[str, Any] = {
    "a mapping": (lambda: {"y": [1.0]}, lambda shown: shown.update(y=9) or shown["y"] == 9),
    "what is in a mapping": (lambda: {"y": [1.0]}, lambda shown: shown["y"].append(9.0) or True),
    "an object": (Robot, lambda shown: setattr(shown, "scan", [9.0]) or True),
    "what is in an object": (Robot, lambda shown: shown.scan.append(9.0) or True),
    "what is in a dataclass": (lambda: Reading(1.0, [2.0]), lambda shown: shown.trail.append(9.0) or True),
    "what is in an object that holds itself": (Robot, lambda shown: shown.me.me.scan.append(9.0) or True),
}


@pytest.mark.parametrize("name", WRITES)
def test_what_a_part_writes_stays_with_the_part(name: str) -> None:
    make, write = WRITES[name]
    state, untouched = make(), make()
    loop = ts.wrap(lambda own: 0.5, action=UNIT, condition=write)
    for _ in range(3):
        loop.step(state)
    assert ("condition-1",) == loop.engine.last.outcome.violated  # type: ignore[union-attr]
    assert {} == loop.engine.incident_counts
    plain = [getattr(item, "scan", item) for item in (untouched, state)]
    assert plain[0] == plain[1]


def test_a_twin_is_of_the_states_class_and_its_methods_work() -> None:
    shown = take_snapshot(Robot())
    assert isinstance(shown, Robot)
    assert (True, 1.0) == (shown.is_near(), shown.nearest)
    assert shown.me.me.scan == [1.0, 2.0]
    assert "nearest" in dir(shown)
    sensors = take_snapshot(Sensors(scan=[1.0, 2.0]))
    assert (Sensors, 1.0) == (type(sensors), sensors.nearest())


def test_what_cannot_be_shown_costs_only_the_part_that_reads_it_and_is_named() -> None:
    state = {"y": 1.0, "sim": Robot()}
    conditions = [lambda shown: shown["y"] > 5, lambda shown: shown["sim"].lock.locked()]
    loop = ts.wrap(lambda own: 0.5, action=UNIT, conditions=conditions)
    for _ in range(3):
        loop.step(state)
    assert {("conditions.condition-2", "raised"): 2} == loop.engine.incident_counts
    message = loop.engine.incidents[0].message
    assert "state['sim'].lock is a lock, which cannot be shown to parts" in message


def test_what_nobody_reads_of_an_object_is_never_copied() -> None:
    class Heavy:
        def __init__(self) -> None:
            self.y = 1.0

        def __deepcopy__(self, memo: Any) -> Any:
            raise AssertionError("copied")

        @property
        def world(self) -> Any:
            raise AssertionError("read")

    loop = ts.wrap(lambda own: 0.5, action=UNIT, condition=lambda shown: shown["sim"].y > 5)
    state = {"sim": Heavy(), "info": {"env": Heavy()}}
    for _ in range(3):
        loop.step(state)
    assert {} == loop.engine.incident_counts


def test_what_was_not_read_during_a_decision_is_gone_after_it() -> None:
    robot = Robot()
    with Snapshot() as snapshot:
        shown = snapshot.take(robot, "state")
        assert [1.0, 2.0] == shown.scan
    robot.scan = [7.0]
    assert [1.0, 2.0] == shown.scan
    with pytest.raises(AttributeError, match="state.lock was not read while the decision was made"):
        shown.lock  # noqa: B018


def test_arrays_are_copied_and_read_only_also_those_of_objects() -> None:
    state = np.array([[1.0], 2.0], dtype=object)
    shown = take_snapshot(state)
    state[0].append(9.0)
    assert [[1.0], 2.0] == shown.tolist()
    assert not shown.flags.writeable


def test_a_class_that_watches_its_subclasses_is_left_in_peace() -> None:
    seen: list[type] = []

    class Watching:
        def __init_subclass__(cls) -> None:
            seen.append(cls)

    shown = take_snapshot({"w": Watching()})["w"]
    assert isinstance(shown, Hidden)
    assert [] == seen
    with pytest.raises(TypeError, match="its class watches its subclasses"):
        shown.anything  # noqa: B018
