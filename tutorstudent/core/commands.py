"""Action classes for controllers that return numbers: one number, or a fixed number of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

import numpy as np
from pydantic import create_model

from tutorstudent.core.actions import Action, component, vocabulary_of
from tutorstudent.core.errors import ContractError


class Command(Action):
    """An action of one kind that stands for the owner's own command, a number or an array of numbers."""

    as_array: ClassVar[bool] = False

    @classmethod
    def read(cls, command: Any) -> Command:
        """Return the action that an owner's command stands for."""
        names = list(cls.vocabulary.components)
        values = np.asarray(command, dtype=np.float64).ravel().tolist()
        if len(values) != len(names):
            raise ContractError(f"the controller returned {command!r}; expected {len(names)} number(s).")
        return cls.model_validate(dict(zip(names, values, strict=True)))

    def write(self, like: Any) -> Any:
        """Return the command in the type and shape of `like`."""
        values = [getattr(self, name) for name in self.vocabulary.components]
        if isinstance(like, np.ndarray):
            dtype = like.dtype if like.dtype.kind == "f" else np.float64
            return np.array(values, dtype=dtype).reshape(like.shape)
        if isinstance(like, list | tuple):
            return type(like)(values)
        return type(like)(values[0]) if isinstance(like, np.floating) else values[0]


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
