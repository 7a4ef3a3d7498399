"""What values hold, as something that can be compared, and values that hold something broken."""

from __future__ import annotations

import dataclasses
import hashlib
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from pydantic import BaseModel

_DEEPEST = 20


def take_snapshot(value: Any, depth: int = 0) -> Any:
    """Return what a value holds, made of tuples and plain values; equal for values that hold the same, NaN included.

    >>> take_snapshot({"scan": np.array([1.0, np.nan])}) == take_snapshot({"scan": np.array([1.0, np.nan])})
    True
    """
    kind = type(value).__qualname__
    if depth > _DEEPEST or value is None or isinstance(value, type):
        return kind, str(value) if value is None or isinstance(value, type) else "..."
    if isinstance(value, np.ndarray):
        held: Any = value.tolist() if value.dtype.hasobject else value.tobytes()
        return kind, value.dtype.str, value.shape, take_snapshot(held, depth + 1)
    if isinstance(value, bool | int | float | complex | str | bytes | np.generic):
        return kind, repr(value)
    if isinstance(value, Mapping):
        pairs = [(take_snapshot(key, depth + 1), take_snapshot(item, depth + 1)) for key, item in value.items()]
        return kind, tuple(sorted(pairs, key=repr))
    if isinstance(value, set | frozenset):
        return kind, tuple(sorted((take_snapshot(item, depth + 1) for item in value), key=repr))
    if isinstance(value, list | tuple):
        return kind, tuple([take_snapshot(item, depth + 1) for item in value])
    return kind, tuple([(name, take_snapshot(item, depth + 1)) for name, item in _read_attributes(value).items()])


def digest(value: Any) -> str:
    """Return a short fingerprint of what a value holds, the same in every process."""
    return hashlib.sha256(repr(take_snapshot(value)).encode()).hexdigest()[:16]


def damage(value: Any, reading: float) -> Any:
    """Return a copy of a state in which every float is `reading`, as a broken sensor would deliver it.

    >>> damage((1.5, 2, "left"), np.inf)
    (inf, 2, 'left')

    Raises:
        Exception: whatever the state's class raises where it refuses such a reading.
    """
    if isinstance(value, float | np.floating):
        return type(value)(reading)
    if isinstance(value, np.ndarray) and value.dtype.kind == "f":
        broken = np.full_like(value, reading)
        broken.setflags(write=value.flags.writeable)
        return broken
    return _rebuild(value, lambda item: damage(item, reading))


def _rebuild(value: Any, change: Callable[[Any], Any]) -> Any:
    if isinstance(value, dict):
        return {key: change(item) for key, item in value.items()}
    if isinstance(value, tuple) and hasattr(value, "_make"):
        return value._make([change(item) for item in value])
    if type(value) in (list, tuple):
        return type(value)([change(item) for item in value])
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        fields = [field.name for field in dataclasses.fields(value) if field.init]
        return dataclasses.replace(value, **{name: change(getattr(value, name)) for name in fields})
    if isinstance(value, BaseModel):
        return type(value)(**{name: change(getattr(value, name)) for name in type(value).model_fields})
    return value


def _read_attributes(value: Any) -> dict[str, Any]:
    slots = [name for cls in type(value).__mro__ for name in _list_slots(cls)]
    held = {name: getattr(value, name) for name in slots if hasattr(value, name)}
    return held | dict(getattr(value, "__dict__", {}))


def _list_slots(cls: type[Any]) -> tuple[str, ...]:
    found = vars(cls).get("__slots__", ())
    return (found,) if isinstance(found, str) else tuple(name for name in found if not name.startswith("__"))


class Unreadable:
    """Raises whatever is done with it: a state of a sensor that has just died."""

    def _refuse(self, *_: Any) -> Any:
        raise RuntimeError("a value that cannot be read, handed in by a conformance check")

    __getattr__ = __getitem__ = __iter__ = __len__ = __bool__ = __float__ = __int__ = __index__ = _refuse
    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __neg__ = __abs__ = _refuse
    __lt__ = __le__ = __gt__ = __ge__ = __array__ = _refuse
