"""The options of the Pioneer world. Start values are those of a calibration on prototype 2 alone (docs/fidelity.md)."""

from __future__ import annotations

from typing import Literal

from pydantic import model_validator

from tutorstudent.core.roles.part import Field, Options
from tutorstudent.core.roles.world import Point
from tutorstudent.sims.pioneer.actors import PredatorOptions, PreyOptions


class PioneerOptions(Options):
    """Scene, clock, drive, sensors and other robots."""

    scene: str = Field(
        "chase-avoid",
        description="chase-avoid, cave-box, cave-predator-prey, cave-predator-prey-box, or a YAML file's path from the "
        "working directory",
    )
    side_m: float | None = Field(None, gt=0, le=1000, description="side of a scene in percent, instead of its own, m")
    box_side_m: float | None = Field(None, gt=0, le=100, description="side of every box, instead of its own, m")
    box_places: tuple[Point, ...] = Field(
        (),
        max_length=1000,
        description="x and y of every box, in their order and the scene's units, instead of its own; a scene without "
        "boxes stays as it is",
    )
    pose_jitter_m: float = Field(
        0.0, ge=0, le=1, description="start positions vary by up to this with the seed, m in x and y"
    )

    tick_s: float = Field(0.1, ge=0.01, le=1, description="the clock: a step of all robots, s")
    ticks_per_decision: int = Field(2, ge=1, le=1000, description="shortest decision, ticks")
    sensor_latency: int = Field(
        3, ge=0, le=1000, description="age of sonar and blobs when the learner reads them, ticks"
    )
    stall_latency: int = Field(3, ge=0, le=1000, description="age of the stall flag when the learner reads it, ticks")

    drive: Literal["kinematic", "planar", "wheeled"] = Field(
        "kinematic", description="refused steps as in the thesis's simulator, pushed planar bodies, or driven wheels"
    )
    physics_hz: float = Field(240.0, ge=60, le=10_000, description="steps of planar and wheeled physics, 1/s")
    full_speed_mps: float = Field(0.9, gt=0, le=5, description="speed at translation 1, m/s")
    full_turn_degps: float = Field(65.0, gt=0, le=720, description="turning speed at rotation 1, degrees/s")

    sonar_range_m: float = Field(5.0, gt=0.3, le=50, description="largest range of the sonars, m")
    sonar_noise: float = Field(0.05, ge=0, le=1, description="largest relative error of a reading; 0.05 is 5 %")
    camera: Literal["geometry", "rendered"] = Field("geometry", description="blobs by rays, or from a rendered image")
    camera_fov_deg: float = Field(120.0, ge=1, le=170, description="full horizontal field of view, degrees")
    camera_range_m: float = Field(8.0, gt=0, le=50, description="how far the camera sees, m")
    camera_columns: int = Field(3, ge=1, le=64, description="occlusion rays for each thing in view")

    encounter_radius_m: float = Field(
        0.95, gt=0, le=100, description="event: nearer than this to a red thing's surface is an encounter, m"
    )
    encounter_release_m: float = Field(
        1.2, gt=0, le=100, description="event: a red thing counts again after the robot was this far away, m"
    )

    prey: PreyOptions = Field(PreyOptions(), description="how prey robots move")
    predator: PredatorOptions = Field(PredatorOptions(), description="how predator robots move")
    actor_ticks: int = Field(2, ge=1, le=1000, description="other robots sense anew after this many ticks")
    gui: bool = Field(False, description="open pybullet's window")

    @model_validator(mode="after")
    def _check_hysteresis(self) -> PioneerOptions:
        if self.encounter_release_m < self.encounter_radius_m:
            raise ValueError("encounter_release_m is less than encounter_radius_m")
        return self
