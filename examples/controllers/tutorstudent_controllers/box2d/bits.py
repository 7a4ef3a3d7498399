"""What a student sees of an environment: the controller's situation, and chosen numbers as thermometers."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import tutorstudent as ts
from tutorstudent.sims.gym import GymState


class Number(ts.Options):
    """One number of the observation."""

    index: int = ts.Field(ge=0, description="its place in the observation, from 0")
    above: tuple[float, ...] = ts.Field(min_length=1, description="one bit for each of these that it exceeds")


class ObservationBits(ts.Encoder[GymState, Any]):
    """One bit for each named situation, then one for each threshold that a number of the observation exceeds."""

    name = "observation-bits"

    class Options(ts.Options):
        """Which situations, and which numbers."""

        situations: tuple[str, ...] = ts.Field((), description="situations of the tutor, by name")
        numbers: tuple[Number, ...] = ts.Field(min_length=1, description="numbers of the observation")

    @property
    def width(self) -> int:
        return len(self.options.situations) + sum(len(number.above) for number in self.options.numbers)

    def encode(self, moment: ts.Moment[GymState, Any]) -> NDArray[np.float64]:
        situations = [moment.situation == name for name in self.options.situations]
        seen = np.ravel(moment.state.observation)
        bits = [seen[number.index] > step for number in self.options.numbers for step in number.above]
        return np.array([*situations, *bits], dtype=np.float64)
