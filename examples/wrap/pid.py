"""A learner round a PID controller of the package simple-pid, in the owner's own loop.

The plate is heated and cooled by one number; its readings come four seconds late. Run: python examples/wrap/pid.py
"""

from __future__ import annotations

from simple_pid import PID

import tutorstudent as ts
from tutorstudent_controllers.pid.plate import Plate
from tutorstudent_controllers.pid.state import Heat

DECISIONS = 400

plate = Plate()
reading = plate.reset(seed=1)

pid = PID(0.03125, 0.0015625, 0.0, sample_time=None, output_limits=(-1, 1), time_fn=lambda: reading.time_s)
loop = ts.wrap(pid, action=ts.scalar(-1, 1), condition=lambda celsius: overshoot_k(celsius) > 1, ranges=[(-25, 25)])


def overshoot_k(celsius: float) -> float:
    """Return how far a reading is beyond the setpoint, as seen from where the step began."""
    return (celsius - reading.setpoint_k) * reading.direction


done = overshooting = level = 0.0
for _ in range(DECISIONS):
    pid.setpoint = reading.setpoint_k
    power = loop.step(reading.measured_k)
    step = plate.step(Heat(power=power))
    reading = step.state
    done += step.events["steps_done"]
    overshooting += step.events["spoilt"]
    level += loop.engine.last.decision.resulting.level if loop.engine.last else 0

print(f"{DECISIONS} decisions, {done:.0f} temperatures reached and held, {overshooting:.0f} readings 1 K beyond;")
print(f"mean level {level / DECISIONS:.2f}, incidents {len(loop.engine.incidents)}")
