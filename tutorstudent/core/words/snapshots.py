"""What parts are shown of an owner's state: copies of what they read, and nothing of what nobody reads.

Loops reuse their buffers and keep whole simulators in their states. Numbers, texts, arrays and the usual containers are
copied at once; any other object is shown as a twin of its own class that copies an attribute when it is first read.
"""

from __future__ import annotations

import copy
import dataclasses
import types
from collections import deque
from collections.abc import Callable
from datetime import date, time, timedelta
from decimal import Decimal
from enum import Enum
from fractions import Fraction
from pathlib import PurePath
from types import BuiltinFunctionType, FunctionType, ModuleType
from typing import Any, TypeVar
from weakref import WeakKeyDictionary

import numpy as np
from pydantic import BaseModel

PLAIN: frozenset[type[Any]] = frozenset((str, bytes, bool, int, float, complex, type(None), Decimal, Fraction, range))
"""Nobody can change them."""
_UNCHANGING: tuple[type[Any], ...] = (
    *(str, bytes, int, float, complex, Decimal, Fraction, np.generic, Enum, PurePath),
    *(type, ModuleType, FunctionType, BuiltinFunctionType, date, time, timedelta),
)
_T = TypeVar("_T")


def take_snapshot(state: _T) -> _T:
    """Return what parts are shown of a state; its owner's buffers cannot change it any more, and it cannot change them.

    Arrays are read-only. What cannot be shown stands there as an object that says why when it is read.

    >>> shown = take_snapshot({"scan": np.zeros(2)})
    >>> shown["scan"].flags.writeable
    False
    """
    shown: _T = Snapshot().take(state, "state")
    return shown


class Snapshot:
    """One look at a state. Once its block is left it is final: what nobody has read by then was not kept."""

    def __init__(self) -> None:
        self._taken: dict[int, Any] = {}
        self._kept: list[Any] = []
        """What the keys of `_taken` belong to: an object that is gone may leave its number to another."""
        self.is_over = False

    def __enter__(self) -> Snapshot:
        return self

    def __exit__(self, *error: object) -> None:
        self.is_over = True

    def take(self, value: Any, name: str) -> Any:
        """Return a copy of a value; `name` says in messages where it stands."""
        kind = type(value)
        if isinstance(value, np.void):  # a row of a structured array: a view of the owner's
            return value.copy()
        if kind in PLAIN or isinstance(value, _UNCHANGING):
            return value
        if id(value) in self._taken:  # shared, or a circle
            return self._taken[id(value)]
        try:
            return self._copy(value, kind, name)
        except Exception as error:  # whatever the owner's class thinks of being copied
            why = f"{name} is a {kind.__name__}, which cannot be shown to parts ({type(error).__name__}: {error})."
            return self._keep(value, Hidden(why))

    def _copy(self, value: Any, kind: type[Any], name: str) -> Any:
        if isinstance(value, np.ndarray):
            return self._copy_array(value, name)
        if isinstance(value, tuple):
            items = [self.take(item, f"{name}[{i}]") for i, item in enumerate(value)]
            return self._keep(value, value._make(items) if hasattr(value, "_make") else tuple(items))
        for container, fill in _FILL.items():
            if isinstance(value, container):
                return self._fill(value, container, fill, name)
        if not hasattr(kind, "__del__") and (dataclasses.is_dataclass(value) or isinstance(value, BaseModel)):
            return self._copy_record(value, name)
        return self._keep(value, _make_twin(value, self, name))

    def _copy_record(self, value: Any, name: str) -> Any:
        copied = self._keep(value, copy.copy(value))
        fields = [field.name for field in dataclasses.fields(value)] if dataclasses.is_dataclass(value) else vars(value)
        for field in list(fields):
            object.__setattr__(copied, field, self.take(getattr(value, field), f"{name}.{field}"))
        return copied

    def _fill(
        self, value: Any, container: type[Any], fill: Callable[[Snapshot, Any, Any, str], None], name: str
    ) -> Any:
        kind = type(value)
        try:
            copied = kind.__new__(kind)  # type: ignore[call-overload]
            if hasattr(value, "__dict__"):
                copied.__dict__.update({key: self.take(item, f"{name}.{key}") for key, item in vars(value).items()})
        except Exception:  # a subclass that wants more: its contents at least
            copied = container()
        self._keep(value, copied)
        fill(self, value, copied, name)
        return copied

    def _copy_array(self, value: Any, name: str) -> Any:
        copied = self._keep(value, value.copy())
        if copied.dtype.hasobject:
            for at in np.ndindex(copied.shape):
                copied[at] = self.take(value[at], f"{name}{list(at)}")
        copied.setflags(write=False)
        return copied

    def _keep(self, value: Any, copied: Any) -> Any:
        self._taken[id(value)] = copied
        self._kept.append(value)
        return copied


def _fill_dict(snapshot: Snapshot, value: Any, copied: Any, name: str) -> None:
    for key, item in dict.items(value):
        dict.__setitem__(copied, key, snapshot.take(item, f"{name}[{key!r}]"))


def _fill_list(snapshot: Snapshot, value: Any, copied: Any, name: str) -> None:
    list.extend(copied, [snapshot.take(item, f"{name}[{i}]") for i, item in enumerate(list.__iter__(value))])


def _fill_set(snapshot: Snapshot, value: Any, copied: Any, name: str) -> None:
    set.update(copied, [snapshot.take(item, name) for item in set.__iter__(value)])


def _fill_deque(snapshot: Snapshot, value: Any, copied: Any, name: str) -> None:
    deque.extend(copied, [snapshot.take(item, f"{name}[{i}]") for i, item in enumerate(value)])


_FILL: dict[type[Any], Callable[[Snapshot, Any, Any, str], None]] = {
    dict: _fill_dict,
    list: _fill_list,
    set: _fill_set,
    deque: _fill_deque,
}


class Hidden:
    """Stands for what cannot be shown. Whoever reads it is told why."""

    def __init__(self, why: str) -> None:
        object.__setattr__(self, "_why", why)

    def __getattr__(self, name: str) -> Any:
        raise TypeError(object.__getattribute__(self, "_why"))

    def _refuse(self, *_: Any) -> Any:
        raise TypeError(object.__getattribute__(self, "_why"))

    __setattr__ = __getitem__ = __iter__ = __len__ = __float__ = __int__ = __bool__ = __call__ = __contains__ = _refuse
    __eq__ = __lt__ = __gt__ = __le__ = __ge__ = __add__ = __sub__ = __mul__ = __neg__ = __abs__ = _refuse
    __hash__ = object.__hash__

    def __repr__(self) -> str:
        return f"<hidden: {object.__getattribute__(self, '_why')}>"


_TWINS: WeakKeyDictionary[type[Any], type[Any] | str] = WeakKeyDictionary()
"""For each class that was met, the class of its twins, or why it has none."""
_SOURCE = "_shown_from"


def _make_twin(value: Any, snapshot: Snapshot, name: str) -> Any:
    """Return an object of the value's class that copies an attribute when it is first read."""
    kind = type(value)
    if kind not in _TWINS:
        _TWINS[kind] = _find_twin(kind)
    found = _TWINS[kind]
    if isinstance(found, str):
        return Hidden(f"{name} is a {kind.__name__}, which cannot be shown to parts: {found}.")
    twin = object.__new__(found)
    object.__setattr__(twin, _SOURCE, (value, snapshot, name))
    return twin


def _find_twin(kind: type[Any]) -> type[Any] | str:
    if any("__init_subclass__" in vars(base) for base in kind.__mro__[:-1]):
        return "its class watches its subclasses"
    try:
        body: dict[str, Any] = {"__getattr__": _read_late, "__module__": kind.__module__}
        if hasattr(kind, "__del__"):
            body["__del__"] = _keep_hold
        found: type[Any] = types.new_class(kind.__name__, (kind,), exec_body=lambda names: names.update(body))
        object.__new__(found)
    except Exception as error:  # classes of C, and whatever a metaclass thinks of it
        return f"{type(error).__name__}: {error}".rstrip(".")
    return found


def _keep_hold(_: Any) -> None:
    """Let go of nothing: what the owner's class lets go of when it is deleted is not its twin's."""


def _read_late(twin: Any, attribute: str) -> Any:
    value, snapshot, name = object.__getattribute__(twin, _SOURCE)
    if attribute.startswith("__"):
        raise AttributeError(attribute)
    if snapshot.is_over:
        raise AttributeError(f"{name}.{attribute} was not read while the decision was made, so it was not kept.")
    copied = snapshot.take(getattr(value, attribute), f"{name}.{attribute}")
    object.__setattr__(twin, attribute, copied)
    return copied
