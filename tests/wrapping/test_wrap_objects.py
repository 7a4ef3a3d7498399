"""A callable object's own `executed`, `reset` and `situation` are the tutor's."""

from __future__ import annotations

from typing import Any

import pytest

import tutorstudent as ts
from tutorstudent.core.deciding.function_tutor import FunctionTutor, HearingTutor

UNIT = ts.scalar(-1, 1)
DRIVE = ts.scalar(-1, 1, name="speed")


class Pid:
    """A controller with a memory and its own command type."""

    def __init__(self) -> None:
        self.heard: list[dict[str, float]] = []
        self.said: list[dict[str, float]] = []
        self.resets = 0
        self.situation = "rising"

    def __call__(self, state: float) -> dict[str, float]:
        self.said.append({"speed": 0.5})
        return self.said[-1]

    def executed(self, command: dict[str, float]) -> None:
        self.heard.append(command)

    def reset(self) -> None:
        self.resets += 1


def test_it_hears_what_was_executed_in_its_own_type_before_the_next_command() -> None:
    pid = Pid()
    loop = ts.wrap(pid, action=DRIVE)
    loop.step(0.0)
    assert [] == pid.heard
    loop.step(0.0)
    assert [{"speed": pytest.approx(0.55)}] == pid.heard


def test_it_hears_its_own_object_where_nothing_was_amplified() -> None:
    pid = Pid()
    loop = ts.wrap(pid, action=DRIVE, student="silent", amplifier="never")
    loop.step(0.0)
    loop.step(0.0)
    assert pid.said[0] is pid.heard[0]


def test_it_hears_what_somebody_else_executed() -> None:
    pid = Pid()
    loop = ts.wrap(pid, action=DRIVE)
    loop.step(0.0)
    loop.executed({"speed": 0.1})
    loop.step(0.0)
    assert [{"speed": 0.1}] == pid.heard


def test_an_own_action_class_is_heard_as_it_is() -> None:
    class Heater:
        heard: Any = None

        def __call__(self, state: float) -> Any:
            return UNIT(value=0.5)

        def executed(self, command: Any) -> None:
            self.heard = command

    heater = Heater()
    loop = ts.wrap(heater, action=UNIT)
    loop.step(0.0)
    loop.step(0.0)
    assert UNIT(value=0.5 + 0.5 * 0.1) == heater.heard


def test_it_is_reset_with_the_engine_and_not_before() -> None:
    pid = Pid()
    loop = ts.wrap(pid, action=DRIVE)
    loop.step(0.0)
    assert 0 == pid.resets
    loop.engine.reset()
    assert 1 == pid.resets


def test_its_situation_goes_with_every_decision() -> None:
    pid = Pid()
    loop = ts.wrap(pid, action=DRIVE)
    loop.step(0.0)
    assert "rising" == loop.engine.pending.moment.situation  # type: ignore[union-attr]
    pid.situation = "holding"
    loop.step(0.0)
    assert "holding" == loop.engine.pending.moment.situation  # type: ignore[union-attr]


class Namesake:
    """Has attributes of these names that mean something else."""

    executed: Any = (1, 2)
    reset: Any = False

    def situation(self) -> str:
        return "asked for"

    def __call__(self, state: float) -> float:
        return 0.5


def test_attributes_that_only_have_these_names_are_left_alone() -> None:
    loop = ts.wrap(Namesake(), action=UNIT, on_incident="raise", student={"use": "constant", "level": 2})
    assert pytest.approx([0.55, 0.6]) == [loop.step(0.0), loop.step(0.0)]
    loop.engine.reset()
    assert pytest.approx(0.55) == loop.step(0.0)
    assert "" == loop.engine.pending.moment.situation  # type: ignore[union-attr]


def test_only_a_controller_that_hears_is_told() -> None:
    assert FunctionTutor is type(ts.wrap(lambda _: 0.5, action=UNIT).engine.tutor)
    assert FunctionTutor is type(ts.wrap(Namesake(), action=UNIT).engine.tutor)
    assert HearingTutor is type(ts.wrap(Pid(), action=DRIVE).engine.tutor)


def test_what_its_executed_raises_reaches_the_owner() -> None:
    class Deaf(Pid):
        def executed(self, command: Any) -> None:
            raise RuntimeError("valve stuck")

    loop = ts.wrap(Deaf(), action=DRIVE)
    loop.step(0.0)
    with pytest.raises(RuntimeError, match="valve stuck"):
        loop.step(0.0)
