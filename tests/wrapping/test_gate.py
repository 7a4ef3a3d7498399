"""The last gate: whatever the owner's types do, what leaves keeps the limits, or the controller's own object leaves."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest
from pydantic import BaseModel, field_validator

import tutorstudent as ts

FACTOR = 1.3
ALWAYS = {"student": {"use": "constant", "level": 8}, "amplifier": {"use": "never", "change": "multiplicative"}}


def commands(controller: Callable[[Any], Any], action: Any, decisions: int = 4, **others: Any) -> tuple[list[Any], Any]:
    """Return what an owner receives from a student that always wants more, and the loop."""
    loop = ts.wrap(controller, action=action, slew=None, **(ALWAYS | others))
    return [loop.step(0.0) for _ in range(decisions)], loop


@pytest.mark.parametrize("value", [1e-300, 1e-9, 0.5, 3e8])
@pytest.mark.parametrize("bound", [1.0, 1e9])
def test_factor_holds_at_any_magnitude_whatever_the_bounds(value: float, bound: float) -> None:
    if value > bound:
        return
    received, _ = commands(lambda _: value, ts.scalar(-bound, bound))
    assert all(value < number <= FACTOR * value * (1 + 1e-9) or number == bound for number in received)


@pytest.mark.parametrize(
    ("command", "high"),
    [(np.float16(60000), 1e5), (np.float32(0.09), 0.1), (np.float16(0.1), 1.0), (np.float32(1e38), 3e38)],
    ids=str,
)
def test_a_number_of_the_owners_precision_stays_within_bounds_and_factor(command: Any, high: float) -> None:
    received, loop = commands(lambda _: command, ts.scalar(-high, high))
    for number in received:
        assert type(number) is type(command)
        assert float(command) < float(number) <= min(high, FACTOR * float(command) * (1 + 1e-9))
    assert {} == loop.engine.incident_counts


@pytest.mark.parametrize("dtype", [np.float16, np.float32, np.float64])
def test_an_array_of_the_owners_precision_stays_within_bounds_and_factor(dtype: Any) -> None:
    own = np.array([0.09, -0.05, 0.0], dtype=dtype)
    received, loop = commands(lambda _: own.copy(), ts.vector(-0.1, 0.1, 3))
    for array in received:
        assert array.dtype == own.dtype
        assert (np.abs(array.astype(float)) <= 0.1).all()
        assert (np.abs(array.astype(float)) <= FACTOR * np.abs(own.astype(float)) * (1 + 1e-9)).all()
    assert {} == loop.engine.incident_counts


class Scaling:
    """A setter that halves."""

    def __init__(self) -> None:
        self._speed = 0.4

    @property
    def speed(self) -> float:
        return self._speed

    @speed.setter
    def speed(self, value: float) -> None:
        self._speed = value * self.factor

    factor = 0.5


class Doubling(Scaling):
    factor = 2.0


@dataclasses.dataclass
class DoublesWhenMade:
    speed: float
    made: int = 0

    def __post_init__(self) -> None:
        self.made += 1
        if self.made > 1:
            self.speed *= 2


class ScalesWhenMade(float):
    def __new__(cls, value: float = 0.0) -> ScalesWhenMade:
        return super().__new__(cls, value * 3)


class Counts(BaseModel):
    speed: float
    made: int = 0


@dataclasses.dataclass
class ForgetsWhenMade:
    speed: float
    mode: list[str]

    def __post_init__(self) -> None:
        self.mode = [] if self.speed > 0.4 else self.mode


def once(_: Any) -> Any:
    return OWN[0]


OWN: list[Any] = [None]
SPEED = ts.scalar(-1, 1, name="speed")
BROKEN: dict[str, tuple[Callable[[], Any], Any, str]] = {
    "a setter that halves": (Scaling, SPEED, "says speed = 0.26"),
    "a setter that doubles": (Doubling, SPEED, "says speed = 1.04"),
    "a dataclass that doubles when it is made": (lambda: DoublesWhenMade(0.4), SPEED, "says speed"),
    "a dataclass that forgets another field": (lambda: ForgetsWhenMade(0.4, ["eco"]), SPEED, "'mode'"),
    "write= that returns NaN": (
        lambda: 0.4,
        ts.scalar(-1, 1, read=float, write=lambda _, v: v if v == 0.4 else float("nan")),
        "says value = nan",
    ),
    "write= that returns a word": (
        lambda: 0.4,
        ts.scalar(-1, 1, read=lambda c: c if isinstance(c, float) else None, write=lambda _, v: "9999"),
        "read= returned nothing",
    ),
    "write= that turns round": (
        lambda: 0.4,
        ts.scalar(-1, 1, read=float, write=lambda _, v: -v),
        "says value = -0.52",
    ),
    "write= that raises SystemExit": (
        lambda: 0.4,
        ts.scalar(-1, 1, read=float, write=lambda c, v: exec("raise SystemExit(1)") if v > 0.4 else v),
        "SystemExit",
    ),
}


@pytest.mark.parametrize("case", BROKEN)
def test_a_command_that_does_not_hold_is_replaced_by_the_controllers_own_object(case: str) -> None:
    make, action, message = BROKEN[case]
    OWN[0] = make()
    received, loop = commands(once, action)
    assert all(command is OWN[0] for command in received)
    assert 4 == sum(loop.engine.incident_counts.values())
    assert all("action" == incident.part for incident in loop.engine.incidents)
    assert message in loop.engine.incidents[-1].message
    assert 0 == loop.engine.pending.resulting.level


def test_a_float_that_scales_when_it_is_made_is_replaced_by_the_controllers_own() -> None:
    own = ScalesWhenMade(0.1)
    received, loop = commands(lambda _: own, ts.scalar(-1, 1))
    assert all(number is own for number in received)
    assert 4 == loop.engine.incident_counts["action", "out-of-bounds"]


def test_an_object_whose_copy_is_itself_is_refused_at_once_and_unchanged() -> None:
    class Same:
        def __init__(self) -> None:
            self.speed = 0.4

        def __copy__(self) -> Same:
            return self

    own = Same()
    with pytest.raises(ts.ContractError, match="its copy is the object itself"):
        commands(lambda _: own, SPEED)
    assert 0.4 == own.speed


def test_a_write_that_changes_the_controllers_own_command_is_undone() -> None:
    own = SimpleNamespace(speed=0.4)

    def write(command: Any, speed: float) -> Any:
        command.speed = speed
        return command

    received, loop = commands(lambda _: own, ts.scalar(-1, 1, read=lambda c: c.speed, write=write), decisions=8)
    assert 0.4 == own.speed
    assert all(command is own for command in received)
    assert 8 == loop.engine.incident_counts["action", "mutated"]


def test_what_a_quantizing_command_really_says_is_what_is_taught() -> None:
    def write(_: Any, value: float) -> float:
        return int(value * 100) / 100  # towards the controller's own

    received, loop = commands(lambda _: 0.4, ts.scalar(-1, 1, read=float, write=write), conditions=[lambda y: False])
    assert [0.52] * 4 == received
    steps = [0.04, 0.08, 0.12]
    assert 3 == len(steps) == loop.engine.pending.resulting.level
    slow, loop = commands(lambda _: 0.15, ts.scalar(-1, 1, read=float, write=write))
    assert [0.19] * 4 == slow
    assert 0.19 == loop.engine.pending.executed.value
    assert 2 == loop.engine.pending.resulting.level


@pytest.mark.parametrize("number", [Decimal("0.4"), Fraction(2, 5), 0.4, np.float64(0.4), np.float32(0.4)], ids=repr)
def test_sound_types_pass_without_a_word(number: Any) -> None:
    received, loop = commands(lambda _: number, ts.scalar(-1, 1))
    assert {} == loop.engine.incident_counts
    assert all(type(found) is type(number) and float(number) < float(found) <= 0.52 for found in received)


def test_a_logging_handler_that_raises_costs_nothing(caplog: pytest.LogCaptureFixture) -> None:
    import logging

    class Raising(logging.Handler):
        def handle(self, record: logging.LogRecord) -> bool:
            raise SystemExit(1)

    logger, handler = logging.getLogger("tutorstudent"), Raising()
    logger.addHandler(handler)
    try:
        OWN[0] = Scaling()
        received, _ = commands(once, SPEED)
    finally:
        logger.removeHandler(handler)
    assert all(command is OWN[0] for command in received)


class Degrees(BaseModel):
    """A validator that is not idempotent."""

    speed: float
    heading: float

    @field_validator("heading")
    @classmethod
    def _in_radians(cls, value: float) -> float:
        return value / 57.3


def test_a_model_whose_validator_is_not_idempotent_keeps_what_is_not_declared() -> None:
    own = Degrees(speed=0.4, heading=90.0)
    received, _ = commands(lambda _: own, SPEED)
    assert all(own.heading == command.heading for command in received)


class Track(list[float]):
    """A list of its own class."""


class Duo(tuple[float, ...]):
    """A tuple of its own class, without names."""


@pytest.mark.parametrize("own", [Track([0.4, 0.2]), Duo((0.4, 0.2))], ids=repr)
def test_subclasses_of_list_and_tuple_keep_their_class(own: Any) -> None:
    received, loop = commands(lambda _: own, ts.vector(-1, 1, 2))
    assert all(type(found) is type(own) and found[0] > 0.4 for found in received)
    assert {} == loop.engine.incident_counts


class Private:
    """A number that is a property over a private attribute, as messages of ROS 2 are."""

    def __init__(self, x: float) -> None:
        self._x = x
        self._frame = "base"

    @property
    def x(self) -> float:
        return self._x

    @x.setter
    def x(self, value: float) -> None:
        self._x = value


def test_a_property_over_a_private_attribute_is_amplified() -> None:
    received, loop = commands(lambda _: Private(0.4), ts.scalar(-1, 1, name="x"))
    assert [pytest.approx(0.52)] * 4 == [found.x for found in received]
    assert {} == loop.engine.incident_counts


@pytest.mark.parametrize("raises", [False, True])
def test_a_write_that_spoils_the_controllers_own_is_undone_whatever_it_returns(raises: bool) -> None:
    own = SimpleNamespace(speed=0.4, gears=[1, 2], inner=SimpleNamespace(mode="eco"))

    def write(command: Any, speed: float) -> Any:
        if speed != 0.4:
            command.speed, command.inner.mode = 9999.0, "sport"
            command.gears.append(3)
            command.extra = 1
            if raises:
                raise ValueError("too late")
        return SimpleNamespace(speed=speed)

    received, loop = commands(lambda _: own, ts.scalar(-1, 1, read=lambda c: c.speed, write=write))
    assert all(found is own for found in received)
    assert SimpleNamespace(speed=0.4, gears=[1, 2], inner=SimpleNamespace(mode="eco")) == own
    assert 4 == sum(loop.engine.incident_counts.values())


class Hearing:
    """A controller that hears, and whose commands can be written once only."""

    def __init__(self) -> None:
        self.heard: list[Any] = []

    def __call__(self, state: Any) -> float:
        return 0.4

    def executed(self, command: Any) -> None:
        self.heard.append(command)


def test_a_controller_hears_the_very_command_that_left() -> None:
    written: list[Any] = []

    class Number(float):
        pass

    def write(_: Any, value: float) -> Any:
        written.append(Number(value))
        return written[-1]

    controller = Hearing()
    loop = ts.wrap(controller, action=ts.scalar(-1, 1, read=float, write=write), slew=None, **ALWAYS)
    received = [loop.step(0.0) for _ in range(3)]
    assert [id(command) for command in received[:2]] == [id(command) for command in controller.heard]
    loop.executed(0.45)
    loop.step(0.0)
    assert 0.45 == controller.heard[-1]


class Makes(NamedTuple):
    """A named tuple, below whose own `_make` is wrong."""

    left: float
    right: float


class MakesAnother(Makes):
    @classmethod
    def _make(cls, items: Any) -> Any:
        return tuple(items)


def test_a_tuple_that_is_made_as_another_type_is_replaced_by_the_controllers_own() -> None:
    own = MakesAnother(0.4, 0.2)
    received, loop = commands(lambda _: own, ts.vector(-1, 1, 2))
    assert all(found is own for found in received)
    assert {("action", "mutated"): 4} == loop.engine.incident_counts


class DoublesBeyond(ts.Action):
    """A validator that doubles the amplified component beyond 0.4."""

    speed: float = ts.component(-2.0, 2.0)
    amplification = {"command": {"speed": "outward"}}

    @field_validator("speed")
    @classmethod
    def _double(cls, value: float) -> float:
        return value if value <= 0.4 else 2 * value


def test_an_action_class_that_changes_the_amplified_component_is_replaced_by_the_controllers_own() -> None:
    own = DoublesBeyond(speed=0.4)
    received, loop = commands(lambda _: own, DoublesBeyond)
    assert all(found is own for found in received)
    assert {("action", "mutated"): 4} == loop.engine.incident_counts


def test_an_emergency_action_that_is_written_as_something_else_does_not_leave() -> None:
    def pid(y: float) -> float:
        if y:
            raise RuntimeError("sensor")
        return 0.4

    written: list[float] = []

    def write(_: Any, value: float) -> float:
        written.append(value)
        return value if len(written) == 1 else float("nan")

    action = ts.scalar(-1, 1, read=float, write=write)
    loop = ts.wrap(pid, action=action, on_tutor_failure={"kind": "command", "value": 0.1}, student="silent")
    assert 0.4 == loop.step(0)
    with pytest.raises(ts.ContractError, match="on_tutor_failure: the action cannot be written: .* says value = nan"):
        loop.step(1)


def test_the_first_look_at_a_command_leaves_it_as_it_was() -> None:
    own = SimpleNamespace(speed=0.4, mode="eco")

    def write(command: Any, speed: float) -> Any:
        command.mode = "sport"
        return SimpleNamespace(speed=speed, mode="eco")

    loop = ts.wrap(lambda _: own, action=ts.scalar(-1, 1, read=lambda c: c.speed, write=write), student="silent")
    assert loop.step(0.0) is own
    assert "eco" == own.mode


@pytest.mark.parametrize("own", [np.float16(6e-8), np.float16(1000.0)])
def test_a_level_that_the_owners_precision_swallows_is_level_0(own: Any) -> None:
    student = {"use": "constant", "level": 1}
    loop = ts.wrap(
        lambda state: own, action=ts.scalar(-1e5, 1e5), student=student, amplifier={"use": "never", "amount": 1e-4}
    )
    assert own == loop.step(0.0)
    assert 0 == loop.engine.pending.resulting.level
    loop.step(0.0)
    assert "executed" == loop.engine.last.limited_by
    assert not loop.engine.incidents
