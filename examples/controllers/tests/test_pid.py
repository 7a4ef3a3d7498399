"""simple-pid on the plate: the plant against closed forms, the tutor against the package itself."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from simple_pid import PID

import tutorstudent as ts
from tutorstudent.core.roles.binding import Binding
from tutorstudent_controllers.pid.parts import Approach, Overshoot
from tutorstudent_controllers.pid.plate import Plate
from tutorstudent_controllers.pid.state import Heat, PlateState
from tutorstudent_controllers.pid.tutor import SimplePid

QUIET = {"noise_k": 0.0, "drift_k": 0.0}


def state(setpoint_k: float = 10.0, measured_k: float = 0.0, slope_kps: float = 0.0) -> PlateState:
    return PlateState(5.0, setpoint_k, 0.0, measured_k, slope_kps)


def tutor(**options: float) -> SimplePid:
    made = SimplePid(**options)
    made.bind(Binding(seed=7, slot="tutor", action=Heat))
    return made


def test_the_plate_answers_a_step_as_a_first_order_lag_does_after_its_dead_time() -> None:
    plate = Plate(**QUIET)
    plate.reset(1)
    readings = [plate.step(Heat(power=0.5)).state.measured_k for _ in range(60)]
    assert [0.0] * 8 == readings[:8]  # 4 s in samples of 0.5 s
    expected = [40 * 0.5 * (1 - math.exp(-0.5 * i / 20)) for i in range(1, 53)]
    assert expected == pytest.approx(readings[8:])


def test_a_seed_asks_for_the_same_temperatures_whatever_the_power() -> None:
    assert asked(kp=0.03, ki=0.0015) == asked(kp=0.06, ki=0.003)


def asked(**gains: float) -> list[float]:
    plate, controller = Plate(**QUIET), tutor(**gains)
    reading, found = plate.reset(3), []
    while len(found) < 3:
        step = plate.step(controller.act(reading))
        reading = step.state
        if step.events["steps_done"]:
            found.append(reading.setpoint_k)
    return found


def test_a_step_is_done_once_the_reading_was_held_for_ten_seconds() -> None:
    plate = Plate(**QUIET, span_k=0.2, step_k=0.0)
    plate.reset(1)
    done = [plate.step(Heat(power=0.0)).events["steps_done"] for _ in range(40)]
    assert [19, 39] == [i for i, value in enumerate(done) if value]


def test_the_tutor_says_what_the_package_says() -> None:
    pid = PID(0.05, 0.01, 0.02, setpoint=10.0, sample_time=None, output_limits=(-1, 1))
    controller = tutor(kp=0.05, ki=0.01, kd=0.02)
    controller.act(replace(state(), time_s=0.0))
    pid(0.0, dt=1e-16)
    for i in range(1, 9):
        measured_k = 1.3 * i
        expected = pid(measured_k, dt=0.5)
        assert expected == controller.act(replace(state(measured_k=measured_k), time_s=0.5 * i)).power


def test_it_says_when_there_is_a_new_setpoint() -> None:
    controller = tutor()
    said = []
    for setpoint_k in (10.0, 10.0, -4.0, -4.0):
        controller.act(state(setpoint_k))
        said.append(controller.situation)
    assert ["New setpoint", "Following", "New setpoint", "Following"] == said


@pytest.mark.parametrize("broken", [math.nan, math.inf, -math.inf])
def test_a_reading_that_is_no_number_repeats_the_last_power_and_leaves_no_trace(broken: float) -> None:
    whole, disturbed = tutor(), tutor()
    before = disturbed.act(state())
    assert whole.act(state()) == before
    assert before == disturbed.act(state(measured_k=broken))
    later = replace(state(measured_k=2.0), time_s=6.0)
    assert whole.act(later) == disturbed.act(later)


@pytest.mark.parametrize(
    ("setpoint_k", "measured_k", "slope_kps", "horizon_s", "expected"),
    [
        (10.0, 10.9, 0.0, 0.0, False),
        (10.0, 11.1, 0.0, 0.0, True),
        (-10.0, -11.1, 0.0, 0.0, True),
        (-10.0, 11.1, 0.0, 0.0, False),
        (10.0, 9.0, 0.6, 4.0, True),
        (10.0, 9.0, 0.4, 4.0, False),
        (10.0, 11.1, -1.0, 4.0, True),  # moving back does not undo it
    ],
)
def test_overshoot_counts_in_the_direction_of_the_step(
    setpoint_k: float, measured_k: float, slope_kps: float, horizon_s: float, expected: bool
) -> None:
    condition = Overshoot(limit_k=1.0, horizon_s=horizon_s)
    seen = state(setpoint_k, measured_k, slope_kps)
    assert expected == condition.violated(seen)
    assert expected == (condition.margins(seen)[0] < 0)


def test_the_student_sees_thermometers_of_what_is_missing_what_is_coming_and_the_push() -> None:
    encoder = Approach(missing_k=(0.0, 5.0), coming_k=(0.0, 5.0), horizon_s=4.0, push=(0.0, 0.5))
    moment = ts.Moment(0, state(measured_k=4.0, slope_kps=0.5), Heat(power=0.4), "")
    assert [1, 1, 1, 0, 1, 0] == encoder.encode(moment).tolist()  # 6 K missing, 4 K after the horizon
    down = ts.Moment(0, state(-10.0, -4.0, -0.5), Heat(power=-0.4), "")
    assert encoder.encode(moment).tolist() == encoder.encode(down).tolist()
