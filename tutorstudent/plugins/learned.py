"""Checks for learned arrays that come back from outside."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.roles.part import Learned
from tutorstudent.core.words.errors import ContractError, list_names, suggest

Shape = tuple[int | None, ...]
"""The lengths of an array's axes; None allows any length."""


def take_arrays(owner: str, state: Learned, shapes: Mapping[str, Shape]) -> dict[str, NDArray[np.float64]]:
    """Return the named arrays of `state` as new float arrays, once all of them have been checked.

    >>> take_arrays("student 'x'", {"weights": [0.5, 1]}, {"weights": (2,)})
    {'weights': array([0.5, 1. ])}

    Args:
        owner: Whose they are, for messages.
        state: What is offered, by name.
        shapes: The names that have to be there, each with its shape.

    Raises:
        ContractError: A name is missing or unknown, or an array has another shape or is not made of finite numbers.
    """
    for name in state:
        if name not in shapes:
            raise ContractError(
                f"{owner} learned nothing named '{name}'{suggest(name, shapes)}; it takes {list_names(shapes)}."
            )
    for name in shapes:
        if name not in state:
            raise ContractError(f"{owner} misses '{name}'; it takes {list_names(shapes)}, found {list_names(state)}.")
    return {name: _take_array(f"{owner} cannot load '{name}'", state[name], shape) for name, shape in shapes.items()}


def _take_array(problem: str, value: object, shape: Shape) -> NDArray[np.float64]:
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ContractError(f"{problem}: it is no array ({error}).") from None
    if array.dtype.kind not in "fiub":
        raise ContractError(f"{problem}: found {array.dtype} values; it takes real numbers.")
    if len(array.shape) != len(shape) or any(
        want not in (None, have) for want, have in zip(shape, array.shape, strict=True)
    ):
        wanted = ", ".join("any" if length is None else str(length) for length in shape)
        raise ContractError(
            f"{problem}: found the shape {array.shape}, it takes ({wanted}); "
            "load it into a part with the options that it was saved with."
        )
    if not np.isfinite(array).all():
        raise ContractError(f"{problem}: some of its values are not finite.")
    return np.array(array, dtype=np.float64)
