"""The free choices of world and tutor: what the thesis leaves open, and within which bounds.

One setting serves all environments (Thesis 4.2 has one robot in all of them). What follows from other choices is
derived, not free: a spin ends after one whole turn, a stall report is believed once it can be about the present
action, the encoder has the tutor's thresholds, and an encounter has the tutor's prey distance.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

TICK_S = 0.1
FULL_SPEED_MPS = 0.9
FULL_TURN_DEGPS = 65.0
"""Not free: clock and speeds as measured in the thesis's simulator, and the defaults of the world."""


class Stride(NamedTuple):
    """How far a walk looks."""

    step: float
    """Standard deviation of a step, as a part of a choice's range."""
    changed: float
    """Probability that a choice is changed; half of that for the place of a box."""


WIDE, NARROW = Stride(0.2, 1 / 3), Stride(0.08, 1 / 6)


class Range(NamedTuple):
    """The bounds of a choice; before anything is known it is uniform between them, or uniform in the logarithm."""

    low: float
    high: float
    logarithmic: bool = False

    def move(self, value: float, step: float, rng: np.random.Generator) -> float:
        """Return a value near another one, as probable from there as this is from here; bounds reflect.

        It has five significant digits, so that a setting can be written down whole.
        """
        low, high = (math.log(self.low), math.log(self.high)) if self.logarithmic else (self.low, self.high)
        here = math.log(value) if self.logarithmic else value
        there = reflect(here + step * (high - low) * float(rng.standard_normal()), low, high)
        return float(f"{math.exp(there) if self.logarithmic else there:.5g}")


class Whole(NamedTuple):
    """A choice among whole numbers, both bounds included."""

    low: int
    high: int

    def move(self, value: float, step: float, rng: np.random.Generator) -> int:
        """Return a neighbour, or the value itself where a bound is in the way."""
        return min(self.high, max(self.low, int(value) + int(rng.choice((-1, 1)))))


CHOICES: Mapping[str, Range | Whole] = {
    "tutor.translation": Range(0.05, 0.25, logarithmic=True),
    "tutor.rotation": Range(0.15, 0.6),
    "tutor.front_m": Range(0.2, 0.5),
    "tutor.side_m": Range(0.05, 0.2),
    "tutor.free_beyond_front_m": Range(0.3, 0.8),
    "tutor.prey_m": Range(0.5, 1.3),
    "tutor.predator_m": Range(0.3, 0.9),
    "world.ticks_per_decision": Whole(1, 2),
    "world.latency_ticks": Whole(1, 4),
    "world.camera_fov_deg": Range(50, 130),
    "world.box_side_m": Range(0.2, 0.5),
    "prey.forward": Range(0.2, 1.0),
    "prey.turn": Range(0.15, 0.5),
    "predator.forward": Range(0.05, 0.3),
    "predator.turn": Range(0.15, 0.4),
    "others.front_m": Range(0.2, 0.5),
    "predator.stop_m": Range(0.2, 0.5),
}
"""The bounds, fixed before the search. The places of the six boxes are free beside these, see `places`."""

Choices = Mapping[str, float]

START: Choices = {
    "tutor.translation": 0.07,
    "tutor.rotation": 0.38,
    "tutor.front_m": 0.3,
    "tutor.side_m": 0.1,
    "tutor.free_beyond_front_m": 0.5,
    "tutor.prey_m": 0.95,
    "tutor.predator_m": 0.4,
    "world.ticks_per_decision": 2,
    "world.latency_ticks": 3,
    "world.camera_fov_deg": 120,
    "world.box_side_m": 0.3,
    "prey.forward": 0.9,
    "prey.turn": 0.3,
    "predator.forward": 0.1,
    "predator.turn": 0.25,
    "others.front_m": 0.4,
    "predator.stop_m": 0.3,
}
"""Where every walk begins: the best setting of an earlier calibration in another simulator, on prototype 2 too."""


def move(choices: Choices, stride: Stride, rng: np.random.Generator) -> dict[str, float]:
    """Return a neighbour."""
    return {
        name: choice.move(choices[name], stride.step, rng) if rng.random() < stride.changed else choices[name]
        for name, choice in CHOICES.items()
    }


def reflect(value: float, low: float, high: float) -> float:
    """Return a value between the bounds, mirrored at them as often as it takes.

    >>> [reflect(value, 0.0, 1.0) for value in (0.25, -0.25, 1.25, 2.25)]
    [0.25, 0.25, 0.75, 0.25]
    """
    width = high - low
    folded = (value - low) % (2 * width)
    return low + min(folded, 2 * width - folded)


def setting_of(choices: Choices, box_places: list[tuple[float, float]]) -> dict[str, dict[str, Any]]:
    """Return the options of world and tutor that these choices stand for; the encoder follows the tutor."""
    latency, ticks = int(choices["world.latency_ticks"]), int(choices["world.ticks_per_decision"])
    world = {
        "ticks_per_decision": ticks,
        "sensor_latency": latency,
        "stall_latency": latency,
        "camera_fov_deg": choices["world.camera_fov_deg"],
        "box_side_m": choices["world.box_side_m"],
        "box_places": [list(place) for place in box_places],
        "encounter_radius_m": choices["tutor.prey_m"],
        "encounter_release_m": round(choices["tutor.prey_m"] + 0.25, 4),
        "prey": {
            "forward": choices["prey.forward"],
            "turn": choices["prey.turn"],
            "front_m": choices["others.front_m"],
        },
        "predator": {
            "forward": choices["predator.forward"],
            "turn": choices["predator.turn"],
            "front_m": choices["others.front_m"],
            "stop_m": choices["predator.stop_m"],
        },
    }
    tutor = {
        "front_m": choices["tutor.front_m"],
        "side_m": choices["tutor.side_m"],
        "clear_m": round(choices["tutor.front_m"] + choices["tutor.free_beyond_front_m"], 4),
        "prey_m": choices["tutor.prey_m"],
        "predator_m": choices["tutor.predator_m"],
        "translation": choices["tutor.translation"],
        "rotation": choices["tutor.rotation"],
        "spin_limit": spin_limit(choices["tutor.rotation"], ticks),
        "stall_delay": math.ceil((latency + 1) / ticks),
    }
    return {"world": world, "tutor": tutor}


def spin_limit(rotation: float, ticks: int) -> int:
    """Return how many decisions a whole turn takes, and a tenth more.

    >>> spin_limit(0.38, 2)
    81
    """
    return math.ceil(1.1 * 360 / (rotation * FULL_TURN_DEGPS * TICK_S * ticks))
