"""What a student sees of a Pioneer: 14 bits (Thesis 3.3.2, Table 1).

Choice: which 14, see docs/fidelity.md. In every encoder a bit is 1 where the named thing holds and 0 where it does not;
``names`` lists them in order.
"""

from __future__ import annotations

import abc
from typing import ClassVar

import numpy as np

from tutorstudent.core.roles.leaves import Encoder, Vector
from tutorstudent.core.words.records import Moment
from tutorstudent.plugins.prototype2.percept import Percept, perceive
from tutorstudent.plugins.prototype2.planner_options import BitThresholds, ThermometerThresholds
from tutorstudent.plugins.prototype2.rules import RULES
from tutorstudent.sims.pioneer.types import DriveAction, PioneerState

PioneerMoment = Moment[PioneerState, DriveAction]
Code = tuple[bool, ...]

PREY_NAMES = ("prey left", "prey centre", "prey right", "prey near")
PREDATOR_NAMES = ("predator seen", "predator near")


class BitEncoder(Encoder[PioneerState, DriveAction]):
    """An encoder of named bits."""

    Options = BitThresholds
    names: ClassVar[tuple[str, ...]]
    """What each bit says, in order."""

    @property
    def width(self) -> int:
        return len(self.names)

    def setup(self) -> None:
        self._inputs = np.zeros(self.width)

    def encode(self, moment: PioneerMoment) -> Vector:
        """Return the bits, shape (14,). The array is used again by the next call."""
        self._inputs[:] = self.code(moment, perceive(moment.state))
        return self._inputs

    @abc.abstractmethod
    def code(self, moment: PioneerMoment, seen: Percept) -> Code:
        """Return the bits of a moment whose state looks like `seen`, in the order of `names`."""

    def code_prey(self, seen: Percept) -> Code:
        """Return the bits of `PREY_NAMES`: one of three directions where any is seen, and whether it is near."""
        limits = self.options
        left, right = seen.prey_rad > limits.centre_rad, seen.prey_rad < -limits.centre_rad
        return left, seen.prey_seen and not (left or right), right, seen.prey_m < limits.prey_m

    def code_predator(self, seen: Percept) -> Code:
        """Return the bits of `PREDATOR_NAMES`."""
        return seen.predator_seen, seen.predator_m < self.options.predator_m


class Bits(BitEncoder):
    """Sensors only, with two thresholds ahead and on each side."""

    name = "prototype2-bits"
    names = (
        "front limited",
        "front blocked",
        "left limited",
        "left blocked",
        "right limited",
        "right blocked",
        "back blocked",
        "stalled",
        *PREY_NAMES,
        *PREDATOR_NAMES,
    )

    def code(self, moment: PioneerMoment, seen: Percept) -> Code:
        limits = self.options
        return (
            seen.front_m < limits.clear_m,
            seen.front_m < limits.front_m,
            seen.left_m < limits.side_limited_m,
            seen.left_m < limits.side_m,
            seen.right_m < limits.side_limited_m,
            seen.right_m < limits.side_m,
            seen.back_m < limits.back_m,
            seen.stalled,
            *self.code_prey(seen),
            *self.code_predator(seen),
        )


class Thermometer(BitEncoder):
    """Sensors only, with the distance ahead in four steps: the nearer, the more bits are set."""

    name = "prototype2-thermometer"
    Options = ThermometerThresholds
    names = (
        "front within step 4",
        "front within step 3",
        "front within step 2",
        "front within step 1",
        "left blocked",
        "right blocked",
        "back blocked",
        "stalled",
        *PREY_NAMES,
        *PREDATOR_NAMES,
    )

    def code(self, moment: PioneerMoment, seen: Percept) -> Code:
        limits = self.options
        one, two, three, four = limits.front_steps_m
        front = seen.front_m
        return (
            front < four,
            front < three,
            front < two,
            front < one,
            seen.left_m < limits.side_m,
            seen.right_m < limits.side_m,
            seen.back_m < limits.back_m,
            seen.stalled,
            *self.code_prey(seen),
            *self.code_predator(seen),
        )


class SituationBits(BitEncoder):
    """The state of prototype 2's planner as a binary number, the side it turns to, and fewer sensors.

    The states are numbered in the order of the rule table; a situation that is none of them is number 7.
    """

    name = "prototype2-situation-bits"
    names = (
        "state 4",
        "state 2",
        "state 1",
        "turns left",
        "front limited",
        "front blocked",
        "left blocked",
        "right blocked",
        "stalled",
        *PREY_NAMES,
        "predator near",
    )
    _numbers: ClassVar[dict[str, int]] = {state: number for number, state in enumerate(RULES)}

    def code(self, moment: PioneerMoment, seen: Percept) -> Code:
        limits = self.options
        number = self._numbers.get(moment.situation, 7)
        return (
            number >= 4,
            number & 2 > 0,
            number & 1 > 0,
            moment.tutor_action.kind == "left",
            seen.front_m < limits.clear_m,
            seen.front_m < limits.front_m,
            seen.left_m < limits.side_m,
            seen.right_m < limits.side_m,
            seen.stalled,
            *self.code_prey(seen),
            seen.predator_m < limits.predator_m,
        )
