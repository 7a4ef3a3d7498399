"""What the student sees of the plate, what it must not do, and what is counted."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

import tutorstudent as ts
from tutorstudent_controllers.pid.state import Heat, PlateState
from tutorstudent_controllers.pid.tutor import NEW_SETPOINT


class Approach(ts.Encoder[PlateState, Heat]):
    """How much is missing, how much of it is on its way, and how hard the controller pushes: 12 bits, thermometers."""

    name = "plate-approach"

    class Options(ts.Options):
        """The thresholds."""

        missing_k: tuple[float, ...] = ts.Field((-0.5, 0.5, 2.0, 5.0, 10.0), description="missing temperature, K")
        coming_k: tuple[float, ...] = ts.Field((-0.5, 0.5, 2.0, 5.0), description="the same after the horizon, K")
        horizon_s: float = ts.Field(4.0, ge=0, description="how far ahead the slope is carried on, s")
        push: tuple[float, ...] = ts.Field((0.0, 0.3, 0.6), description="power in the direction of the step")

    @property
    def width(self) -> int:
        return len(self.options.missing_k) + len(self.options.coming_k) + len(self.options.push)

    def encode(self, moment: ts.Moment[PlateState, Heat]) -> NDArray[np.float64]:
        state, options = moment.state, self.options
        coming_k = state.missing_k - options.horizon_s * state.closing_kps
        push = state.direction * moment.tutor_action.power
        pairs = ((state.missing_k, options.missing_k), (coming_k, options.coming_k), (push, options.push))
        return np.array([float(value > step) for value, steps in pairs for step in steps])


class Overshoot(ts.Condition[PlateState]):
    """The reading went beyond the setpoint, as seen from where the step began, or will have after a horizon."""

    name = "overshoot"

    class Options(ts.Options):
        """How far is too far, and how far ahead."""

        limit_k: float = ts.Field(1.0, ge=0, description="allowed overshoot, K")
        horizon_s: float = ts.Field(0.0, ge=0, description="how far ahead the present slope is carried on, s")

    def violated(self, state: PlateState) -> bool:
        return self.margins(state)[0] < 0

    def margins(self, state: PlateState) -> Sequence[float]:
        coming_k = state.missing_k - self.options.horizon_s * max(0.0, state.closing_kps)
        return [coming_k + self.options.limit_k]


class StepsDone(ts.Entries):
    """Counts the temperatures that were reached and held: the recipe asks for a new one then."""

    name = "steps-done"
    situation = NEW_SETPOINT
    counted = "steps"
