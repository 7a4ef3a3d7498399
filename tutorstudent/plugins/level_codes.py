"""How levels and bits become numbers in [0, 1] and back.

The thesis says only that the outputs are binary (3.3.2); the thermometer and analogue codes are there to compare with.
"""

from __future__ import annotations

import abc
import math
from collections.abc import Sequence
from typing import Any, ClassVar, Literal

from tutorstudent.core.roles.leaves import Vector
from tutorstudent.core.roles.part import Field, Options
from tutorstudent.core.words.records import GradedAction

THRESHOLD = 0.5
"""An output above it is read as 1 (Choice, see docs/fidelity.md)."""


def to_bits(number: int, width: int) -> tuple[float, ...]:
    """Return the lowest `width` binary digits of a number, the most significant first.

    >>> to_bits(6, 4)
    (0.0, 1.0, 1.0, 0.0)
    """
    return tuple(float(number >> digit & 1) for digit in reversed(range(width)))


def from_bits(values: Sequence[float]) -> int:
    """Return the number whose binary digits the values are, the most significant first.

    >>> from_bits([0.1, 0.9, 0.6, 0.4])
    6
    """
    number = 0
    for value in values:
        number = 2 * number + (value > THRESHOLD)
    return number


def require_finite(outputs: Vector, width: int) -> list[float]:
    """Return a student's outputs as floats.

    Raises:
        ValueError: The outputs have not the shape (width,), or one of them is not finite.
    """
    if outputs.shape != (width,):
        raise ValueError(f"outputs have the shape {outputs.shape}; this codec reads ({width},).")
    values: list[float] = outputs.tolist()
    if not all(map(math.isfinite, values)):
        index = next(i for i, value in enumerate(values) if not math.isfinite(value))
        raise ValueError(f"output {index} is {values[index]}; a codec reads finite numbers.")
    return values


class LevelCode(abc.ABC):
    """A code for the levels 0 to `max_level`.

    Args:
        max_level: The highest level that the code can say, at least 1.
    """

    def __init__(self, max_level: int) -> None:
        self.max_level = max_level

    @property
    @abc.abstractmethod
    def width(self) -> int:
        """How many numbers a level takes."""

    @abc.abstractmethod
    def encode(self, level: int) -> tuple[float, ...]:
        """Return the numbers of a level in 0 to `max_level`, each in [0, 1]."""

    @abc.abstractmethod
    def decode(self, values: Sequence[float]) -> int:
        """Return the level in 0 to `max_level` that finite numbers stand for."""


class BinaryLevel(LevelCode):
    """Binary digits, the most significant first; a code above `max_level` is read as `max_level`.

    >>> BinaryLevel(7).encode(6)
    (1.0, 1.0, 0.0)
    """

    @property
    def width(self) -> int:
        return self.max_level.bit_length()

    def encode(self, level: int) -> tuple[float, ...]:
        return to_bits(level, self.width)

    def decode(self, values: Sequence[float]) -> int:
        return min(from_bits(values), self.max_level)


class ThermometerLevel(LevelCode):
    """As many ones as the level; a reading counts them, wherever they stand.

    >>> ThermometerLevel(4).encode(3)
    (1.0, 1.0, 1.0, 0.0)
    """

    @property
    def width(self) -> int:
        return self.max_level

    def encode(self, level: int) -> tuple[float, ...]:
        return (1.0,) * level + (0.0,) * (self.max_level - level)

    def decode(self, values: Sequence[float]) -> int:
        return sum(value > THRESHOLD for value in values)


class AnalogueLevel(LevelCode):
    """One number, level / `max_level`; a reading takes the nearest level, halves upwards.

    >>> AnalogueLevel(4).encode(3)
    (0.75,)
    """

    @property
    def width(self) -> int:
        return 1

    def encode(self, level: int) -> tuple[float, ...]:
        return (level / self.max_level,)

    def decode(self, values: Sequence[float]) -> int:
        return math.floor(min(max(values[0], 0.0), 1.0) * self.max_level + 0.5)


class GradeOptions(Options):
    """How a codec says a level."""

    level: Literal["binary", "thermometer", "analogue"] = Field("binary", description="code of the level")
    max_level: int = Field(7, ge=1, le=255, description="highest level that can be taught (7 for three bits)")
    overflow: Literal["clip", "wrap"] = Field(
        "clip", description="how a level above max_level is taught: as max_level, or modulo max_level + 1"
    )


class GradeCode:
    """The code of a grade: a level, then the ampbit (Thesis 3.3.2).

    Args:
        options: The level's code, its maximum and its overflow.
    """

    CODES: ClassVar[dict[str, type[LevelCode]]] = {
        "binary": BinaryLevel,
        "thermometer": ThermometerLevel,
        "analogue": AnalogueLevel,
    }

    def __init__(self, options: GradeOptions) -> None:
        self._level = self.CODES[options.level](options.max_level)
        self._wraps = options.overflow == "wrap"
        self._codes: dict[tuple[int, bool], tuple[float, ...]] = {}
        self.width = self._level.width + 1
        """How many numbers a grade takes."""

    def encode(self, target: GradedAction[Any]) -> tuple[float, ...]:
        """Return the numbers of a target's level and ampbit.

        Raises:
            ValueError: The level is below 0.
        """
        grade = (target.level, target.ampbit)
        if grade not in self._codes:
            self._codes[grade] = self._encode(*grade)
        return self._codes[grade]

    def decode(self, values: Sequence[float]) -> tuple[int, bool]:
        """Return the level and the ampbit that finite numbers stand for."""
        return self._level.decode(values[:-1]), values[-1] > THRESHOLD

    def _encode(self, level: int, ampbit: bool) -> tuple[float, ...]:
        if level < 0:
            raise ValueError(f"level {level} cannot be taught; levels start at 0.")
        return (*self._level.encode(self._fit_level(level)), float(ampbit))

    def _fit_level(self, level: int) -> int:
        highest = self._level.max_level
        return level % (highest + 1) if self._wraps else min(level, highest)
