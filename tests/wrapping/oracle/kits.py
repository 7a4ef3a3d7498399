"""Every form of command that an owner may have: how it is declared, made and read, written down by hand."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import partial
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

import tutorstudent as ts
from tests.wrapping.oracle import types as own
from tests.wrapping.oracle.imprint import Paths

Make = Callable[[Sequence[float]], Any]
Read = Callable[[Any], Sequence[Any]]


class Kit(NamedTuple):
    """A form of command."""

    name: str
    size: int
    make: Make
    read: Read
    how: dict[str, Any]
    """How it is declared to the package, beside its bounds."""
    skipped: Paths = ()
    """Where the declared numbers stand."""
    exact: bool = True
    """Whether all that is not declared has to stay, and the type; what `write=` makes of it is the owner's own word."""
    fixed: bool = True
    """Whether the numbers keep their type; an amplified whole number becomes a float."""
    grain: float = 0.0
    """What its own way of writing may add or take, where it rounds."""


def scalar(kind: Callable[[float], Any], name: str = "", fixed: bool = True) -> Kit:
    return Kit(name or kind.__name__, 1, lambda v: kind(v[0]), lambda c: [c], {}, ((),), fixed=fixed)


def sequence(name: str, make: Make, size: int = 3, fixed: bool = True) -> Kit:
    places = tuple((i,) for i in range(size))
    return Kit(name, size, make, list, {}, places, fixed=fixed)


def array(dtype: str, shape: tuple[int, ...] = (3,), order: str = "C") -> Kit:
    def make(values: Sequence[float]) -> Any:
        return np.array(values).astype(dtype).reshape(shape, order=order)

    size = int(np.prod(shape))
    name = f"array {dtype} {shape} {order}"
    return Kit(name, size, make, lambda c: list(c.ravel()), {}, (), fixed="i" not in dtype)


def named(name: str, make: Make, *paths: str, fixed: bool = True) -> Kit:
    steps = tuple(tuple(path.split(".")) for path in paths)

    def read(command: Any) -> list[Any]:
        return [_get(command, path) for path in steps]

    how = {"names": list(paths)} if len(paths) > 1 else {"name": paths[0]}
    return Kit(name, len(paths), make, read, how, steps, fixed=fixed)


def _get(command: Any, path: Sequence[str]) -> Any:
    for step in path:
        command = command[step] if isinstance(command, dict) else getattr(command, step)
    return command


def _functions(name: str, size: int, make: Make, read: Any, write: Any) -> Kit:
    several = read if size > 1 else lambda command: [read(command)]
    return Kit(name, size, make, several, {"read": read, "write": write}, exact=False)


BOTH = ("speed", "turn")
SCALARS = [
    *(scalar(kind) for kind in (float, Decimal, Fraction, np.float16, np.float32, np.float64, own.Elastic)),
    scalar(lambda v: Decimal(repr(v)) * Decimal("1.00000000000000000000001"), "long Decimal"),
    scalar(int, fixed=False),
    scalar(np.int64, fixed=False),
]
SEQUENCES = [
    sequence("list", list),
    sequence("tuple", tuple),
    sequence("mixed", lambda v: [v[0], np.float32(v[1]), Decimal(v[2])]),
    sequence("whole numbers", lambda v: [int(v[0]), v[1], v[2]], fixed=False),
    sequence("Pair", lambda v: own.Pair(*v), 2)._replace(skipped=(("turn",), ("speed",))),
    *(array(dtype) for dtype in ("float16", "float32", "float64", "longdouble", ">f4", "int32", "uint8")),
    Kit("array without axes", 1, lambda v: np.array(v[0]), lambda c: [c[()]], {}),
    sequence("list of one", list, 1),
    array("float64", (2, 2)),
    array("float32", (2, 2), "F"),
    array("float32", (1, 3)),
]
NAMED = [
    named("namedtuple with a word", lambda v: own.Triple(v[0], "eco", v[1]), *BOTH),
    named("dataclass", lambda v: own.Move(*v), *BOTH),
    named("dataclass, float32", lambda v: own.Move(*map(np.float32, v)), *BOTH),
    named("dataclass, one number", lambda v: own.Move(v[0], 0.3), "speed"),
    named("frozen dataclass", lambda v: own.Still(speed=v[0], turn=Decimal(v[1])), *BOTH),
    named("dict", lambda v: {"speed": v[0], "mode": "eco", "turn": v[1], "list": [-0.0]}, *BOTH),
    named("dict in dict", lambda v: {"a": {"b": v[0], "c": 1.5}, "d": v[1]}, "a.b", "d"),
    named("dict subclass", lambda v: own.Box(speed=v[0], turn=v[1], mode="eco"), *BOTH),
    named("ordered dict", lambda v: own.Order(speed=np.float32(v[0]), mode="eco", turn=v[1]), *BOTH),
    named("default dict", lambda v: defaultdict(list, speed=v[0], turn=v[1], path=[2.0]), *BOTH),
    named("model", lambda v: own.Model(speed=v[0], turn=v[1], other=0.1), *BOTH),
    named("model, default not set", lambda v: own.Model(speed=v[0]), "speed"),
    named("frozen model", lambda v: own.Frozen(speed=v[0], turn=v[1]), *BOTH),
    named("object", lambda v: SimpleNamespace(speed=v[0], turn=v[1], path=np.array([1.0, 2.0])), *BOTH),
    named("slotted object", lambda v: own.Slotted(*v), *BOTH),
    named("objects", lambda v: own.Twist(own.Point(v[0]), own.Point(0.1, v[1])), "linear.x", "angular.z"),
    named("a number in an object", lambda v: own.Twist(own.Point(v[0]), own.Point(0.1)), "linear.x"),
]
FUNCTIONS = [
    _functions("message", 2, own.Message, own.read_message, own.write_message),
    _functions("text", 1, lambda v: f"speed={v[0]!r}", own.read_text, own.write_text),
    _functions("rounded text", 1, lambda v: f"speed={v[0]:.3f}", own.read_text, own.write_rounded)._replace(
        grain=0.001
    ),
]
SUBTLE = [
    sequence("list subclass", own.Track),
    sequence("tuple subclass", own.Duo),
    sequence("Makes", lambda v: own.Makes(*v), 2)._replace(skipped=(("turn",), ("speed",))),
    named(
        "properties in objects", lambda v: own.Twist(own.Axes(v[0]), own.Axes(0.1, 0.2, v[1])), "linear.x", "angular.z"
    )._replace(skipped=(("linear", "_x"), ("angular", "z"))),
    named("slotted property", lambda v: own.Lean(v[0]), "speed")._replace(skipped=(("_speed",),)),
    named("a property in an object", lambda v: own.Twist(own.Axes(v[0]), own.Axes(0.1)), "linear.x")._replace(
        skipped=(("linear", "_x"),)
    ),
]
KITS = [*SCALARS, *SEQUENCES, *NAMED, *FUNCTIONS, *SUBTLE]


class Bounds(NamedTuple):
    """What an owner declares of the numbers: one for all, or one for each."""

    low: tuple[float, ...]
    high: tuple[float, ...]
    neutral: float
    scale: float


def declare(kit: Kit, bounds: Bounds) -> Any:
    """Return the action class, as an owner would write it."""
    if kit.size > 1 or "names" in kit.how:
        return ts.vector(list(bounds.low), list(bounds.high), kit.size, neutral=bounds.neutral, **kit.how)
    return partial(ts.scalar, bounds.low[0], bounds.high[0], neutral=bounds.neutral, **kit.how)(scale=bounds.scale)
