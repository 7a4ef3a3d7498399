"""What a command or a state holds, bit for bit, read without the package."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np

Path = tuple[Any, ...]
Paths = tuple[Path, ...]
PLAIN = (str, bytes, bool, int, type(None), Decimal, Fraction)


def imprint(value: Any, skipped: Paths = ()) -> Any:
    """Return something that is equal for equal values only; what the skipped paths lead to is left out."""
    if () in skipped:
        return "declared"
    kind = type(value)
    if kind in PLAIN:
        return kind, repr(value)
    if isinstance(value, np.generic):
        return kind, value.dtype.str, value.tobytes()
    if isinstance(value, np.ndarray):
        return kind, value.dtype.str, value.shape, value.tobytes()
    if isinstance(value, float):
        return kind, struct.pack("d", value)
    if isinstance(value, Mapping):
        items = [(imprint(key), imprint(dict.get(value, key), _below(skipped, key))) for key in dict.keys(value)]
        return kind, tuple(items), _attributes(value, skipped)
    if isinstance(value, list | tuple):
        steps = getattr(value, "_fields", range(len(value)))
        items = [imprint(item, _below(skipped, step)) for step, item in zip(steps, value, strict=True)]
        return kind, tuple(items), _attributes(value, skipped)
    if isinstance(value, set | frozenset):
        return kind, tuple(sorted(map(repr, value)))
    return kind, _attributes(value, skipped)


def _below(skipped: Paths, step: Any) -> Paths:
    return tuple(path[1:] for path in skipped if path and path[0] == step)


def _attributes(value: Any, skipped: Paths) -> Any:
    slots = [name for base in type(value).__mro__ for name in _names(vars(base).get("__slots__", ()))]
    found = {name: getattr(value, name) for name in slots if hasattr(value, name)} | getattr(value, "__dict__", {})
    chosen = set(found) - {"__dict__", "__weakref__", "__pydantic_fields_set__"}
    return tuple((name, imprint(found[name], _below(skipped, name))) for name in sorted(chosen))


def _names(slots: Any) -> tuple[str, ...]:
    return (slots,) if isinstance(slots, str) else tuple(slots)


def reach(value: Any, path: Path) -> Any:
    """Return what a path leads to."""
    for step in path:
        value = value[step] if isinstance(value, Mapping) or isinstance(step, int) else getattr(value, step)
    return value
