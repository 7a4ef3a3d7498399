"""Prototype 2 or 2A in one environment under a setting: what was counted, and whether the robot was free."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import tutorstudent as ts
from tutorstudent_prototype2.calibration.choices import FULL_SPEED_MPS, TICK_S
from tutorstudent_prototype2.pipelines import Setting, load

DECISIONS = 10_000
"""Thesis 4.2."""


class Counts(NamedTuple):
    """What one run counted."""

    attractors: float
    collided: float
    """Decisions in which the robot's own motion was refused."""
    contacts: float
    distance_m: float
    way_share: float
    """Distance as a part of what the tutor's forward speed would give in the same time."""
    longest_stall: float
    """Decisions in a row."""
    complete: bool
    """False: the run was given up, since nothing could make the setting admissible any more."""


class Limits(NamedTuple):
    """When a run is given up before its end."""

    attractors: float = math.inf
    collided: float = math.inf
    longest_stall: float = math.inf


class GivenUp(Exception):
    """A run that cannot become admissible any more; nothing else is wrong with it."""


class Totals(ts.Observer):
    """Adds up the world's events."""

    name = "totals"

    def __init__(self, limits: Limits, counter: ts.Observer) -> None:
        super().__init__()
        self._limits = limits
        self._counter = counter
        self.sums = dict.fromkeys(("collided", "contacts", "distance_m", "time_s"), 0.0)
        self.longest_stall = 0.0

    def observe(self, turn: ts.Turn[Any, Any], step: ts.Step[Any]) -> None:
        """Add one decision; GivenUp if a limit is passed."""
        for key in self.sums:
            self.sums[key] += step.events[key]
        self.longest_stall = max(self.longest_stall, step.events["longest_stall"])
        if self.sums["collided"] > self._limits.collided or self.longest_stall > self._limits.longest_stall:
            raise GivenUp
        if turn.decision.moment.number % 100 == 0 and self.attractors() > self._limits.attractors:
            raise GivenUp

    def attractors(self) -> float:
        """Return how many were found up to now."""
        return float(self._counter.summary()["attractors"])


def run_under(
    setting: Setting,
    scene: str,
    seed: int,
    pipeline: str = "prototype2",
    decisions: int = DECISIONS,
    limits: Limits = Limits(),  # noqa: B008 - immutable
    observers: Sequence[ts.Observer] = (),
) -> Counts:
    """Run a pipeline of this package under a setting.

    Args:
        setting: The free choices.
        scene: Name of the environment's scene.
        seed: Of everything.
        pipeline: Name of the pipeline.
        decisions: How many.
        limits: Beyond these the run is given up.
        observers: Of the run, beside those of the pipeline.
    """
    built_from = load(pipeline, scene, setting).replaced({"seed": seed})
    with built_from.built() as (engine, world, own):
        totals = Totals(limits, own[0])
        complete = True
        try:
            ts.run(engine, world, decisions, seed=seed, observers=[*own, totals, *observers])
        except GivenUp:
            complete = False
    return _counts(totals, setting, complete)


def _counts(totals: Totals, setting: Setting, complete: bool) -> Counts:
    sums: Mapping[str, float] = totals.sums
    possible_m = float(setting["tutor"]["translation"]) * FULL_SPEED_MPS * max(sums["time_s"], TICK_S)
    return Counts(
        totals.attractors(),
        sums["collided"],
        sums["contacts"],
        round(sums["distance_m"], 3),
        round(sums["distance_m"] / possible_m, 4),
        totals.longest_stall,
        complete,
    )
