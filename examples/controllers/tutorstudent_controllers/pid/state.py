"""What a thermal plate says, and what it is told."""

from __future__ import annotations

from dataclasses import dataclass

import tutorstudent as ts


class Heat(ts.Action):
    """Power of a Peltier element: it heats and it cools."""

    power: float = ts.component(-1.0, 1.0, description="fraction of full power, heating positive")

    amplification = {"command": {"power": "outward"}}


@dataclass(frozen=True, slots=True)
class PlateState:
    """A reading of the plate's thermometer, and what the recipe asks for."""

    time_s: float
    setpoint_k: float
    """Temperature that the recipe asks for, K above a nominal ambient."""
    started_k: float
    """Temperature read when it began to ask for it."""
    measured_k: float
    """Temperature read now."""
    slope_kps: float
    """How fast the readings have risen over the last two seconds, K/s."""

    @property
    def missing_k(self) -> float:
        """How much is missing in the direction of the step; negative after the setpoint was passed."""
        return self.direction * (self.setpoint_k - self.measured_k)

    @property
    def closing_kps(self) -> float:
        """How fast the reading moves in the direction of the step, K/s."""
        return self.direction * self.slope_kps

    @property
    def direction(self) -> float:
        """1 where the step goes up, -1 where it goes down."""
        return 1.0 if self.setpoint_k >= self.started_k else -1.0

    @classmethod
    def examples(cls) -> list[PlateState]:
        """Return states to try parts with: before, at and beyond a setpoint, moving either way."""
        return [
            cls(10.0, setpoint_k, 0.0, measured_k, slope_kps)
            for setpoint_k in (12.0, -12.0)
            for measured_k in (0.0, setpoint_k / 2, setpoint_k, 1.4 * setpoint_k)
            for slope_kps in (-1.0, 0.0, 1.0)
        ]
