"""What a scene says: walls, coloured boxes, robots. A YAML file holds the same fields under the same names."""

from __future__ import annotations

from collections import Counter
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Discriminator, Field, Tag, field_validator, model_validator

from tutorstudent.core.roles.world import Point

Units = Literal["metres", "percent"]
Colour = Literal["red", "green", "blue", "yellow", "grey"]
Controller = Literal["learner", "prey", "predator"]


class Spec(BaseModel):
    """A part of a scene. Unknown keys are refused."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


class Circle(Spec):
    """A circle, in the units of the walls."""

    centre: Point = Field(description="x and y")
    radius: float = Field(gt=0, description="radius")


Polygon = Annotated[list[Point], Field(min_length=3, description="corners in order, each x and y")]


def _find_shape(value: Any) -> str:
    return "circle" if isinstance(value, dict | Circle) else "polygon"


Shape = Annotated[Annotated[Circle, Tag("circle")] | Annotated[Polygon, Tag("polygon")], Discriminator(_find_shape)]
"""A mapping is a circle, a list is a polygon."""


class Walls(Spec):
    """An arena with a wall round it, and islands in it: solid obstacles."""

    units: Units = Field("metres", description="metres, or percent of the scene's side_m")
    arena: Shape = Field(description="what the outer wall surrounds")
    islands: dict[str, Shape] = Field({}, description="solid obstacles by name")


class RosMap(Spec):
    """An occupancy map as ROS's map_server writes it."""

    ros_map: str = Field(description="YAML file of the map, beside the scene's file")


def _find_walls(value: Any) -> str:
    if isinstance(value, str):
        return "file"
    return "map" if isinstance(value, RosMap) or (isinstance(value, dict) and "ros_map" in value) else "walls"


AnyWalls = Annotated[
    Annotated[Walls, Tag("walls")] | Annotated[RosMap, Tag("map")] | Annotated[str, Tag("file")],
    Discriminator(_find_walls),
]


class Box(Spec):
    """A static box: red ones attract, blue ones repel (Thesis 4.3.3)."""

    colour: Colour
    x: float
    y: float
    side_m: float = Field(gt=0, le=100, description="length of a side, m")
    heading_deg: float = Field(0.0, description="direction of a side, degrees counter-clockwise from +x")


class Robot(Spec):
    """A Pioneer with what drives it and where it starts."""

    name: str = Field(min_length=1, description="keys its random numbers")
    controller: Controller
    colour: Colour
    x: float
    y: float
    heading_deg: float = Field(0.0, description="degrees counter-clockwise from +x")


class SceneSpec(Spec):
    """A whole scene. Robots act in the order in which they stand here; exactly one is the learner."""

    description: str = Field(min_length=1, description="one sentence for people")
    units: Units = Field("metres", description="of the positions of boxes and robots")
    side_m: float | None = Field(None, gt=0, le=1000, description="length that 100 percent stands for, m")
    walls: AnyWalls = Field(description="walls, a ROS map, or the name of a YAML file with walls")
    boxes: list[Box] = []
    robots: list[Robot] = Field(min_length=1)

    @field_validator("robots")
    @classmethod
    def _check_one_learner(cls, robots: list[Robot]) -> list[Robot]:
        learners = sum(robot.controller == "learner" for robot in robots)
        if learners != 1:
            raise ValueError(f"exactly one robot has the controller 'learner', not {learners}")
        name, times = Counter(robot.name for robot in robots).most_common(1)[0]
        if times > 1:
            raise ValueError(f"{times} robots are named '{name}'; give each its own name")
        return robots

    @model_validator(mode="after")
    def _check_scale(self) -> SceneSpec:
        if self.units == "percent" and self.side_m is None:
            raise ValueError("units are percent, so side_m is required")
        return self
