"""Action classes for controllers that return numbers: one number, or a fixed number of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from pydantic import ValidationError, create_model

from tutorstudent.core.actions import Action, component, vocabulary_of
from tutorstudent.core.errors import ContractError


class Command(Action):
    """An action of one kind that stands for the owner's own command, a number or an array of numbers."""

    @classmethod
    def read(cls, command: Any) -> Command:
        """Return the action that an owner's command stands for: a number, or a list, tuple or array of numbers.

        Raises:
            ContractError: if it is nothing of the kind, or out of bounds.
        """
        names = list(cls.vocabulary.components)
        values = _numbers(command)
        if values is None or len(values) != len(names):
            what = "a number" if len(names) == 1 else f"a list, tuple or numpy array of {len(names)} numbers"
            raise ContractError(f"the controller's command is {command!r}; expected {what}.")
        try:
            return cls.model_validate(dict(zip(names, values, strict=True)))
        except ValidationError as error:
            problem = error.errors(include_url=False)[0]
            where = f"'{problem['loc'][-1]}': " if len(names) > 1 else ""
            raise ContractError(
                f"the controller's command is {command!r}: {where}{problem['msg'][0].lower()}{problem['msg'][1:]}. "
                "State the bounds that it keeps, as in action=ts.scalar(-1, 1), or let the controller keep them."
            ) from None

    def write(self, like: Any) -> Any:
        """Return the command in the type and shape of `like`, a command that `read` took."""
        values = [getattr(self, name) for name in self.vocabulary.components]
        if isinstance(like, np.ndarray):
            dtype = like.dtype if like.dtype.kind == "f" else np.float64
            return np.array(values, dtype=dtype).reshape(like.shape)
        if isinstance(like, tuple):
            return like._make(values) if hasattr(like, "_make") else tuple(values)
        if isinstance(like, list) or (like is None and len(values) > 1):
            return values
        return type(like)(values[0]) if isinstance(like, np.floating) else values[0]


def _numbers(command: Any) -> list[float] | None:
    if isinstance(command, np.ndarray) and command.dtype.kind in "fiu":
        return [float(value) for value in command.ravel().tolist()]
    items = command if isinstance(command, list | tuple) else [command]
    if any(isinstance(item, bool) or not isinstance(item, int | float | np.floating | np.integer) for item in items):
        return None
    return [float(item) for item in items]


def scalar(
    low: float | None = None,
    high: float | None = None,
    *,
    neutral: float = 0.0,
    scale: float | None = None,
    unit: str = "",
) -> type[Command]:
    """Return an action class of one number, amplified outward: away from neutral, nothing at neutral.

    >>> scalar(-1, 1)(value=0.25)
    Scalar(kind='command', value=0.25)
    """
    return _command("Scalar", ["value"], [low], [high], neutral, scale, unit)


def vector(
    low: Sequence[float] | float, high: Sequence[float] | float, size: int, *, neutral: float = 0.0, unit: str = ""
) -> type[Command]:
    """Return an action class of `size` numbers that are amplified together, so that their direction is kept.

    >>> vector(-1, 1, 2).read([0.3, -0.4])
    Vector(kind='command', x0=0.3, x1=-0.4)
    """
    lows, highs = ([bound] * size if isinstance(bound, int | float) else list(bound) for bound in (low, high))
    if len(lows) != size or len(highs) != size:
        raise ContractError(f"vector(): found {len(lows)} low and {len(highs)} high bounds; expected {size} of each.")
    return _command("Vector", [f"x{i}" for i in range(size)], lows, highs, neutral, None, unit)


def _command(
    title: str,
    names: list[str],
    lows: Sequence[float | None],
    highs: Sequence[float | None],
    neutral: float,
    scale: float | None,
    unit: str,
) -> type[Command]:
    fields: dict[str, Any] = {
        name: (float, component(low, high, neutral=neutral, scale=scale, unit=unit))
        for name, low, high in zip(names, lows, highs, strict=True)
    }
    made: type[Command] = create_model(title, __base__=Command, __module__=__name__, **fields)
    made.amplification = {"command": {tuple(names): "outward"}}
    made.vocabulary = vocabulary_of(made)
    return made
