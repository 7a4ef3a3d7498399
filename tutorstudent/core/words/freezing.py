"""Copies of states that cannot change any more."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np

_SAFE = (str, bytes, bool, int, float, complex, np.generic, type(None))


def freeze(state: Any) -> Any:
    """Return a copy of a state that shares nothing with the original; its arrays are read-only.

    >>> frozen = freeze({"scan": np.zeros(2)})
    >>> frozen["scan"].flags.writeable
    False
    """
    if isinstance(state, _SAFE):
        return state
    if isinstance(state, np.ndarray):
        copied = state.copy()
        copied.setflags(write=False)
        return copied
    if isinstance(state, dict):
        return {key: freeze(value) for key, value in state.items()}
    if isinstance(state, list):
        return [freeze(item) for item in state]
    if isinstance(state, tuple):
        items = [freeze(item) for item in state]
        return state._make(items) if hasattr(state, "_make") else tuple(items)
    return copy.deepcopy(state)
