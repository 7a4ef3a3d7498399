"""What an owner's command holds, to put it back if writing another one changes it."""

from __future__ import annotations

from typing import Any

import numpy as np

from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.snapshots import PLAIN

DEPTH = 4
"""How many objects deep a command is remembered."""


class Backup:
    """Remembers a command's members, and those of the objects in it, without copying the objects."""

    def __init__(self, command: Any) -> None:
        self._kept: list[tuple[Any, Any]] = []
        self._keep(command, DEPTH)

    def _keep(self, value: Any, depth: int) -> None:
        if depth == 0 or type(value) in PLAIN or any(value is kept for kept, _ in self._kept):
            return
        if isinstance(value, np.ndarray):
            self._kept.append((value, value.copy()))
        elif isinstance(value, tuple):
            for item in value:
                self._keep(item, depth - 1)
        else:
            members = read_members(value)
            if members:
                self._kept.append((value, members))
            for item in members.values():
                self._keep(item, depth - 1)

    def restore(self) -> bool:
        """Put everything back; return whether anything had changed.

        Raises:
            ContractError: if an object does not take its own members back.
        """
        changed = [(value, held) for value, held in self._kept if not _is_intact(value, held)]
        for value, held in changed:
            _put_back(value, held)
            if not _is_intact(value, held):
                raise ContractError(
                    f"writing an amplified command changed the controller's own {type(value).__name__}, and it cannot "
                    "be changed back. Let write= make a new command."
                )
        return bool(changed)


def read_members(owner: Any) -> dict[Any, Any]:
    """Return what an object or container holds, by name, key or place."""
    if isinstance(owner, dict):
        return dict(dict.items(owner))
    if isinstance(owner, list):
        return dict(enumerate(list.__iter__(owner)))
    names = [name for base in type(owner).__mro__ for name in _list_slots(base) if _has(owner, name)]
    held = {name: object.__getattribute__(owner, name) for name in names}
    return held | dict(getattr(owner, "__dict__", {}))


def _list_slots(base: type[Any]) -> list[str]:
    slots = vars(base).get("__slots__", ())
    names = [slots] if isinstance(slots, str) else list(slots)
    own = [f"_{base.__name__.lstrip('_')}{name}" if name[:2] == "__" != name[-2:] else name for name in names]
    return [name for name in own if name not in ("__dict__", "__weakref__")]


def _has(owner: Any, name: str) -> bool:
    try:
        object.__getattribute__(owner, name)
    except AttributeError:
        return False
    return True


def _is_intact(value: Any, held: Any) -> bool:
    if isinstance(value, np.ndarray):
        return bool(value.dtype == held.dtype and value.shape == held.shape and value.tobytes() == held.tobytes())
    now = read_members(value)
    return now.keys() == held.keys() and all(now[name] is member for name, member in held.items())


def _put_back(value: Any, held: Any) -> None:
    if isinstance(value, np.ndarray):
        value[...] = held
    elif isinstance(value, list):
        list.__setitem__(value, slice(None), list(held.values()))
    elif isinstance(value, dict):
        dict.clear(value)
        dict.update(value, held)
    else:
        if hasattr(value, "__dict__"):
            for name in [name for name in vars(value) if name not in held]:
                del vars(value)[name]
        for name, member in held.items():
            if name in getattr(value, "__dict__", {}):
                vars(value)[name] = member
            else:
                object.__setattr__(value, name, member)
