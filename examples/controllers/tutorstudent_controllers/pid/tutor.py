"""The controller of the package simple-pid as a tutor."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import tutorstudent as ts
from tutorstudent_controllers.missing import explain_missing
from tutorstudent_controllers.pid.state import Heat, PlateState

if TYPE_CHECKING:
    from simple_pid import PID

NEW_SETPOINT = "New setpoint"
FOLLOWING = "Following"


class SimplePid(ts.Tutor[PlateState, Heat]):
    """A `simple_pid.PID`, called once per decision. The defaults are Skogestad's rule (SIMC) for the default plate.

    SIMC with a closed-loop time constant equal to the dead time: gain = lag / (plate gain x 2 x dead time), integral
    time = lag (Skogestad 2003, "Simple analytic rules for model reduction and PID controller tuning").
    """

    name = "simple-pid"
    action = Heat

    class Options(ts.Options):
        """The three gains."""

        kp: float = ts.Field(0.0625, ge=0, description="proportional gain, power per K")
        ki: float = ts.Field(0.003125, ge=0, description="integral gain, power per K s")
        kd: float = ts.Field(0.0, ge=0, description="derivative gain, power s per K")

    def setup(self) -> None:
        self.reset()

    def reset(self) -> None:
        super().reset()
        self._time_s = 0.0
        self._pid = self._controller()
        self._situation = FOLLOWING
        self._last = Heat(power=0.0)

    def act(self, state: PlateState) -> Heat:
        if not all(map(math.isfinite, (state.time_s, state.setpoint_k, state.measured_k))):
            return self._last  # a reading that is no number would stay in the integral for ever
        self._time_s = state.time_s
        self._situation = FOLLOWING if self._pid.setpoint == state.setpoint_k else NEW_SETPOINT
        self._pid.setpoint = state.setpoint_k
        power = self._pid(state.measured_k)
        self._last = Heat(power=0.0 if power is None else power)
        return self._last

    @property
    def situation(self) -> str:
        return self._situation

    def _controller(self) -> PID:
        with explain_missing("tutor 'simple-pid'", "simple-pid"):
            from simple_pid import PID
        options = self.options
        return PID(
            options.kp,
            options.ki,
            options.kd,
            sample_time=None,
            output_limits=(-1.0, 1.0),
            time_fn=lambda: self._time_s,
        )
