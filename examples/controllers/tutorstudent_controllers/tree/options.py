"""The numbers of the tree."""

from __future__ import annotations

import tutorstudent as ts


class TreeOptions(ts.Options):
    """Speeds, distances and patience of the tree."""

    translation: float = ts.Field(0.2, gt=0, le=1, description="speed ahead and back, fraction of full speed")
    rotation: float = ts.Field(0.35, gt=0, le=1, description="speed of turns, fraction of full turning speed")
    obstacle_m: float = ts.Field(0.4, gt=0, le=5, description="nearer than this ahead is an obstacle, m")
    clear_m: float = ts.Field(1.0, gt=0, le=5, description="free space ahead that ends a turn from an obstacle, m")
    met_m: float = ts.Field(0.95, gt=0, le=20, description="a red thing nearer than this is met, m")
    afraid_m: float = ts.Field(0.6, gt=0, le=20, description="a blue thing nearer than this is turned from, m")
    facing_rad: float = ts.Field(0.2, gt=0, le=3.2, description="a red thing within this bearing is driven at, rad")
    back_off: int = ts.Field(5, ge=1, le=1000, description="decisions of backing off after a stall")
    swing: int = ts.Field(8, ge=1, le=1000, description="decisions of turning after that")
    passing: int = ts.Field(12, ge=1, le=1000, description="decisions ahead after a turn from an obstacle, at most")
    patience: int = ts.Field(70, ge=1, le=10_000, description="longest turn, decisions")
    stroll: int = ts.Field(60, ge=1, le=10_000, description="mean way straight on while wandering, decisions")
