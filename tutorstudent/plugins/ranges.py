"""An encoder for states that are plain numbers of known ranges."""

from __future__ import annotations

import math
import operator
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from types import SimpleNamespace
from typing import Any

import numpy as np

from tutorstudent.core.roles import part
from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.leaves import Encoder, Vector
from tutorstudent.core.roles.part import Component, Field
from tutorstudent.core.words.actions import ComponentSpec
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.records import Moment


class Ranges(Encoder[Any, Any]):
    """Thermometer codes of the tutor's components and of the state's numbers, `steps` bits each.

    A component ranges over its bounds, or one scale either side of neutral where it has none. The state's numbers are
    coded where ranges are declared for them; without ranges the state is not looked at. The numbers are those of a
    sequence, an array, a mapping or a dataclass, in its order, or of the part of the state that `of` names.
    """

    name = "ranges"

    class Options(part.Options):
        """The ranges of the state's numbers."""

        ranges: list[tuple[float, float]] = Field(
            default=[], description="low and high of each number of the state, in the state's own units"
        )
        of: str = Field(
            default="",
            pattern=r"^(\w+(\.\w+)*)?$",
            description="attribute of the state that has the numbers, as in observation or pose.position; "
            "empty: the state itself",
        )
        steps: int = Field(default=8, ge=1, description="bits for each number")

    def setup(self) -> None:
        self._part = operator.attrgetter(self.options.of) if self.options.of else None
        specs = [spec for spec in self.action_class.vocabulary.components.values() if math.isfinite(spec.scale)]
        self._components = [spec.name for spec in specs]
        bounds = [*map(_find_range, specs), *self.options.ranges]
        if any(not low < high for low, high in bounds):
            raise ContractError("encoder 'ranges': every range is a low and a high number, low below high.")
        low, high = np.array(bounds).T
        steps = self.options.steps
        fractions = (np.arange(steps) + 1) / (steps + 1)
        self._thresholds = low[:, None] + (high - low)[:, None] * fractions
        self._numbers = np.empty((len(bounds), 1))

    @property
    def width(self) -> int:
        return int(self._thresholds.size)

    def examples(self) -> list[Any]:
        """Return states to try it with: the ends and the middle of every range."""
        found: list[Any] = [
            [low + share * (high - low) for low, high in self.options.ranges] for share in (0.0, 0.5, 1.0)
        ]
        for name in reversed(self.options.of.split(".") if self.options.of else []):
            found = [SimpleNamespace(**{name: state}) for state in found]
        return found

    def encode(self, moment: Moment[Any, Any]) -> Vector:
        """Return the bits, shape (width,): of each component in the action class's order, then of each state number.

        The bits of a number ascend; each is 1 where the number lies above its threshold. A number beyond its range has
        all bits 0 or all 1.

        Raises:
            ValueError: if the state has not as many numbers as there are ranges.
        """
        own, numbers = len(self._components), self._numbers[:, 0]
        for index, name in enumerate(self._components):
            numbers[index] = getattr(moment.tutor_action, name)
        if self.options.ranges:
            state = _read_array(moment.state if self._part is None else self._part(moment.state))
            if state.size != len(numbers) - own:
                raise ValueError(f"the state has {state.size} numbers; {len(self.options.ranges)} ranges are declared.")
            numbers[own:] = state.ravel()
        bits: Vector = np.greater(self._numbers, self._thresholds, out=np.empty(self._thresholds.shape))
        return bits.ravel()


def _find_range(spec: ComponentSpec) -> tuple[float, float]:
    low = spec.low if math.isfinite(spec.low) else spec.neutral - spec.scale
    high = spec.high if math.isfinite(spec.high) else spec.neutral + spec.scale
    return low, high


def _read_array(state: Any) -> Vector:
    numbers = state
    if isinstance(state, Mapping):
        numbers = list(state.values())
    elif is_dataclass(state):
        numbers = [getattr(state, field.name) for field in fields(state)]
    try:
        return np.asarray(numbers, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError(
            f"a {type(state).__name__} is no plain list of numbers; name the part of it that has them with 'of', "
            "as in of: observation."
        ) from None


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the encoder."""
    return [Ranges]
