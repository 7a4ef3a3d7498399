"""What is gained and what is harmed in each example: numbers of a run's summary."""

from __future__ import annotations

from typing import NamedTuple


class Measure(NamedTuple):
    """One number of a run."""

    title: str
    key: str
    """Of the run's summary."""
    harm: bool = False
    """Whether less is better, and whether not having more of it is tested."""


MEASURES: dict[str, tuple[Measure, ...]] = {
    "pid": (
        Measure("temperatures held", "steps"),
        Measure("readings 1 K beyond", "spoilt", harm=True),
        Measure("mean error, K", "abs_error_k"),
    ),
    "tree": (
        Measure("meetings", "meetings"),
        Measure("collided decisions", "collided", harm=True),
        Measure("encounters", "encounters"),
        Measure("way, m", "distance_m"),
    ),
    "planner": (
        Measure("goals reached", "goals"),
        Measure("collided decisions", "collided", harm=True),
        Measure("way, m", "distance_m"),
    ),
    "walker": (
        Measure("return", "reward"),
        Measure("falls", "falls", harm=True),
        Measure("way, m", "distance_m"),
    ),
    "lander": (
        Measure("landings", "landings"),
        Measure("crashes", "crashes", harm=True),
        Measure("return", "reward"),
    ),
}
"""By the name of the study's folder; the first is what the controller is for."""
