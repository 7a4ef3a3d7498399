"""A thermal plate: first order with dead time, a recipe of setpoints, and drifting surroundings."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Mapping
from typing import Any

import numpy as np

import tutorstudent as ts
from tutorstudent_controllers.pid.state import Heat, PlateState

SLOPE_SAMPLES = 4


class PlateOptions(ts.Options):
    """The plate, its surroundings and its recipe."""

    gain_k: float = ts.Field(40.0, gt=0, le=1000, description="steady temperature at full power, K above ambient")
    later_gain_k: float | None = ts.Field(None, gt=0, le=1000, description="the same from a moment on; none: no change")
    later_s: float = ts.Field(0.0, ge=0, description="that moment, s")
    lag_s: float = ts.Field(20.0, gt=0, le=10_000, description="time constant, s")
    dead_time_s: float = ts.Field(4.0, ge=0, le=1000, description="before power shows in the readings, s")
    sample_s: float = ts.Field(0.5, gt=0, le=10, description="time between two decisions, s")
    noise_k: float = ts.Field(0.05, ge=0, le=10, description="standard deviation of a reading, K")
    drift_k: float = ts.Field(1.5, ge=0, le=100, description="standard deviation of the ambient's drift, K")
    drift_s: float = ts.Field(60.0, gt=0, le=100_000, description="time in which the drift forgets itself, s")
    span_k: float = ts.Field(20.0, gt=0, le=1000, description="setpoints lie within this of the nominal ambient, K")
    step_k: float = ts.Field(5.0, ge=0, le=1000, description="smallest step from one setpoint to the next, K")
    band_k: float = ts.Field(0.5, gt=0, le=100, description="a reading this near to the setpoint is on it, K")
    hold_s: float = ts.Field(10.0, gt=0, le=10_000, description="readings on the setpoint that end a step, s")
    spoilt_k: float = ts.Field(1.0, ge=0, le=1000, description="event: a reading this far beyond the setpoint, K")


class Plate(ts.World[PlateState, Heat]):
    """Heat or cool a plate to one temperature after another; each has to be held before the next one comes.

    What a plate has to do is drawn from the trial's seed alone: the same steps in the same order, whatever the power.
    """

    name = "plate"
    action = Heat
    Options = PlateOptions
    options: PlateOptions

    @property
    def event_names(self) -> Mapping[str, Any]:
        return {
            "steps_done": "sum",
            "settled": "sum",
            "spoilt": "sum",
            "abs_error_k": "mean",
            "overshoot_k": "max",
            "time_s": "sum",
        }

    def reset(self, seed: int) -> PlateState:
        recipe, weather, readings = np.random.SeedSequence(seed).spawn(3)
        self._recipe = np.random.default_rng(recipe)
        self._weather = np.random.default_rng(weather)
        self._readings = np.random.default_rng(readings)
        options = self.options
        self._power = deque([0.0] * round(options.dead_time_s / options.sample_s))
        self._time_s = self._plate_k = self._drift_k = 0.0
        self._read_k = deque([self._read()] * (SLOPE_SAMPLES + 1), maxlen=SLOPE_SAMPLES + 1)
        self._setpoint_k = 0.0
        self._on_setpoint = 0
        self._ask()
        return self._state()

    def step(self, action: Heat) -> ts.Step[PlateState]:
        self._power.append(action.power)
        self._warm(self._power.popleft())
        self._read_k.append(self._read())
        state = self._state()
        self._on_setpoint = self._on_setpoint + 1 if abs(state.missing_k) <= self.options.band_k else 0
        done = self._on_setpoint * self.options.sample_s >= self.options.hold_s
        events = {
            "steps_done": float(done),
            "settled": float(self._on_setpoint > 0),
            "spoilt": float(state.missing_k < -self.options.spoilt_k),
            "abs_error_k": abs(state.missing_k),
            "overshoot_k": max(0.0, -state.missing_k),
            "time_s": self.options.sample_s,
        }
        if done:
            self._ask()
            state = self._state()
        return ts.Step(state, events)

    def _warm(self, power: float) -> None:
        options = self.options
        keep = math.exp(-options.sample_s / options.drift_s)
        push_k = options.drift_k * math.sqrt(1 - keep**2)
        self._drift_k = keep * self._drift_k + push_k * self._weather.standard_normal()
        approached = 1 - math.exp(-options.sample_s / options.lag_s)
        self._plate_k += approached * (self._find_gain_k() * power + self._drift_k - self._plate_k)
        self._time_s += options.sample_s

    def _find_gain_k(self) -> float:
        options = self.options
        later_k = options.later_gain_k
        return options.gain_k if later_k is None or self._time_s < options.later_s else later_k

    def _read(self) -> float:
        return self._plate_k + self.options.noise_k * float(self._readings.standard_normal())

    def _ask(self) -> None:
        span_k, before_k = self.options.span_k, self._setpoint_k
        while abs(self._setpoint_k - before_k) < min(self.options.step_k, span_k):
            self._setpoint_k = float(self._recipe.uniform(-span_k, span_k))
        self._started_k = self._read_k[-1]
        self._on_setpoint = 0

    def _state(self) -> PlateState:
        slope_kps = (self._read_k[-1] - self._read_k[0]) / (SLOPE_SAMPLES * self.options.sample_s)
        return PlateState(self._time_s, self._setpoint_k, self._started_k, self._read_k[-1], slope_kps)
