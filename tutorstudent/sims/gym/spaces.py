"""Action spaces and action classes: which fit together, and one made for the other.

Only a box of numbers has magnitudes to amplify; a discrete action is a choice without one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic import create_model

from tutorstudent.core.words.actions import Action, component, read_vocabulary
from tutorstudent.core.words.commands import Command
from tutorstudent.core.words.errors import ContractError, list_names, suggest
from tutorstudent.sims.gym.loading import load_gymnasium

_ROUNDING = 1e-6
"""Bounds of a space are single precision most often: 0.7 is 0.699999988 there."""


def check_box(space: Any, where: str) -> None:
    """Refuse an action space in which there is nothing to amplify.

    Raises:
        ContractError: if it is no box of real numbers.
    """
    if not isinstance(space, load_gymnasium().spaces.Box) or space.dtype.kind != "f":
        raise ContractError(
            f"{where}: the action space {space} has no magnitudes, so there is nothing to amplify; "
            "use an environment whose action space is a Box of floats."
        )


def box_action(
    space: Any,
    names: Sequence[str] | None = None,
    *,
    amplified: Sequence[str] | None = None,
    neutral: float = 0.0,
) -> type[Command]:
    """Return an action class with one component for each number of a Box, in its bounds, amplified outward.

    Args:
        space: The environment's action space.
        names: Of the components, in the order of the flattened space; by default x0, x1 and so on.
        amplified: Names that are amplified, each by itself. By default all are, together, so that their direction is
            kept; that makes sense where they have one unit.
        neutral: The value at which a component does nothing.

    Raises:
        ContractError: if the space is no Box of floats, or the names do not fit.
    """
    check_box(space, "box_action()")
    lows, highs = space.low.ravel().tolist(), space.high.ravel().tolist()
    named = [f"x{i}" for i in range(len(lows))] if names is None else list(names)
    if len(set(named)) != len(lows) or len(named) != len(lows):
        raise ContractError(
            f"box_action(): found the names {named}; the space {space} needs {len(lows)}, all different."
        )
    for name in amplified or ():
        if name not in named:
            raise ContractError(
                f"box_action(): there is no component '{name}'{suggest(name, named)}; they are {list_names(named)}."
            )
    fields: dict[str, Any] = {
        name: (float, component(_make_bound(low), _make_bound(high), neutral=neutral))
        for name, low, high in zip(named, lows, highs, strict=True)
    }
    made: type[Command] = create_model("BoxAction", __base__=Command, __module__=__name__, **fields)
    directions = None if amplified is None else dict.fromkeys(amplified, "outward")
    made.amplification = {"command": directions or {tuple(named): "outward"}}  # type: ignore[dict-item]
    made.vocabulary = read_vocabulary(made)
    return made


def check_fit(action: type[Action], space: Any, where: str) -> None:
    """Refuse an action class whose numbers are not those of a Box.

    Raises:
        ContractError: if there are more or fewer, or one goes beyond the space's bounds.
    """
    specs = list(action.vocabulary.components.values())
    size = math.prod(space.shape)
    if len(specs) != size or not all(spec.number for spec in specs):
        raise ContractError(
            f"{where}: the tutor's {action.__name__} has the components {list_names(spec.name for spec in specs)}; the "
            f"action space {space} takes {size} numbers. Use a class of as many, as in ts.vector(low, high, {size})."
        )
    for spec, low, high in zip(specs, space.low.ravel().tolist(), space.high.ravel().tolist(), strict=True):
        slack = _ROUNDING * max(1.0, abs(spec.low), abs(spec.high))
        if spec.low < low - slack or spec.high > high + slack:
            raise ContractError(
                f"{where}: the component '{spec.name}' of the tutor's {action.__name__} lies in [{spec.low:g}, "
                f"{spec.high:g}]; the action space allows [{low:g}, {high:g}]. State these bounds."
            )


def make_box_values(action: Action, space: Any) -> NDArray[Any]:
    """Return an action that fits as what the environment takes."""
    values = np.array([getattr(action, name) for name in action.vocabulary.components], dtype=space.dtype)
    clipped: NDArray[Any] = np.clip(values.reshape(space.shape), space.low, space.high)
    return clipped


def _make_bound(bound: float) -> float | None:
    return bound if math.isfinite(bound) else None
