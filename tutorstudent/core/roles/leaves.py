"""The small roles: what students, amplifiers and evaluators are made of.

Each is an ABC with a name and options; a decorator makes one of a plain function.
"""

from __future__ import annotations

import abc
from collections.abc import Callable, Sequence
from typing import Any, ClassVar, Generic

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.roles.part import EnginePart
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.errors import ContractError, quote
from tutorstudent.core.words.proposals import ProposalT
from tutorstudent.core.words.records import GradedAction, Moment, StateT

Vector = NDArray[np.float64]


class Encoder(EnginePart, Generic[StateT, ActionT]):
    """Turns a moment into the numbers that a student sees (Thesis 3.3.2: a binary representation of the sensors)."""

    role: ClassVar[str] = "encoder"

    @property
    @abc.abstractmethod
    def width(self) -> int:
        """Number of inputs; known after binding."""

    @abc.abstractmethod
    def encode(self, moment: Moment[StateT, ActionT]) -> Vector:
        """Return the inputs, shape (width,). May reuse its buffer; must not change the moment."""


class Codec(EnginePart, Generic[ProposalT]):
    """Translates between a student's numbers and what they mean: kind, level, ampbit (Thesis 3.3.2)."""

    role: ClassVar[str] = "codec"
    proposal: ClassVar[type[Any]]
    """The proposal type that `decode` returns."""

    @property
    @abc.abstractmethod
    def width(self) -> int:
        """Number of outputs; known after binding."""

    @abc.abstractmethod
    def encode(self, target: GradedAction[Any]) -> Vector:
        """Return the outputs to be learned, shape (width,), each in [0, 1]."""

    @abc.abstractmethod
    def decode(self, outputs: Vector) -> ProposalT:
        """Return the proposal that the outputs, shape (width,), stand for."""


class Change(EnginePart):
    """How far an amplification moves a component, as a fraction of the component's scale (Thesis 3.3.2, 5.2.2)."""

    role: ClassVar[str] = "change"

    @abc.abstractmethod
    def fraction(self, amplification: float, magnitude: float) -> float:
        """Return the distance to move, >= 0, in units of the component's scale.

        Args:
            amplification: level x amount.
            magnitude: The tutor's own distance from neutral, in units of the component's scale.
        """


class Condition(EnginePart, Generic[StateT]):
    """An operational condition: true means violated (Thesis 3.2.2.5). It may also declare margins; 0 means violated."""

    role: ClassVar[str] = "condition"

    @property
    def label(self) -> str:
        """What violations of it are recorded as; unique within a pipeline."""
        return self.name

    @abc.abstractmethod
    def violated(self, state: StateT) -> bool:
        """Return whether the state violates the condition. Called once per decision, on the resulting state."""

    def margins(self, state: StateT) -> Sequence[float] | None:
        """Return how far the state is from a violation, in units of its own, or None if the condition cannot tell."""
        return None


def encoder(name: str, width: int) -> Callable[[Callable[[Any], Any]], type[Encoder[Any, Any]]]:
    """Make an encoder of a function of a moment that returns `width` numbers."""

    def decorate(function: Callable[[Any], Any]) -> type[Encoder[Any, Any]]:
        def encode(_self: Encoder[Any, Any], moment: Moment[Any, Any]) -> Vector:
            return np.asarray(function(moment), dtype=np.float64)

        body = {"width": property(lambda _self: width), "encode": encode}
        return _make_leaf(Encoder, name, function, body)

    return decorate


def change(name: str) -> Callable[[Callable[[float, float], float]], type[Change]]:
    """Make a change of a function of (amplification, magnitude)."""

    def decorate(function: Callable[[float, float], float]) -> type[Change]:
        def fraction(_self: Change, amplification: float, magnitude: float) -> float:
            return function(amplification, magnitude)

        return _make_leaf(Change, name, function, {"fraction": fraction})

    return decorate


def condition(name: str) -> Callable[[Callable[[Any], bool]], type[Condition[Any]]]:
    """Make a condition of a predicate on a state.

    >>> @condition("too-hot")
    ... def too_hot(celsius):
    ...     return celsius > 80
    >>> too_hot().violated(90)
    True
    """

    def decorate(function: Callable[[Any], bool]) -> type[Condition[Any]]:
        def violated(_self: Condition[Any], state: Any) -> bool:
            return function(state)

        return _make_leaf(Condition, name, function, {"violated": violated})

    return decorate


def _make_leaf(base: type[Any], name: str, function: Callable[..., Any], body: dict[str, Any]) -> type[Any]:
    if not callable(function):
        raise ContractError(
            f"{base.role} '{name}': found {quote(function)}; expected a function, as in lambda y: y > 80."
        )
    like = function if hasattr(function, "__name__") else type(function)  # of an object, its class
    described = {"name": name, "__doc__": like.__doc__, "__module__": like.__module__}
    body |= {"__wrapped__": staticmethod(function)}  # its annotations say what it is made for
    return type(like.__name__, (base,), described | body)
