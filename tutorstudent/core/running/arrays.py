"""Arrays on disk: .npz without pickle, and learned state as one level of arrays."""

from __future__ import annotations

import os
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from urllib.parse import quote, unquote

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.roles.part import Learned
from tutorstudent.core.words.errors import ContractError

Arrays = dict[str, NDArray[Any]]


def flatten(state: Learned, prefix: str = "") -> Arrays:
    """Return nested learned state as one level of arrays, keyed by path.

    Characters of a key other than letters, digits and ``_.-~`` are written as in a URL, so that paths are unique and
    can be read back.

    Raises:
        ContractError: if a key is no string.

    >>> {key: value.tolist() for key, value in flatten({"student": {"w": [1.0], "n": 2}}).items()}
    {'student/w': [1.0], 'student/n': 2}
    >>> list(flatten({"a/b": 1, "a": {"b": 2}}))
    ['a%2Fb', 'a/b']
    """
    arrays: Arrays = {}
    for key, value in state.items():
        if not isinstance(key, str):
            raise ContractError(f"the key {key!r} of learned state is not a string; use strings.")
        path = f"{prefix}{quote(key, safe='')}"
        arrays |= flatten(value, f"{path}/") if isinstance(value, Mapping) else {path: np.asarray(value)}
    return arrays


def nest(arrays: Mapping[str, NDArray[Any]]) -> dict[str, Any]:
    """Return what `flatten` was given; arrays without dimensions become plain values.

    >>> nest(flatten({"student": {"n": 2}, "decisions": 5}))
    {'student': {'n': 2}, 'decisions': 5}
    """
    state: dict[str, Any] = {}
    for path, array in arrays.items():
        *parents, key = (unquote(word) for word in path.split("/"))
        branch = state
        for parent in parents:
            branch = branch.setdefault(parent, {})
        branch[key] = array.item() if array.ndim == 0 else array
    return state


def save_arrays(path: Path, arrays: Mapping[str, NDArray[Any]]) -> None:
    """Write arrays as a compressed .npz under any names, whole or not at all; refuses what would need pickle."""
    partial = path.with_name(f".{path.name}.partial")
    try:
        with zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, array in arrays.items():
                with archive.open(f"{name}.npy", "w", force_zip64=True) as member:
                    np.lib.format.write_array(member, np.asanyarray(array), allow_pickle=False)
        with partial.open("rb+") as stream:
            os.fsync(stream.fileno())
        partial.replace(path)
    finally:
        partial.unlink(missing_ok=True)


def load_arrays(path: Path) -> Arrays:
    """Read an .npz without pickle."""
    with path.open("rb") as stream, np.load(stream, allow_pickle=False) as stored:
        return {name: stored[f"{name}.npy"] for name in stored.files}
