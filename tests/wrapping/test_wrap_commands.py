"""The owner's own commands, whatever their type, go through `wrap`; the owner's object is never changed."""

from __future__ import annotations

import collections
import dataclasses
import re
from decimal import Decimal
from fractions import Fraction
from types import MappingProxyType, SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pydantic
import pytest

import tutorstudent as ts
from tutorstudent.core.words.forms import SEQUENCES, SequenceType, match_type

SPEED = ts.scalar(-1, 1, name="speed")
DRIVE = ts.vector(-1, 1, names=["speed", "turn"])


@dataclasses.dataclass
class Plain:
    speed: Any
    turn: Any
    note: str = "keep me"


@dataclasses.dataclass(frozen=True, slots=True)
class Frozen:
    speed: float
    turn: float
    note: str = "keep me"


class Model(pydantic.BaseModel, frozen=True):
    speed: float
    turn: float
    note: str = "keep me"


class Slots:
    __slots__ = ("note", "speed", "turn")

    def __init__(self, speed: float, turn: float) -> None:
        self.speed, self.turn, self.note = speed, turn, "keep me"


class Pair(NamedTuple):
    turn: float
    speed: float
    note: str = "keep me"


class Replaced:
    """Knows how to copy itself, as `copy.replace` has it, and refuses to be changed."""

    def __init__(self, speed: float, turn: float, note: str = "keep me") -> None:
        self.__dict__.update(speed=speed, turn=turn, note=note)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("cannot be changed")

    def __replace__(self, **changes: Any) -> Replaced:
        return Replaced(**(vars(self) | changes))


OBJECTS = [
    Plain(0.3, 0.4),
    Frozen(0.3, 0.4),
    Model(speed=0.3, turn=0.4),
    Slots(0.3, 0.4),
    Pair(speed=0.3, turn=0.4),
    Replaced(0.3, 0.4),
    SimpleNamespace(speed=0.3, turn=0.4, note="keep me"),
]


def once(command: Any, action: Any, **slots: Any) -> Any:
    """Return what the loop makes of one command in its first decision: a tenth more."""
    return ts.wrap(lambda _: command, action=action, on_incident="raise", **slots).step(0.0)


@pytest.mark.parametrize("command", OBJECTS, ids=lambda command: type(command).__name__)
def test_an_object_comes_back_as_a_copy_with_the_named_numbers_changed(command: Any) -> None:
    found = once(command, DRIVE)
    assert (type(command), "keep me") == (type(found), found.note)
    assert pytest.approx((0.33, 0.44)) == (found.speed, found.turn)
    assert (0.3, 0.4) == (command.speed, command.turn)


@pytest.mark.parametrize("command", OBJECTS, ids=lambda command: type(command).__name__)
def test_one_number_of_an_object_is_amplified_alone(command: Any) -> None:
    found = once(command, SPEED)
    assert (pytest.approx(0.33), 0.4) == (found.speed, found.turn)


@pytest.mark.parametrize("make", [dict, collections.OrderedDict, collections.UserDict])
def test_a_mapping_comes_back_as_one(make: Any) -> None:
    command = make({"speed": 0.3, "turn": 0.4, "note": "keep me"})
    found = once(command, DRIVE)
    assert (type(command), "keep me") == (type(found), found["note"])
    assert pytest.approx((0.33, 0.44)) == (found["speed"], found["turn"])
    assert {"speed": 0.3, "turn": 0.4, "note": "keep me"} == dict(command)


def twist(x: float, z: float) -> Any:
    """A command as ROS has it: two vectors in one object."""
    return SimpleNamespace(
        linear=SimpleNamespace(x=x, y=0.0, z=0.0), angular=SimpleNamespace(x=0.0, y=0.0, z=z), frame="base"
    )


def test_numbers_that_lie_deeper_are_named_with_dots() -> None:
    command = twist(0.3, 0.4)
    found = once(command, ts.vector(-1, 1, names=["linear.x", "angular.z"]))
    assert pytest.approx((0.33, 0.44)) == (found.linear.x, found.angular.z)
    assert (0.0, 0.0, "base") == (found.linear.y, found.angular.y, found.frame)
    assert twist(0.3, 0.4) == command


def test_objects_and_mappings_may_lie_in_one_another() -> None:
    command = {"wheels": Frozen(0.3, 0.4), "arm": {"speed": 0.0}}
    found = once(command, ts.vector(-1, 1, names=["wheels.speed", "wheels.turn", "arm.speed"]))
    assert {"wheels": Frozen(pytest.approx(0.33), pytest.approx(0.44)), "arm": {"speed": 0.0}} == found
    assert {"wheels": Frozen(0.3, 0.4), "arm": {"speed": 0.0}} == command


@pytest.mark.parametrize("number", [Decimal("0.5"), Fraction(1, 2), np.float16(0.5), np.float32(0.5), np.float64(0.5)])
def test_a_number_keeps_its_type_wherever_it_stands(number: Any) -> None:
    assert type(number) is type(once(number, ts.scalar(-1, 1)))
    assert [type(number)] * 2 == [type(item) for item in once([number, number], ts.vector(-1, 1, 2))]
    assert type(number) is type(once(Plain(number, 0.0), SPEED).speed)


def test_a_decimal_is_the_short_one() -> None:
    assert (Decimal("0.55"), Fraction(11, 20)) == (
        once(Decimal("0.5"), ts.scalar(-1, 1)),
        once(Fraction(1, 2), ts.scalar(-1, 1)),
    )


def test_a_whole_number_becomes_a_float_where_it_is_amplified_and_only_there() -> None:
    found = once([3, 0], ts.vector(-10, 10, 2))
    assert ([3.3, 0], [float, int]) == (pytest.approx(found), [type(number) for number in found])
    assert (3.9, 3) == (match_type(3, 3.9), match_type(3, 3.0))


def test_what_was_really_executed_is_said_in_the_same_type() -> None:
    loop = ts.wrap(lambda _: Frozen(0.3, 0.4), action=DRIVE)
    for _ in range(4):
        loop.step(0.0)
    loop.executed(Frozen(0.33, 0.44))
    loop.step(0.0)
    assert 1 == loop.engine.last.lesson.target.level  # type: ignore[union-attr]


class Handle:
    """A command that nothing here can read: setters and getters, and no copies."""

    def __init__(self, power: float) -> None:
        self._power = power

    def get(self) -> float:
        return self._power

    def __copy__(self) -> Handle:
        raise TypeError("handles are not copied")


OWN = ts.scalar(-1, 1, read=Handle.get, write=lambda command, power: Handle(power))


def test_any_other_command_is_read_and_written_by_two_functions_of_the_owner() -> None:
    assert pytest.approx(0.33) == once(Handle(0.3), OWN).get()


def test_several_numbers_are_written_as_a_list() -> None:
    def read(text: str) -> list[float]:
        return [float(word) for word in text.strip("[]").split(",")]

    found = once("0.3,0.4", ts.vector(-1, 1, 2, read=read, write=lambda _, v: f"{v}"))
    assert [0.33, 0.44] == pytest.approx(read(found))


@pytest.mark.parametrize(
    ("command", "action", "message"),
    [
        ({"sped": 0.3}, SPEED, "dict has no 'speed' (did you mean 'sped'?); it has sped."),
        (SimpleNamespace(turn=1.0), SPEED, "SimpleNamespace has no 'speed'; it has turn."),
        (twist(0.3, 0.4), ts.scalar(-1, 1, name="linear.w"), "SimpleNamespace has no 'w'; it has x, y, z."),
        ({"speed": "fast"}, SPEED, "'speed' is 'fast', not a number."),
        ({"speed": True}, SPEED, "'speed' is true, not a number."),
        ({"speed": None}, SPEED, "'speed' is nothing, not a number."),
        ({"speed": np.zeros(1)}, SPEED, "'speed' is array([0.]), not a number."),
        ({"speed": 10**400}, SPEED, "'speed' is no finite float."),
        (Decimal("sNaN"), ts.scalar(-1, 1), "it is no finite float."),
        ({"speed": 0.3, "turn": 1.5}, DRIVE, "'turn': input should be less than or equal to 1."),
        ({"speed": float("nan"), "turn": 0.0}, DRIVE, "'speed': input should be a finite number."),
        ({"speed": 0.3}, ts.scalar(-1, 1), "expected a number. Other commands are read by their names"),
        (Handle(0.3), ts.scalar(-1, 1, read=lambda _: 1 / 0, write=max), "read= raised ZeroDivisionError: division by"),
        (Handle(0.3), ts.scalar(-1, 1, read=lambda _: None, write=max), "read= returned nothing; expected a number."),
        (
            Handle(0.3),
            ts.vector(-1, 1, 2, read=lambda _: 1.0, write=max),
            "read= returned 1.0; expected a list, tuple or numpy array of 2 numbers.",
        ),
    ],
)
def test_a_command_that_cannot_be_read_is_told_with_what_was_found(command: Any, action: Any, message: str) -> None:
    with pytest.raises(ts.ContractError, match=r"^the controller's command is .*" + re.escape(message)):
        once(command, action)


class Moody:
    @property
    def speed(self) -> float:
        raise RuntimeError("bus lost")


def test_an_attribute_that_raises_is_told_with_its_name() -> None:
    with pytest.raises(ts.ContractError, match="reading 'speed' raised RuntimeError: bus lost.") as caught:
        once(Moody(), SPEED)
    assert isinstance(caught.value.__cause__, RuntimeError)


def test_a_key_that_a_mapping_would_make_up_is_missing_and_stays_so() -> None:
    command: Any = collections.defaultdict(float, turn=0.1)
    with pytest.raises(ts.ContractError, match="defaultdict has no 'speed'"):
        once(command, SPEED)
    assert {"turn": 0.1} == command


class ReadOnly:
    speed = property(lambda self: 0.3)


class Handled(Handle):
    speed = 0.3


@pytest.mark.parametrize(
    ("command", "action", "message"),
    [
        (ReadOnly(), SPEED, "AttributeError: property 'speed' of 'ReadOnly' object has no setter"),
        (Handled(0.3), SPEED, "TypeError: handles are not copied"),
        (MappingProxyType({"speed": 0.3}), SPEED, "TypeError: cannot pickle 'mappingproxy' object"),
        (Handle(0.3), ts.scalar(-1, 1, read=Handle.get, write=lambda c, v: None), "ContractError: write= returned"),
        (Handle(0.3), ts.scalar(-1, 1, read=Handle.get, write=lambda c: c), "TypeError"),
    ],
)
def test_a_command_that_cannot_be_written_is_told_in_the_first_decision(
    command: Any, action: Any, message: str
) -> None:
    with pytest.raises(ts.ContractError, match=f"a copy with other numbers cannot be made: {re.escape(message)}"):
        once(command, action, amplifier="never")


@dataclasses.dataclass
class Limited:
    """Checks itself whenever it is made, and is stricter than the bounds that were stated."""

    speed: float

    def __post_init__(self) -> None:
        if self.speed > 0.56:
            raise ValueError("too fast")


def test_an_amplified_command_that_its_type_refuses_costs_the_amplification_and_is_an_incident() -> None:
    command = Limited(0.5)
    loop = ts.wrap(lambda _: command, action=SPEED, student={"use": "constant", "level": 2})
    assert pytest.approx(0.55) == loop.step(0.0).speed
    assert command is loop.step(0.0)
    assert {("action", "raised"): 1} == loop.engine.incident_counts
    assert "ValueError: too fast" == loop.engine.incidents[0].message
    decision = loop.engine.pending
    assert (0, 0.5) == (decision.resulting.level, decision.executed.speed)  # type: ignore[union-attr]
    assert pytest.approx(0.55) == loop.step(0.0).speed
    assert 0 == loop.engine.last.lesson.target.level  # type: ignore[union-attr]


def test_where_incidents_are_to_be_raised_a_refused_command_is() -> None:
    loop = ts.wrap(lambda _: Limited(0.5), action=SPEED, on_incident="raise", student={"use": "constant", "level": 2})
    loop.step(0.0)
    with pytest.raises(ts.ContractError, match="decision 1: action: raised: ValueError: too fast"):
        loop.step(0.0)


def test_nobody_refuses_before_there_is_a_decision() -> None:
    loop = ts.wrap(lambda _: 0.5, action=ts.scalar(-1, 1))
    with pytest.raises(ts.ContractError, match=r"refused\(\): no decision is pending"):
        loop.engine.refused(ValueError())


def test_an_old_command_is_never_executed_where_the_failure_action_cannot_be_written() -> None:
    def failing(state: float) -> Limited:
        if state:
            raise RuntimeError("sensor lost")
        return Limited(0.5)

    loop = ts.wrap(failing, action=SPEED, on_tutor_failure={"kind": "command", "speed": 0.9})
    loop.step(0.0)
    with pytest.raises(ValueError, match="too fast"):
        loop.step(1.0)


def test_a_failure_action_before_the_first_command_needs_a_write_that_takes_none() -> None:
    def failing(state: float) -> Handle:
        raise RuntimeError("sensor lost")

    with pytest.raises(ts.ContractError, match="no command yet in which 'speed' could be written; give write="):
        ts.wrap(failing, action=SPEED, on_tutor_failure={"kind": "command", "speed": 0.0}).step(0.0)
    loop = ts.wrap(failing, action=OWN, on_tutor_failure={"kind": "command", "value": 0.25})
    assert 0.25 == loop.step(0.0).get()


def test_actions_go_through_as_they_are() -> None:
    assert pytest.approx(0.55) == once(SPEED.read({"speed": 0.5}), SPEED).speed


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: ts.vector(-1, 1), "vector(): found the size 0; say how many numbers there are"),
        (lambda: ts.vector(-1, 1, 0), "vector(): found the size 0"),
        (lambda: ts.vector(-1, 1, names="speed"), "vector(): found names='speed'; expected a list of strings."),
        (lambda: ts.vector(-1, 1, names=["speed", 3]), "expected a list of strings."),
        (lambda: ts.vector(-1, 1, 3, names=["speed", "turn"]), "names speed, turn; expected 3 different ones."),
        (lambda: ts.vector(-1, 1, names=["speed", "speed"]), "names speed, speed; expected 2 different ones."),
        (lambda: ts.scalar(-1, 1, name="linear..x"), "scalar(): a number cannot be called 'linear..x' here; give read"),
        (lambda: ts.scalar(-1, 1, name=""), "a number cannot be called '' here"),
        (lambda: ts.scalar(-1, 1, name="_speed"), "a number cannot be called '_speed' here"),
        (lambda: ts.scalar(-1, 1, name="kind"), "a number cannot be called 'kind' here"),
        (lambda: ts.scalar(-1, 1, name="copy"), "a number cannot be called 'copy' here"),
        (lambda: ts.scalar(-1, 1, read=Handle.get), "write=None; give two functions, or neither."),
        (lambda: ts.scalar(-1, 1, read=Handle.get, write=3), "write=3; give two functions, or neither."),
        (lambda: ts.scalar(-1, 1, name="speed", read=Handle.get), "found names and read= or write=; either names say"),
    ],
)
def test_a_mistaken_action_is_told_with_the_remedy(make: Any, message: str) -> None:
    with pytest.raises(ts.ContractError, match=re.escape(message)):
        make()


def test_a_subclass_of_a_command_reads_a_number_for_each_of_its_own_components() -> None:
    class Wider(ts.vector(-1, 1, 2)):  # type: ignore[misc]
        x2: float = ts.component(-1, 1, default=0.0)

    class Renamed(ts.vector(-1, 1, names=["speed", "turn"])):  # type: ignore[misc]
        pass

    assert [0.1, 0.2, 0.3] == Wider.read([0.1, 0.2, 0.3]).write([0.0, 0.0, 0.0])
    assert {"speed": 0.1, "turn": 0.2, "lamp": 1} == Renamed.read({"speed": 0.1, "turn": 0.2}).write(
        {"speed": 0.0, "turn": 0.0, "lamp": 1}
    )


class Wheels(collections.UserList[float]):
    """A sequence that is no list."""


def test_another_type_of_sequences_is_a_line_in_a_table(monkeypatch: pytest.MonkeyPatch) -> None:
    action = ts.vector(-1, 1, 2)
    with pytest.raises(ts.ContractError, match="expected a list, tuple or numpy array of 2 numbers"):
        action.read(Wheels([0.3, 0.4]))
    monkeypatch.setitem(SEQUENCES, Wheels, SequenceType("pair of wheels", list, lambda like, numbers: Wheels(numbers)))
    own = Wheels([0.3, 0.4])
    loop = ts.wrap(lambda state: own, action=action)
    written = loop.step(0.0)
    assert (Wheels, [0.33, 0.44], [0.3, 0.4]) == (type(written), pytest.approx(written.data), own.data)
    assert not loop.engine.incidents
    with pytest.raises(ts.ContractError, match="expected a list, tuple, numpy array or pair of wheels of 2 numbers"):
        action.read("fast")
