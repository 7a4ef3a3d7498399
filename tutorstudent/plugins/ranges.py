"""An encoder for states that are plain numbers of known ranges."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from types import SimpleNamespace
from typing import Annotated, Any

import numpy as np
from pydantic import StringConstraints, field_validator

from tutorstudent.core.roles import part
from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.leaves import Encoder, Vector
from tutorstudent.core.roles.part import Component, Field
from tutorstudent.core.words.actions import ComponentSpec
from tutorstudent.core.words.errors import ContractError, UnreadableState, list_names, quote, suggest
from tutorstudent.core.words.forms import is_number
from tutorstudent.core.words.named_form import get_member
from tutorstudent.core.words.proposals import require_number
from tutorstudent.core.words.records import Moment
from tutorstudent.core.words.snapshots import Hidden, list_members

Range = tuple[float, float]
Name = Annotated[str, StringConstraints(pattern=r"^\w+(\.\w+)*$")]


class Ranges(Encoder[Any, Any]):
    """Thermometer codes of the tutor's components and of the state's numbers, `steps` bits each.

    A component ranges over its bounds, or one scale either side of neutral where it has none. The state's numbers are
    coded where ranges are declared for them; without ranges the state is not looked at. Ranges by name read the keys
    and attributes of these names. A list of ranges reads all numbers of a sequence, an array, a mapping or a dataclass,
    in its order. Either reads the state itself, or the part of it that `of` names.
    """

    name = "ranges"

    class Options(part.Options):
        """The ranges of the state's numbers."""

        ranges: list[Range] | dict[Name, Range] = Field(
            default=[],
            description="low and high of each number of the state, in its own units, as in [[0, 100], [-1, 1]]; "
            "or of those that are named, as in {pose.x: [0, 5]}; of a single number also as in [0, 100]",
        )
        of: str = Field(
            default="",
            pattern=r"^(\w+(\.\w+)*)?$",
            description="attribute or key of the state that has the numbers, as in observation or pose.position; "
            "empty: the state itself",
        )
        steps: int = Field(default=8, ge=1, description="bits for each number")

        @field_validator("ranges", mode="before")
        @classmethod
        def _list_single(cls, value: Any) -> Any:
            is_pair = isinstance(value, list | tuple) and len(value) == 2 and all(map(is_number, value))
            return [value] if is_pair else value

    def setup(self) -> None:
        declared = self.options.ranges
        self._names = list(declared) if isinstance(declared, Mapping) else []
        specs = [spec for spec in self.action_class.vocabulary.components.values() if math.isfinite(spec.scale)]
        self._components = [spec.name for spec in specs]
        bounds = [*map(_find_range, specs), *(declared.values() if self._names else declared)]
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
        declared, of = self.options.ranges, self.options.of
        ranges = list(declared.values() if self._names else declared)
        found = [[low + share * (high - low) for low, high in ranges] for share in (0.0, 0.5, 1.0)]
        names = self._names
        states = [_make_state(dict(zip(names, numbers, strict=True))) if names else numbers for numbers in found]
        return [_make_state({of: state}) if of else state for state in states]

    def encode(self, moment: Moment[Any, Any]) -> Vector:
        """Return the bits, shape (width,): of each component in the action class's order, then of each state number.

        The bits of a number ascend; each is 1 where the number lies above its threshold. A number beyond its range has
        all bits 0 or all 1.

        Raises:
            UnreadableState: if the state has not the numbers for which there are ranges.
        """
        own, numbers = len(self._components), self._numbers[:, 0]
        for index, name in enumerate(self._components):
            numbers[index] = getattr(moment.tutor_action, name)
        if len(numbers) > own:
            try:
                numbers[own:] = self._read(moment.state, len(numbers) - own)
            except (TypeError, ValueError) as error:
                raise UnreadableState(f"encoder 'ranges': {error}", slot=self.slot) from None
        bits: Vector = np.greater(self._numbers, self._thresholds, out=np.empty(self._thresholds.shape))
        return bits.ravel()

    def _read(self, state: Any, count: int) -> Vector | list[float]:
        owner = _reach(state, self.options.of) if self.options.of else state
        if self._names:
            return [_read_number(owner, name) for name in self._names]
        numbers = _read_array(owner)
        if numbers.size != count:
            raise ValueError(
                f"the state has {_count(numbers.size, 'number')}, but {_count(count, 'range')} declared in 'ranges'. "
                "Declare one for each number, or name those that matter, as in ranges: {pose.x: [0, 5]}."
            )
        return numbers.ravel()


def _count(number: int, what: str) -> str:
    verb = {"range": " is" if number == 1 else " are"}.get(what, "")
    return f"{number} {what}{'s' * (number != 1)}{verb}"


def _make_state(numbers: Mapping[str, Any]) -> SimpleNamespace:
    """Return an object in which these dotted names lead to these values."""
    state = SimpleNamespace()
    for name, value in numbers.items():
        *way, last = name.split(".")
        owner = state
        for step in way:
            vars(owner).setdefault(step, SimpleNamespace())
            owner = getattr(owner, step)
        setattr(owner, last, value)
    return state


def _reach(state: Any, name: str) -> Any:
    found = state
    for step in name.split("."):
        try:
            found = get_member(found, step)
        except (AttributeError, KeyError):
            known = list_members(found)
            has = f"; it has {list_names(known)}" if known else ""
            raise ValueError(
                f"'{name}' is not in the state: {type(found).__name__} has no '{step}'{suggest(step, known)}{has}. "
                "Correct the name in 'ranges' or 'of'."
            ) from None
    return found


def _read_number(owner: Any, name: str) -> float:
    found = _reach(owner, name)
    try:
        return require_number(found)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(
            f"'{name}' of the state is {quote(found)}, not a number. Name a number in 'ranges', as in "
            "ranges: {pose.x: [0, 5]}."
        ) from None


def _find_range(spec: ComponentSpec) -> tuple[float, float]:
    low = spec.low if math.isfinite(spec.low) else spec.neutral - spec.scale
    high = spec.high if math.isfinite(spec.high) else spec.neutral + spec.scale
    return low, high


def _read_array(state: Any) -> Vector:
    if isinstance(state, Hidden):
        float(state)  # raises, and says why
    numbers = state
    if isinstance(state, Mapping):
        numbers = list(state.values())
    elif is_dataclass(state):
        numbers = [getattr(state, field.name) for field in fields(state)]
    try:
        return np.asarray(numbers, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError(
            f"a {type(state).__name__} is no plain list of numbers. Name its numbers, as in "
            "ranges: {pose.x: [0, 5], speed: [0, 1]}, or the part of it that has them with 'of', as in of: observation."
        ) from None


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the encoder."""
    return [Ranges]
