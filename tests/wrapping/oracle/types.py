"""Command types of owners: ordinary ones that ask the hand before they write, so that they can be made faulty."""

from __future__ import annotations

import copy
from collections import OrderedDict
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from pydantic import BaseModel, ConfigDict

from tests.wrapping.oracle.meddling import HAND


class Elastic(float):
    """A float that is made anew by its class."""

    def __new__(cls, value: Any = 0.0) -> Elastic:
        return super().__new__(cls, HAND.number(value))


class Pair(NamedTuple):
    """Two numbers by name."""

    turn: float
    speed: float


class Triple(NamedTuple):
    """Two numbers by name, and a word."""

    speed: float
    mode: str
    turn: float


class Makes(Pair):
    """A named tuple that is made by a function of its own."""

    __slots__ = ()

    @classmethod
    def _make(cls, items: Any) -> Any:
        return HAND.whole(super()._make(items))


class Track(list[Any]):
    """A list of its own class."""


class Duo(tuple[Any, ...]):
    """A tuple of its own class."""

    __slots__ = ()


@dataclass
class Move:
    """A dataclass that works over its numbers when it is made."""

    speed: Any
    turn: Any
    mode: str = "eco"
    path: list[float] = field(default_factory=lambda: [1.0, 2.0])

    def __post_init__(self) -> None:
        self.speed = HAND.number(self.speed)


@dataclass(frozen=True, slots=True, kw_only=True)
class Still:
    """A frozen one without a dictionary."""

    speed: Any
    turn: Any
    gear: int = 2
    weight: float = -0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "turn", HAND.number(self.turn))


class Box(dict[str, Any]):
    """A mapping that works over what is put into it, and is copied in its own way."""

    def __setitem__(self, key: str, value: Any) -> None:
        super().__setitem__(key, HAND.number(value))

    def __copy__(self) -> Any:
        made = type(self)()
        dict.update(made, self)
        return HAND.whole(made)


class Order(OrderedDict[str, Any]):
    """An ordered mapping."""


class Model(BaseModel):
    """A pydantic model with values of its own beside the numbers."""

    model_config = ConfigDict(extra="allow")
    speed: Any
    turn: Any = 0.25
    tags: dict[str, float] = {"a": 0.1}
    _private: int = 3

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Any:
        worked = {key: HAND.number(value) for key, value in (update or {}).items()}
        return HAND.whole(super().model_copy(update=worked, deep=deep))


class Frozen(BaseModel):
    """A frozen model whose numbers have defaults."""

    model_config = ConfigDict(frozen=True)
    speed: float = 0.5
    turn: float = 0.25
    label: str = "frozen"


class Axes:
    """Three numbers, one of which works over what it is set to."""

    def __init__(self, x: Any, y: Any = 0.7, z: Any = -0.7) -> None:
        self._x, self.y, self.z = x, y, z

    @property
    def x(self) -> Any:
        return self._x

    @x.setter
    def x(self, value: Any) -> None:
        self._x = HAND.number(value)


class Point:
    """Two numbers of which every one that is set is worked over."""

    def __init__(self, x: Any, z: Any = -0.7) -> None:
        self.__dict__.update(x=x, z=z)

    def __setattr__(self, name: str, value: Any) -> None:
        super().__setattr__(name, HAND.number(value))


class Twist:
    """A command of objects in objects."""

    def __init__(self, linear: Axes, angular: Axes) -> None:
        self.linear, self.angular = linear, angular
        self.frame, self.stamps = "base", [0.5, 1.5]

    def __copy__(self) -> Any:
        made = object.__new__(type(self))
        made.__dict__.update(self.__dict__)
        return HAND.whole(made)


class Slotted:
    """An object without a dictionary, with a part that may be missing."""

    __slots__ = ("note", "speed", "turn")

    def __init__(self, speed: Any, turn: Any) -> None:
        self.speed, self.turn = speed, turn


class Lean:
    """An object whose number is a property over a slot."""

    __slots__ = ("_speed", "note")

    def __init__(self, speed: Any) -> None:
        self._speed, self.note = speed, "lean"

    @property
    def speed(self) -> Any:
        return self._speed

    @speed.setter
    def speed(self, value: Any) -> None:
        self._speed = HAND.number(value)


class Message:
    """A command that only functions can read and write."""

    def __init__(self, numbers: list[float]) -> None:
        self.numbers, self.words = list(numbers), ["go"]


def read_message(message: Message) -> list[float]:
    return message.numbers


def write_message(message: Message | None, numbers: list[float]) -> Any:
    made = Message([HAND.number(number) for number in numbers])
    if message is not None:
        made.words = copy.copy(message.words)
    return HAND.whole(made)


def read_text(text: str) -> float:
    return float(text.removeprefix("speed="))


def write_text(text: str | None, number: float) -> Any:
    return HAND.whole(f"speed={HAND.number(number)!r}")


def write_rounded(text: str | None, number: float) -> Any:
    return HAND.whole(f"speed={HAND.number(number):.3f}")
