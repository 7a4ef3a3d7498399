"""States as JSON, for programs that know no Python. The mapping is documented in docs/process-protocol.md."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator, Mapping
from enum import Enum
from typing import Any

import numpy as np
from pydantic import BaseModel

from tutorstudent.core.words.errors import ContractError

NAN, INFINITY = "NaN", "Infinity"
"""JSON has no word for them; these strings are read by most languages' own number parsers."""


def make_plain(value: Any, at: str = "state") -> Any:
    """Return a value as what JSON can say.

    Numbers, strings, booleans and None stay; what is not finite becomes a string; arrays, lists and tuples become
    lists; named tuples, dataclasses, pydantic models and mappings become objects; enums become their value.

    >>> make_plain({"scan": np.array([1.5, np.inf]), "n": np.int64(3)})
    {'scan': [1.5, 'Infinity'], 'n': 3}

    Args:
        value: Of the state.
        at: Its place, for messages.

    Raises:
        ContractError: Something in it has no such form.
    """
    if value is None or isinstance(value, bool | str):
        return value.value if isinstance(value, Enum) else value
    if isinstance(value, Enum):
        return make_plain(value.value, at)
    if isinstance(value, int):
        return int(value)
    if isinstance(value, float):
        return float(value) if math.isfinite(value) else _spell(value)
    if isinstance(value, np.generic):
        return make_plain(value.item(), at)
    if isinstance(value, np.ndarray):
        return _list_array(value, at)
    if isinstance(value, list | tuple) and not hasattr(value, "_fields"):
        return [make_plain(item, f"{at}[{i}]") for i, item in enumerate(value)]
    return {name: make_plain(item, f"{at}.{name}") for name, item in _list_items(value, at)}


def _spell(value: float) -> str:
    if math.isnan(value):
        return NAN
    return INFINITY if value > 0 else f"-{INFINITY}"


def _list_array(array: np.ndarray[Any, Any], at: str) -> Any:
    numbers = array.tolist()
    if array.dtype.kind in "iub" or (array.dtype.kind == "f" and np.isfinite(array).all()):
        return numbers
    return make_plain(numbers, at)


def _list_items(value: Any, at: str) -> Iterator[tuple[str, Any]]:
    if isinstance(value, Mapping):
        for key, item in value.items():
            if not isinstance(key, str):
                raise ContractError(f"{at}: found the key {key!r}; a state for another program has strings as keys.")
            yield key, item
    elif isinstance(value, tuple):
        yield from zip(value._fields, value, strict=True)  # type: ignore[attr-defined]
    elif dataclasses.is_dataclass(value) and not isinstance(value, type):
        yield from ((field.name, getattr(value, field.name)) for field in dataclasses.fields(value))
    elif isinstance(value, BaseModel):
        yield from ((name, getattr(value, name)) for name in type(value).model_fields)
    else:
        raise ContractError(
            f"{at}: found {type(value).__name__}; a state for another program is made of numbers, strings, booleans, "
            "None, arrays, lists, tuples, mappings, dataclasses and pydantic models."
        )
