"""A controller for a Gymnasium environment, wrapped, in somebody's own script.

The controller swings a pendulum up and holds it there; the student learns how far to amplify its torque without
turning faster than 7.5 rad/s. Prints both returns and the violations of both.
"""

from __future__ import annotations

import math
from typing import Any

import tutorstudent as ts
from tutorstudent.sims.gym import GymnasiumWorld, GymState, ObservationOutside

Torque = ts.scalar(-2, 2, unit="N m")


class Pump(ts.Tutor[GymState, ts.Action]):
    """Pump energy into the pendulum until it stands, then hold it."""

    name = "pump"
    action = Torque

    def act(self, state: GymState) -> ts.Action:
        cosine, sine, speed_radps = state.observation.tolist()
        angle_rad = math.atan2(sine, cosine)
        missing = 5.0 - speed_radps**2 / 6 - 5.0 * cosine
        wanted = -12 * angle_rad - 2.5 * speed_radps if abs(angle_rad) < 0.4 else math.copysign(missing, speed_radps)
        return Torque.read(max(-2.0, min(2.0, wanted)))


class Count(ts.Observer):
    """Counts reward and violations."""

    name = "count"
    reward, violated = 0.0, 0

    def observe(self, turn: ts.Turn[Any, Any], step: ts.Step[Any]) -> None:
        self.reward += step.events["reward"]
        self.violated += turn.outcome is not None and bool(turn.outcome.violated)


def drive(decisions: int, **slots: Any) -> Count:
    """Return what a run comes to."""
    loop = ts.wrap(Pump(), condition=ObservationOutside(index=2, low=-7.5, high=7.5), seed=7, **slots)
    world, count = GymnasiumWorld(id="Pendulum-v1"), Count()
    ts.run(loop.engine, world, decisions, seed=7, observers=[count])
    world.close()
    return count


def main(decisions: int = 2000) -> None:
    """Compare the controller alone with the wrapped one, on the same trials."""
    for who, slots in (("alone", {"student": "silent", "amplifier": "never"}), ("wrapped", {})):
        count = drive(decisions, **slots)
        print(f"{who}: reward {count.reward:.0f}, too fast in {count.violated} of {decisions} decisions")  # noqa: T201


if __name__ == "__main__":
    main()
