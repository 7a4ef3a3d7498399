"""The numbers of prototype 2. The thesis gives none; see docs/fidelity.md for where they come from."""

from __future__ import annotations

from itertools import pairwise

from pydantic import ValidationInfo, field_validator

from tutorstudent.core.roles.part import Field, Options


def _check_more(value: float, info: ValidationInfo, other: str, why: str) -> float:
    bound = info.data.get(other, 0.0)
    if value <= bound:
        raise ValueError(f"must be more than {other} ({bound}), or {why}")
    return value


class Thresholds(Options):
    """Distances at which prototype 2 reacts, from the sonar or the camera; its rules and its encoders share them."""

    front_m: float = Field(0.3, gt=0, le=5, description="closer than this ahead is an obstacle to turn from, m")
    side_m: float = Field(0.1, gt=0, le=5, description="closer than this beside is an obstacle to turn from, m")
    clear_m: float = Field(
        0.8,
        gt=0,
        le=5,
        validate_default=True,
        description="free space ahead that a wandering robot wants, and that ends a spin, m",
    )
    prey_m: float = Field(0.95, gt=0, le=20, description="closer than this a prey counts as found and is fled from, m")
    predator_m: float = Field(0.4, gt=0, le=20, description="closer than this a predator is fled from, m")

    @field_validator("clear_m")
    @classmethod
    def _check_clear(cls, clear_m: float, info: ValidationInfo) -> float:
        return _check_more(clear_m, info, "front_m", "a spin would end in front of an obstacle")


class Tuning(Thresholds):
    """Options of the tutor."""

    translation: float = Field(0.12, gt=0, le=1, description="speed of forward and backward, fraction of full speed")
    rotation: float = Field(0.38, gt=0, le=1, description="speed of left and right, fraction of full turning speed")
    duration_s: float = Field(0.0, ge=0, le=60, description="how long an action is held, s; 0 is one decision")
    seek_tolerance_rad: float = Field(
        0.15, ge=0, le=3.2, description="a prey within this bearing is driven at, outside it is turned to, rad"
    )
    avoid_forward: int = Field(10, ge=1, le=1000, description="decisions forward after a spin from an obstacle")
    flee_forward: int = Field(3, ge=1, le=1000, description="decisions forward after a spin from prey or predator")
    spin_limit: int = Field(
        80,
        ge=1,
        le=100_000,
        description="length of a whole turn, decisions; after it a spin ends where there is most space ahead",
    )
    break_out_forward: int = Field(30, ge=1, le=1000, description="decisions forward after a spin all the way round")
    break_out_clearance: float = Field(
        0.5, gt=0, le=1, description="part of front_m and side_m that the robot keeps meanwhile, fraction"
    )
    wander_turn: float = Field(
        0.005, ge=0, le=1, description="probability per decision that a wandering robot turns to an open side"
    )
    turn_max: int = Field(15, ge=1, le=1000, description="longest such turn, decisions")
    open_m: float = Field(1.5, gt=0, le=5, description="mean range of a side that makes it an open area, m")
    recover_min: int = Field(3, ge=1, le=1000, description="shortest recovery action after a stall, decisions")
    recover_more: int = Field(5, ge=0, le=1000, description="longest random addition to it, decisions")
    recover_random: float = Field(
        0.5, ge=0, le=1, description="probability that a recovery action is a random one of those not just refused"
    )
    stall_delay: int = Field(
        2, ge=1, le=1000, description="decisions until a stall report can be about the present recovery action"
    )


class BitThresholds(Thresholds):
    """Options of the encoders."""

    back_m: float = Field(0.3, gt=0, le=5, description="closer than this behind is an obstacle, m")
    side_limited_m: float = Field(
        0.3,
        gt=0,
        le=5,
        validate_default=True,
        description="closer than this beside is limited space, m; more than side_m",
    )
    centre_rad: float = Field(
        0.35, gt=0, le=3.2, description="a prey within this bearing is in the centre of the picture, rad"
    )

    @field_validator("side_limited_m")
    @classmethod
    def _check_side_limited(cls, side_limited_m: float, info: ValidationInfo) -> float:
        return _check_more(side_limited_m, info, "side_m", "two bits would say the same")


class ThermometerThresholds(BitThresholds):
    """Options of the thermometer encoder."""

    front_steps_m: tuple[float, float, float, float] = Field(
        (0.3, 0.8, 1.5, 3.0), description="distances ahead at which one bit more is set, ascending, m"
    )

    @field_validator("front_steps_m")
    @classmethod
    def _check_ascent(cls, steps: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
        if any(near >= far for near, far in pairwise((0.0, *steps))):
            raise ValueError("must be positive and ascending")
        return steps
