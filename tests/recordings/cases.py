"""What is recorded: every shipped pipeline, in every scene that it is made for, and the loops round a callable."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

import tutorstudent as ts

ROOT = Path(__file__).parents[2]
PROTOTYPE2 = ROOT / "examples/prototype2/tutorstudent_prototype2/pipelines"
CONTROLLERS = ROOT / "examples/controllers/tutorstudent_controllers"
SCENES = ("chase-avoid", "cave-box", "cave-predator-prey", "cave-predator-prey-box")
MULTIPLICATIVE = {"use": "learning-phase", "decisions": 100, "change": "multiplicative"}
CONTROLS: dict[str, dict[str, Any]] = {
    "ramp": {"student": "ramp", "selector": "modifier", "amplifier": "never"},
    "random": {"student": "random", "selector": "modifier", "amplifier": "never"},
    "constant": {"student": {"use": "constant", "level": 6}, "selector": "modifier", "amplifier": "never"},
    "blind": {"evaluator": {"use": "blind", "evaluator": "conditions"}},
    "slew": {"limits": {"cap": 0.5, "factor": 1.5, "slew": 1}, "amplifier": MULTIPLICATIVE},
}


def pipelines() -> Iterator[tuple[str, ts.Pipeline]]:
    """Yield every shipped pipeline with a name, short enough to be run in a test."""
    for scene in SCENES:
        for name in ("prototype2", "prototype2a", "streamlined"):
            yield f"{name} in {scene}", _read(PROTOTYPE2 / f"{name}.yaml", {"world.scene": scene})
    for name, slots in CONTROLS.items():
        values = {"world.scene": "cave-box"} | slots
        yield f"prototype2a with {name}", _read(PROTOTYPE2 / "prototype2a.yaml", values)
    for path in sorted(CONTROLLERS.glob("*/*.yaml")):
        yield path.stem, _read(path, {})


def _read(path: Path, values: dict[str, Any]) -> ts.Pipeline:
    return ts.Pipeline.read(path).replaced({"decisions": 400, **values})


def loops() -> dict[str, Callable[[], list[Any]]]:
    """Return what drives `ts.wrap`, each with a function that returns the commands in the owner's own type."""
    return {"wrapped scalar": _scalar, "wrapped vector": _vector, "wrapped mapping": _mapping}


def _states() -> list[float]:
    return [float(number) for number in np.random.default_rng(3).normal(75, 8, 400)]


def _scalar() -> list[Any]:
    loop = ts.wrap(
        lambda y: float(np.clip((70 - y) / 30, -1, 1)),
        action=ts.scalar(-1, 1),
        condition=lambda y: y > 80,
        ranges=[(50, 100)],
        seed=7,
    )
    return [loop.step(y) for y in _states()]


def _vector() -> list[Any]:
    loop = ts.wrap(
        lambda y: np.array([np.sin(y), np.cos(y) / 2]),
        action=ts.vector([-1, -1], [1, 1], size=2),
        conditions=[lambda y: y > 85, lambda y: y < 60],
        seed=7,
        factor=1.8,
        slew=None,
    )
    return [loop.step(y).tolist() for y in _states()]


def _mapping() -> list[Any]:
    loop = ts.wrap(
        lambda y: {"speed": (y % 10) / 10, "mode": "eco"},
        action=ts.vector([-1], [1], names=["speed"]),
        condition=lambda y: y > 80,
        student={
            "use": "backprop",
            "hidden": 6,
            "encoder": {"use": "ranges", "ranges": [[50, 100]]},
            "codec": "level-ampbit",
        },
        seed=7,
    )
    return [loop.step(y)["speed"] for y in _states()]
