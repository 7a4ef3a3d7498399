"""With a silent student and a `never` amplifier the tutor is alone (the behaviour contract, 5)."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tests.core.oracle.lies import Fatal
from tests.core.oracle.scripted import KindStudent, LevelStudent, Says, ScriptedTutor, engine
from tests.core.oracle.shapes import Flight, Oven, Valve
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.proposals import KindProposal
from tutorstudent.plugins.controls import Silent
from tutorstudent.plugins.selectors import SameKind
from tutorstudent.sims.pioneer.types import DriveAction


class Integrator(Tutor[Any, Any]):
    """A controller with a memory of its inputs, in the numbers that it is given."""

    name = "integrator"
    action: type[Action] = Valve

    def setup(self) -> None:
        self.sum: Any = 0.0
        self.said: list[Any] = []

    def act(self, state: Any) -> Any:
        self.sum = self.sum * 0.9 + state * 0.1
        self.said.append(self._say(self.sum))
        return self.said[-1]

    def _say(self, value: Any) -> Any:
        return Valve(opening=value)


class Driver(Integrator):
    """Alternates between kinds."""

    name = "driver"
    action = DriveAction

    def setup(self) -> None:
        super().setup()
        self._kinds = itertools.cycle(["forward", "left", "stop", "backward", "right"])

    def _say(self, value: Any) -> Any:
        return DriveAction(kind=next(self._kinds), translation=value, rotation=-value)


class Pilot(Integrator):
    """Commands a vector."""

    name = "pilot"
    action = Flight

    def _say(self, value: Any) -> Any:
        return Flight(kind="cruise", forward_mps=value, left_mps=-value / 2, up_mps=value * 0)


class Cook(Integrator):
    """Keeps returning one and the same object until its memory changes much."""

    name = "cook"
    action = Oven

    def _say(self, value: Any) -> Any:
        kept = self.said[-1] if self.said else None
        fresh = Oven(kind="hold", power=40.0 + round(float(value)), fan=2.0)
        return kept if kept == fresh else fresh


TUTORS: list[Callable[[], Integrator]] = [Integrator, Driver, Pilot, Cook]


@pytest.mark.parametrize("number", [float, np.float64, np.float32], ids=["float", "float64", "float32"])
@pytest.mark.parametrize("tutor", TUTORS, ids=[str(tutor.name) for tutor in TUTORS])
@pytest.mark.parametrize("limits", ["none", "slew"])
def test_the_stream_of_actions_is_the_tutors_own_objects(tutor: Any, number: Any, limits: str) -> None:
    wrapped, alone = tutor(), tutor()
    alone.setup()
    tight = Limits(cap=0.1, factor=1.0, slew=1) if limits == "slew" else None
    loop = engine(len, Silent(), tutor=wrapped, limits=tight, on_incident="raise")
    inputs = [number(np.sin(k)) for k in range(200)]
    executed = [loop.step(state) for state in inputs]
    expected = [alone.act(state) for state in inputs]
    assert all(one is other for one, other in zip(wrapped.said, executed, strict=True))
    assert [action.model_dump() for action in expected] == [action.model_dump() for action in executed]
    assert [repr(action) for action in expected] == [repr(action) for action in executed]


def _failing(number: int) -> Callable[[Any], Any]:
    calls = itertools.count()
    errors = (ValueError, SystemExit, Fatal)

    def fail(argument: Any) -> Any:
        call = next(calls)
        if call % number:
            raise errors[call % 3]("hostile")
        return None

    return fail


@pytest.mark.parametrize("number", [1, 2, 3])
def test_the_tutor_is_asked_exactly_once_per_decision_in_order_whatever_the_others_do(number: int) -> None:
    tutor = ScriptedTutor(act=lambda state: DriveAction(kind="left", rotation=0.2))
    conditions = [Says(violated=_failing(number), label="a"), Says(violated=_failing(number + 1), label="b")]
    loop = engine(len, LevelStudent(propose=_failing(number)), tutor=tutor, conditions=conditions)
    for state in range(50):
        loop.step(state)
        if state % 7 == 0:
            loop.reset()
    assert list(range(50)) == tutor.asked


def test_a_student_that_is_never_heard_leaves_the_tutors_object_too() -> None:
    other = KindStudent(propose=lambda moment: KindProposal(kind="right", level=7, ampbit=True))
    action = DriveAction(kind="left", rotation=0.2)
    loop = engine(lambda state: action, other, selector=SameKind())  # type: ignore[arg-type]
    assert all(loop.step(state) is action for state in range(10))
