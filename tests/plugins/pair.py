"""States of two numbers, and the encoder that hands them on."""

from __future__ import annotations

import numpy as np

import tutorstudent as ts
from tutorstudent.core.words.records import Moment
from tutorstudent.sims.pioneer.types import DriveAction

State = tuple[float, ...]


class Pair(ts.Encoder[State, DriveAction]):
    """The two numbers of the state."""

    name = "pair"

    @property
    def width(self) -> int:
        return 2

    def encode(self, moment: Moment[State, DriveAction]) -> np.ndarray:
        return np.array(moment.state, dtype=float)


def moment(state: State, number: int = 0) -> Moment[State, DriveAction]:
    return Moment(number, state, DriveAction(kind="forward"), "")
