"""What a closed loop costs beyond the bare pybullet calls that it makes, and what each further robot costs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from ruamel.yaml import YAML

from tests.bench.parts import FULL, Work, engine
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.roles.world import World
from tutorstudent.sims.pioneer.bullet import Bullet, load_pybullet
from tutorstudent.sims.pioneer.calls import CallLog, bind_calls
from tutorstudent.sims.pioneer.pioneer_world import PioneerWorld
from tutorstudent.sims.pioneer.types import DriveAction

SCENES = Path(__file__).parents[2] / "tutorstudent" / "sims" / "pioneer" / "scenes"
DECISIONS = 1500
SEED = 7


def alone(directory: Path) -> Path:
    """Write the cave without other robots and return its path."""
    yaml = YAML()
    scene = yaml.load((SCENES / "cave-predator-prey.yaml").read_text(encoding="utf-8"))
    scene["robots"] = [robot for robot in scene["robots"] if robot.get("controller", "learner") == "learner"]
    scene["walls"] = str(SCENES / scene["walls"])
    path = directory / "cave-alone.yaml"
    with path.open("w", encoding="utf-8") as stream:
        yaml.dump(scene, stream)
    return path


def closed_loop_work(name: str, scene: str) -> Work:
    """Return the closed loop in a scene, and the bare pybullet calls that the same loop made."""
    world, log = _world(scene, logged=True)
    _drive(world)()
    calls = list(log.calls)
    replayed, _ = _world(scene, logged=False)
    replayed.reset(SEED)
    bare = bind_calls(calls, load_pybullet(), replayed._bullet.client)
    timed, _ = _world(scene, logged=False)
    return {
        f"{name}: closed loop": (_drive(timed), DECISIONS),
        f"{name}: its bare pybullet calls": (lambda: [call() for call in bare], DECISIONS),
    }


def _world(scene: str, *, logged: bool) -> tuple[Any, CallLog]:
    log = CallLog(load_pybullet())
    world: World[Any, Any] = PioneerWorld(scene=scene)
    world.connect(Bullet(log if logged else load_pybullet()))  # type: ignore[attr-defined]
    world.bind(Binding(SEED, "world", DriveAction))
    return world, log


def _drive(world: Any) -> Callable[[], None]:
    loop = engine(FULL)
    state = world.reset(SEED)
    if hasattr(world._bullet.api, "clear"):
        world._bullet.api.clear()

    def call() -> None:
        nonlocal state
        for _ in range(DECISIONS):
            state = world.step(loop.step(state)).state

    return call
