"""What a scikit-learn estimator learned, as named arrays and plain values: never pickle.

The estimator itself gives the structure, so that a file brings numbers and nothing else: a fitted estimator with the
same parameters is filled, value by value. None and random generators are left out, on both sides: what is random goes
on from the seed.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from tutorstudent.core.words.errors import ContractError, list_names
from tutorstudent.plugins.learned import take_arrays

Number = bool | int | float | np.number | np.bool
_LEFT_OUT = (type(None), np.random.RandomState, np.random.Generator)
_DEEPEST = 20


def export_state(value: Any, where: str) -> Any:
    """Return what a fitted estimator, or a value within one, has learned.

    >>> export_state({"rate": 0.5, "layers": [np.zeros(2)], "losses": [0.5, 0.25], "best": None}, "x")
    {'rate': 0.5, 'layers': {'0': array([0., 0.])}, 'losses': array([0.5 , 0.25])}

    Args:
        value: What is exported.
        where: What it is, for messages.

    Raises:
        ContractError: It holds something that is neither array nor plain value, nor made of these.
    """
    if _is_array(value):
        return value.copy()
    if isinstance(value, Number | str):
        return value.item() if isinstance(value, np.generic) else value
    if _is_numbers(value):
        return np.array(value, dtype=np.float64)
    return {name: export_state(item, f"{where}.{name}") for name, item in _find_members(value, where).items()}


def fill_state(template: Any, saved: Any, where: str) -> Any:
    """Return what was exported in the form of a fitted estimator, or of a value within one.

    Args:
        template: The estimator; its arrays and objects are filled in place.
        saved: What `export_state` returned for one like it.
        where: What it is, for messages.

    Raises:
        ContractError: They do not fit; the template may be half filled.
    """
    if _is_array(template):
        return _fill_array(template, saved, where)
    if isinstance(template, str):
        return _fill_text(template, saved, where)
    if isinstance(template, Number):
        return _fill_number(template, saved, where)
    if _is_numbers(template):
        return type(template)(take_arrays(where, {"values": saved}, {"values": (None,)})["values"].tolist())
    return _fill_members(template, saved, where)


def _is_array(value: Any) -> bool:
    return isinstance(value, np.ndarray) and value.dtype.kind in "fiub"


def _is_numbers(value: Any) -> bool:
    return isinstance(value, list | tuple) and len(value) > 0 and all(isinstance(item, Number) for item in value)


def _find_members(value: Any, where: str) -> dict[str, Any]:
    found = _find_parts(value)
    if found is None or where.count(".") > _DEEPEST:
        raise ContractError(
            f"{where} is a {type(value).__name__}; only arrays, plain values and objects made of these can be saved. "
            "Use another estimator, or do without saving what it learned."
        )
    return {str(name): item for name, item in found.items() if not isinstance(item, _LEFT_OUT)}


def _find_parts(value: Any) -> Mapping[Any, Any] | None:
    if isinstance(value, list | tuple):
        return dict(enumerate(value))
    if isinstance(value, dict):
        return value
    # An object that brings no pickling of its own keeps all that it knows in its attributes.
    pickles = any({"__reduce__", "__reduce_ex__"} & vars(cls).keys() for cls in type(value).__mro__[:-1])
    if pickles or callable(value) or not hasattr(value, "__dict__"):
        return None
    given = value.get_params(deep=False) if hasattr(value, "get_params") else {}
    return {name: item for name, item in vars(value).items() if name not in given}


def _fill_array(template: Any, saved: Any, where: str) -> Any:
    values = take_arrays(where, {"values": saved}, {"values": template.shape})["values"]
    with np.errstate(invalid="ignore"):
        np.copyto(template, values, casting="unsafe")
    if template.dtype.kind != "f" and not np.array_equal(template, values):
        raise ContractError(f"{where}: some of its values are no {template.dtype}.")
    return template


def _fill_text(template: str, saved: Any, where: str) -> str:
    if saved != template:
        raise ContractError(f"{where}: found {saved!r}, the estimator has '{template}'; was it made with other params?")
    return template


def _fill_number(template: Any, saved: Any, where: str) -> Any:
    kind = type(template)
    if isinstance(saved, Number):
        try:
            value = kind(saved)
        except (ValueError, OverflowError):
            value = None
        if value == saved or (value is not None and value != value):
            return value
    raise ContractError(f"{where}: found {saved!r}; it takes a {kind.__name__}.")


def _fill_members(template: Any, saved: Any, where: str) -> Any:
    members = _find_members(template, where)
    offered = saved if isinstance(saved, Mapping) else {}
    needed = [name for name, item in members.items() if name in offered or export_state(item, where) != {}]
    if not isinstance(saved, Mapping) or sorted(needed) != sorted(saved):
        found = list_names(saved) if isinstance(saved, Mapping) else f"a {type(saved).__name__}"
        raise ContractError(f"{where}: found {found}; it takes {list_names(needed)}.")
    filled = {name: fill_state(members[name], saved[name], f"{where}.{name}") for name in needed}
    return _put(template, filled)


def _put(template: Any, filled: dict[str, Any]) -> Any:
    if isinstance(template, list | tuple):
        return type(template)(filled.get(str(index), item) for index, item in enumerate(template))
    if isinstance(template, dict):
        template.update({key: filled[str(key)] for key in template if str(key) in filled})
    else:
        for name, value in filled.items():
            setattr(template, name, value)
    return template
