"""The numbers of the planner and of the path follower."""

from __future__ import annotations

import tutorstudent as ts


class PlannerOptions(ts.Options):
    """Map, goals, speeds."""

    cell_m: float = ts.Field(0.15, ge=0.02, le=1, description="side of a grid cell, m")
    keep_m: float = ts.Field(0.45, ge=0, le=5, description="how far the path keeps from everything, m")
    goal_m: float = ts.Field(4.0, ge=0, le=100, description="a new goal is at least this far away, m")
    arrived_m: float = ts.Field(0.4, gt=0, le=5, description="this near to the goal it is reached, m")
    ahead_m: float = ts.Field(0.6, gt=0, le=10, description="how far ahead on the path the follower aims, m")
    turn_rad: float = ts.Field(0.8, gt=0, le=3.2, description="bearing beyond which it turns on the spot, rad")
    translation: float = ts.Field(0.2, gt=0, le=1, description="speed on the path, fraction of full speed")
    rotation: float = ts.Field(0.35, gt=0, le=1, description="speed of turns on the spot, and the sharpest arc's")
    full_speed_mps: float = ts.Field(0.9, gt=0, le=5, description="the robot's speed at translation 1, m/s")
    full_turn_degps: float = ts.Field(65.0, gt=0, le=720, description="its turning speed at rotation 1, degrees/s")
    back_off: int = ts.Field(5, ge=1, le=1000, description="decisions of backing off after a stall")
