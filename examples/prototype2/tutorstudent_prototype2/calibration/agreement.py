"""When a setting is admissible, and when it agrees with the thesis. Both were written down before the search.

A fit to counts alone selects trapped robots (they count little, as the thesis's prototype 2 does), so a setting is
admissible only if prototype 2 moves freely in every environment. An admissible setting agrees with the thesis where
each of its runs could be one of the thesis's own: its counts lie within the thesis's mean ± 2 standard deviations
over runs. Its prototype 2 never collided in Cave-Box; the standard deviation of 0 is taken as 1 there.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from tutorstudent_prototype2.calibration.trials import Counts, Limits
from tutorstudent_prototype2.thesis import Row, prototype2

LEAST_WAY_SHARE = 0.3
"""A robot that makes less than this part of the way that its forward speed allows is trapped or dithers."""
LONGEST_STALL = 50
"""Decisions; a robot that is refused for longer is trapped."""
DEVIATIONS = 2.0


ENVIRONMENTS = ("cave-box", "cave-predator-prey-box", "chase-avoid", "cave-predator-prey")
"""In the order in which they are tried: the quickest, then the most telling first."""
SD_OF_NONE = 1.0
"""Stands for the standard deviation of collisions where the thesis's prototype 2 never collided."""


def limits(scene: str) -> Limits:
    """Return when a run can be given up, since the setting can no longer agree."""
    row = prototype2(scene)
    return Limits(
        row.attractors + DEVIATIONS * row.attractors_sd,
        row.collisions + DEVIATIONS * _collisions_sd(row),
        LONGEST_STALL,
    )


def admissible(counts: Counts) -> bool:
    """Return whether the robot moved freely."""
    return counts.complete and counts.way_share >= LEAST_WAY_SHARE and counts.longest_stall <= LONGEST_STALL


def agrees(scene: str, counts: Counts) -> bool:
    """Return whether the run could be one of the thesis's."""
    row = prototype2(scene)
    return (
        admissible(counts)
        and abs(counts.attractors - row.attractors) <= DEVIATIONS * row.attractors_sd
        and abs(counts.collided - row.collisions) <= DEVIATIONS * _collisions_sd(row)
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
        row = prototype2(scene)
        total += ((attractors - row.attractors) / row.attractors_sd) ** 2
        total += (math.log1p(collided) - math.log1p(row.collisions)) ** 2
    return total


def _collisions_sd(row: Row) -> float:
    return row.collisions_sd or SD_OF_NONE
