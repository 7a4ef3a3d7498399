"""Commands that are objects or mappings: their numbers are found by name, and changed in a copy."""

from __future__ import annotations

import copy
import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any

from pydantic import BaseModel

from tutorstudent.core.words.backup import read_members
from tutorstudent.core.words.errors import ContractError, list_names, quote, suggest
from tutorstudent.core.words.forms import Form, Numbers, fit_number, is_number, match_type, read_float
from tutorstudent.core.words.sameness import is_same
from tutorstudent.core.words.snapshots import list_members

Path = tuple[str, ...]


class NamedForm(Form):
    """An object or mapping whose numbers are found by name; ``linear.x`` is the x of its ``linear``."""

    def __init__(self, names: Sequence[str]) -> None:
        self._paths: list[Path] = [tuple(name.split(".")) for name in names]

    def read(self, command: Any) -> Numbers:
        return [self._read_number(command, path) for path in self._paths]

    def write(self, numbers: Numbers, like: Any) -> Any:
        if like is None:
            raise ContractError(
                f"the controller has returned no command yet in which '{'.'.join(self._paths[0])}' could be written; "
                "give write=, which is then asked to write in None."
            )
        return _replace_numbers(like, dict(zip(self._paths, self.fit(numbers, like), strict=True)))

    def fit(self, numbers: Numbers, like: Any) -> Numbers:
        own = [_reach(like, path) for path in self._paths]
        return [fit_number(item, number) for item, number in zip(own, numbers, strict=True)]

    def compare_rest(self, command: Any, written: Any) -> str | None:
        return _find_difference(command, written, self._paths)

    def _read_number(self, command: Any, path: Path) -> float:
        found = command
        for step in path:
            found = _find_member(found, step, command)
        name = f"'{'.'.join(path)}'"
        if not is_number(found):
            raise ContractError(
                f"the controller's command is {quote(command)}: {name} is {quote(found)}, not a number."
            )
        return read_float(found, name, command)


def _find_member(owner: Any, step: str, command: Any) -> Any:
    try:
        return get_member(owner, step)
    except (AttributeError, KeyError):
        known = list_members(owner)
        raise ContractError(
            f"the controller's command is {quote(command)}: {type(owner).__name__} has no '{step}'"
            f"{suggest(step, known)}; it has {list_names(known)}."
        ) from None
    except Exception as error:
        raise ContractError(
            f"the controller's command is {quote(command)}: reading '{step}' raised {type(error).__name__}: {error}."
        ) from error


def get_member(owner: Any, step: str) -> Any:
    """Return a mapping's key or an object's attribute; raises KeyError or AttributeError where there is none."""
    if not isinstance(owner, Mapping):
        return getattr(owner, step)
    if step not in owner:  # a defaultdict would make it up, and keep it
        raise KeyError(step)
    return owner[step]


def _reach(owner: Any, path: Path) -> Any:
    for step in path:
        owner = get_member(owner, step)
    return owner


def _set(owner: Any, step: str, value: Any) -> None:
    if isinstance(owner, Mapping):
        owner[step] = value  # type: ignore[index]
    else:
        setattr(owner, step, value)


def _find_difference(own: Any, written: Any, paths: Sequence[Path]) -> str | None:
    """Return the first member in which two objects differ beside what the paths lead to."""
    if type(own) is not type(written):
        return f"the type to {type(written).__name__}"
    mine, other = _read_members(own), _read_members(written)
    if mine.keys() != other.keys():
        return "what it holds"
    for name, value in mine.items():
        below = [path[1:] for path in paths if path[0] == name or (path[0] not in mine and name == f"_{path[0]}")]
        if () in below:  # the number itself, or where a property keeps it
            continue
        found = _find_difference(value, other[name], below) if below else None
        if found is not None or (not below and not is_same(value, other[name])):
            return f"'{name}'" if found is None else f"'{name}': {found}"
    return None


def _read_members(owner: Any) -> dict[Any, Any]:
    if hasattr(owner, "_asdict"):
        return dict(owner._asdict())
    return dict(owner) if isinstance(owner, Mapping) else read_members(owner)


def _replace_numbers(owner: Any, numbers: Mapping[Path, float]) -> Any:
    """Return a copy of an owner's object with other numbers; objects on the way to them are copied too."""
    inside: dict[str, dict[Path, float]] = {}
    for (step, *rest), number in numbers.items():
        inside.setdefault(step, {})[tuple(rest)] = number
    changes = {}
    for step, below in inside.items():
        own = get_member(owner, step)
        changes[step] = match_type(own, below[()]) if () in below else _replace_numbers(own, below)
    return _replace_members(owner, changes)


def _replace_members(owner: Any, changes: dict[str, Any]) -> Any:
    """Return a copy with other members, made in the way of the owner's type, which may refuse."""
    if isinstance(owner, BaseModel):
        return owner.model_copy(update=changes)
    if dataclasses.is_dataclass(owner) and not isinstance(owner, type):
        return dataclasses.replace(owner, **changes)
    if isinstance(owner, tuple) and hasattr(owner, "_replace"):
        return owner._replace(**changes)
    if hasattr(type(owner), "__replace__"):  # the protocol of copy.replace
        return owner.__replace__(**changes)
    copied: Any = copy.copy(owner)
    if copied is owner:
        raise ContractError(f"{type(owner).__name__}: its copy is the object itself, so it cannot be amplified.")
    for name, value in changes.items():
        _set(copied, name, value)
    return copied
