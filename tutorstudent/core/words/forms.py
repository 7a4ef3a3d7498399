"""How an owner's command is read as numbers, and written again in the owner's own type."""

from __future__ import annotations

import abc
import copy
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from tutorstudent.core.words.errors import ContractError, quote

Numbers = list[float]


class Form(abc.ABC):
    """Reads a command as a fixed number of floats, and writes floats in the type of a command."""

    @abc.abstractmethod
    def read(self, command: Any) -> Numbers:
        """Return the command's numbers.

        Raises:
            ContractError: if it is not of this form.
        """

    @abc.abstractmethod
    def write(self, numbers: Numbers, like: Any) -> Any:
        """Return a new command with these numbers, in the type of `like`.

        `like` is the last command that `read` took, or None where there was none yet.
        """

    def fit(self, numbers: Numbers, like: Any) -> Numbers:
        """Return the numbers as the type of `like` can hold them; what it cannot hold is rounded towards its own."""
        return numbers

    def compare_rest(self, command: Any, written: Any) -> str | None:
        """Return the name of something beside the numbers in which two commands differ, or None."""
        return None


class PlainForm(Form):
    """A number, or one of `SEQUENCES` of numbers."""

    def __init__(self, size: int) -> None:
        self._size = size

    def read(self, command: Any) -> Numbers:
        if type(command) is float and self._size == 1:
            return [command]
        items = _list_items(command)
        if len(items) != self._size or not all(map(is_number, items)):
            raise ContractError(
                f"the controller's command is {quote(command)}; expected {_describe(self._size)}. "
                "Other commands are read by their names, as in ts.vector(-1, 1, names=['speed', 'turn']), "
                "or by functions of yours: ts.scalar(-1, 1, read=..., write=...)."
            )
        return [read_float(item, "it", command) for item in items]

    def fit(self, numbers: Numbers, like: Any) -> Numbers:
        if type(like) is float:
            return numbers
        return [fit_number(item, number) for item, number in zip(_list_items(like), numbers, strict=True)]

    def write(self, numbers: Numbers, like: Any) -> Any:
        if like is None:
            return numbers if self._size > 1 else numbers[0]
        numbers, sequence = self.fit(numbers, like), _find_sequence(like)
        return sequence.write(like, numbers) if sequence else match_type(like, numbers[0])

    def compare_rest(self, command: Any, written: Any) -> str | None:
        if _find_sequence(command) and type(written) is not type(command):
            return f"the type to {type(written).__name__}"
        return None


class OwnForm(Form):
    """A pair of the owner's own functions."""

    def __init__(self, size: int, read: Callable[[Any], Any], write: Callable[[Any, Any], Any]) -> None:
        self._plain, self._size = PlainForm(size), size
        self._read, self._write = read, write

    def read(self, command: Any) -> Numbers:
        try:
            found = self._read(command)
        except Exception as error:
            raise ContractError(
                f"the controller's command is {quote(command)}: read= raised {type(error).__name__}: {error}."
            ) from error
        try:
            return self._plain.read(found)
        except ContractError:
            raise ContractError(
                f"the controller's command is {quote(command)}: read= returned {quote(found)}; "
                f"expected {_describe(self._size)}."
            ) from None

    def write(self, numbers: Numbers, like: Any) -> Any:
        written = self._write(like, numbers if self._size > 1 else numbers[0])
        if written is None:
            raise ContractError("write= returned nothing; it has to return a new command to execute.")
        return written


def fit_number(like: Any, number: float) -> float:
    """Return a number as the type of one of the owner's holds it, rounded towards the owner's.

    >>> float(np.float32(0.1)) > 0.1, fit_number(np.float32(0.09), 0.1) <= 0.1
    (True, True)
    >>> fit_number(np.float16(60000), 78000.0)
    65504.0
    """
    if not isinstance(like, np.floating):
        return number
    own = float(like)
    with np.errstate(over="ignore"):
        cast = type(like)(number)
        if not min(own, number) <= float(cast) <= max(own, number):  # numpy would compare in its own precision
            cast = np.nextafter(cast, like)
    return float(cast)


def match_type(like: Any, number: float) -> Any:
    """Return a number in the type of the owner's number `like`; `like` itself where they are equal.

    An amplified whole number becomes a float: rounding it could exceed the limits.

    >>> match_type(Decimal("0.5"), 0.55), match_type(3, 3.9), match_type(3, 3.0)
    (Decimal('0.55'), 3.9, 3)
    """
    if type(like) is float or float(like) == number:
        return number if type(like) is float else like
    if isinstance(like, Decimal | Fraction):
        return type(like)(repr(number))  # the shortest decimal, not the binary fraction next to it
    return type(like)(number) if isinstance(like, float | np.floating) else number


class SequenceType(NamedTuple):
    """A type of sequences: what messages call it, how its numbers are read, and how one like it is written."""

    title: str
    read: Callable[[Any], list[Any]]
    """Returns the items in their own types, such as numpy's floats."""
    write: Callable[[Any, Numbers], Any]
    """``write(like, numbers)`` returns a new sequence with numbers that the items of `like` can hold."""


def _match_items(like: Any, numbers: Numbers) -> list[Any]:
    return [match_type(item, number) for item, number in zip(like, numbers, strict=True)]


def _write_tuple(like: Any, numbers: Numbers) -> Any:
    items = _match_items(like, numbers)
    return like._make(items) if hasattr(like, "_make") else type(like)(items)


def _write_list(like: Any, numbers: Numbers) -> Any:
    if type(like) is list:
        return _match_items(like, numbers)
    copied = copy.copy(like)
    copied[:] = _match_items(like, numbers)
    return copied


def _read_array(array: Any) -> list[Any]:
    return list(array.ravel()) if array.dtype.kind in "fiu" else [array]


def _write_array(like: Any, numbers: Numbers) -> Any:
    return np.array(numbers, dtype=like.dtype if like.dtype.kind == "f" else np.float64).reshape(like.shape)


SEQUENCES: dict[type[Any], SequenceType] = {
    list: SequenceType("list", list, _write_list),
    tuple: SequenceType("tuple", list, _write_tuple),
    np.ndarray: SequenceType("numpy array", _read_array, _write_array),
}
"""What is read as it is, without names and functions; one more is a line here."""


def _find_sequence(command: Any) -> SequenceType | None:
    if (found := SEQUENCES.get(type(command))) is not None:
        return found
    return next((sequence for kind, sequence in SEQUENCES.items() if isinstance(command, kind)), None)


def _list_items(command: Any) -> list[Any]:
    sequence = _find_sequence(command)
    return sequence.read(command) if sequence else [command]


def _describe(size: int) -> str:
    *first, last = [sequence.title for sequence in SEQUENCES.values()]
    return "a number" if size == 1 else f"a {', '.join(first)} or {last} of {size} numbers"


def is_number(item: Any) -> bool:
    """Return whether an item is one number; a bool, a string or an array is none."""
    return isinstance(item, float | int | np.floating | np.integer | Decimal | Fraction) and not isinstance(item, bool)


def read_float(item: Any, name: str, command: Any) -> float:
    """Return a number of a command as a float; `name` says in the message which one it is."""
    try:
        return float(item)
    except (OverflowError, ValueError):
        raise ContractError(f"the controller's command is {quote(command)}: {name} is no finite float.") from None
