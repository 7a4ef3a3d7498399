"""When a setting is admissible, and when it agrees with the thesis. Both were written down before the search.

A fit to counts alone selects trapped robots (they count little, as the thesis's prototype 2 does), so a setting is
admissible only if prototype 2 moves freely in every environment. An admissible setting agrees with the thesis where
each of its runs could be one of the thesis's own: its counts lie within the thesis's mean ± 2 standard deviations
over runs. The thesis's prototype 2 never collided in Cave-Box, so its standard deviation of 0 is taken as 1 there.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from tutorstudent_prototype2.calibration.trials import Counts, Limits

LEAST_WAY_SHARE = 0.3
"""A robot that makes less than this part of the way that its forward speed allows is trapped or dithers."""
LONGEST_STALL = 50
"""Decisions; a robot that is refused for longer is trapped."""
DEVIATIONS = 2.0


class Target(NamedTuple):
    """Prototype 2's row of a table of the thesis."""

    collisions: float
    collisions_sd: float
    attractors: float
    attractors_sd: float


TARGETS: Mapping[str, Target] = {
    "cave-box": Target(0.0, 1.0, 8.1, 2.02),
    "chase-avoid": Target(31.2, 57.62, 84.6, 18.11),
    "cave-predator-prey": Target(1.6, 1.84, 29.2, 22.0),
    "cave-predator-prey-box": Target(0.3, 0.67, 30.3, 15.6),
}
"""Tables 4, 2, 6 and 8, in the order in which environments are tried: the quickest and most telling first."""


def limits(scene: str) -> Limits:
    """Return when a run can be given up, since the setting can no longer agree."""
    target = TARGETS[scene]
    return Limits(
        target.attractors + DEVIATIONS * target.attractors_sd,
        target.collisions + DEVIATIONS * target.collisions_sd,
        LONGEST_STALL,
    )


def admissible(counts: Counts) -> bool:
    """Return whether the robot moved freely."""
    return counts.complete and counts.way_share >= LEAST_WAY_SHARE and counts.longest_stall <= LONGEST_STALL


def agrees(scene: str, counts: Counts) -> bool:
    """Return whether the run could be one of the thesis's."""
    target = TARGETS[scene]
    return (
        admissible(counts)
        and abs(counts.attractors - target.attractors) <= DEVIATIONS * target.attractors_sd
        and abs(counts.collided - target.collisions) <= DEVIATIONS * target.collisions_sd
    )


def misfit(means: Mapping[str, tuple[float, float]]) -> float:
    """Return how far mean attractors and mean collisions of all environments are from the thesis's; 0 is a fit.

    Attractors in standard deviations of the thesis's runs, squared; collisions, whose tails are heavy, as the squared
    difference of log(1 + count).

    Args:
        means: Attractors and collided decisions, by environment.
    """
    total = 0.0
    for scene, (attractors, collided) in means.items():
        target = TARGETS[scene]
        total += ((attractors - target.attractors) / target.attractors_sd) ** 2
        total += (math.log1p(collided) - math.log1p(target.collisions)) ** 2
    return total
