"""A tiny world, tutor and parts for tests that need no simulator."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, Literal

from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.core.roles import part as part_module
from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.roles.leaves import condition
from tutorstudent.core.roles.part import Field
from tutorstudent.core.roles.world import Sketch, Step, World
from tutorstudent.core.words.actions import Action, AmplificationMap, component


class Push(Action):
    kind: Literal["push", "rest"]
    force: float = component(-1.0, 1.0, default=0.0, unit="N")
    amplification: ClassVar[AmplificationMap] = {"push": {"force": "outward"}, "rest": {}}


class Pusher(Tutor[float, Push]):
    """Push gently towards 10, rest beyond."""

    name = "pusher"
    action = Push

    def act(self, state: float) -> Push:
        return Push(kind="push", force=0.2) if state < 10 else Push(kind="rest")

    @property
    def situation(self) -> str:
        return "pushing"


class Rail(World[float, Push]):
    """A cart on a rail: position in metres; a trial ends at its end."""

    name = "rail"
    action = Push

    class Options(part_module.Options):
        length_m: float = Field(default=5.0, gt=0, description="where a trial ends")
        patience: int = Field(default=1000, ge=1, description="decisions after which a trial is cut off")

    @property
    def event_names(self) -> Mapping[str, Any]:
        return {"distance_m": "sum", "speed": "max", "x_m": "last", "force": "mean", "collided": "sum"}

    def reset(self, seed: int) -> float:
        self.x, self.steps = (seed % 7) / 10, 0
        return self.x

    def step(self, action: Push) -> Step[float]:
        self.steps += 1
        self.x += action.force
        events = {
            "distance_m": abs(action.force),
            "speed": action.force,
            "x_m": self.x,
            "force": action.force,
            "collided": float(self.x > self.options.length_m),
        }
        return Step(self.x, events, self.x > self.options.length_m, self.steps >= self.options.patience)

    def sketch(self) -> Sketch:
        return Sketch([(((0.0, 0.0), (self.options.length_m, 0.0)), "grey")])


@condition("crashed")
def Crashed(state: float) -> bool:
    """The cart is beyond the end."""
    return state > 5.0


def toy_registry() -> Registry:
    registry = Registry.discover()
    for cls in (Pusher, Rail, Crashed):
        registry.add(cls)
    return registry


PIPELINE = """\
seed: 3
decisions: 50
world: {use: rail, length_m: 5}
tutor: pusher
student:
  use: table
  encoder: {use: ranges, ranges: [[0, 5]]}
  codec: kind-level-ampbit
selector: same-kind
amplifier: {use: learning-phase, decisions: 10}
conditions: [crashed]
"""


def toy_pipeline(text: str = PIPELINE, registry: Registry | None = None) -> Pipeline:
    """Return the pipeline of a text, of the toys where no registry is given; its file is called ``p.yaml``."""
    return Pipeline(parse_yaml(text, "p.yaml"), registry or toy_registry())
