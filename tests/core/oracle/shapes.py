"""Action classes of several shapes, and by hand what each of them promises.

The shapes are written down a second time on purpose: the judge must not read the package's vocabulary.
"""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import ClassVar, Literal, NamedTuple

from pydantic import field_validator

from tutorstudent.core.words.actions import Action, AmplificationMap, component
from tutorstudent.sims.pioneer.types import DriveAction

INFINITY = float("inf")
TINY = (5e-324, 1e-310, -2e-308, 1e-12, -1e-9)


class Valve(Action):
    """One kind, one component, away from shut."""

    opening: float = component(-1.0, 2.0)
    amplification: ClassVar[AmplificationMap] = {"command": {"opening": "outward"}}


class Flight(Action):
    """A velocity of three components with unequal bounds, moved together, and a yaw rate that stays."""

    kind: Literal["cruise", "hover"]
    forward_mps: float = component(-0.5, 2.0)
    left_mps: float = component(-1.0, 1.0)
    up_mps: float = component(-0.25, 0.5, scale=0.5)
    yaw_rps: float = component(-3.0, 3.0, default=0.0)
    amplification: ClassVar[AmplificationMap] = {
        "cruise": {("forward_mps", "left_mps", "up_mps"): "outward"},
        "hover": {},
    }


class Oven(Action):
    """A heater whose neutral is not zero, and a fan that runs with it."""

    kind: Literal["heat", "cool", "hold"]
    power: float = component(10.0, 100.0, neutral=40.0, scale=30.0, unit="%")
    fan: float = component(0.0, 10.0, neutral=2.0)
    label: str = "oven"
    amplification: ClassVar[AmplificationMap] = {
        "heat": {"power": "+", "fan": "+"},
        "cool": {"power": "-"},
        "hold": {"power": "outward"},
    }


class Notched(Action):
    """A lever that cannot rest in its notch, as only its validator knows."""

    lever: float = component(-1.0, 1.0)
    amplification: ClassVar[AmplificationMap] = {"command": {"lever": "outward"}}

    @field_validator("lever")
    @classmethod
    def _avoid_the_notch(cls, value: float) -> float:
        if 0.5 < abs(value) < 0.6:
            raise ValueError("it cannot rest there")
        return value


class Arm(NamedTuple):
    """What moves together: names, direction, the size of one whole unit, and where the components do nothing."""

    names: tuple[str, ...]
    direction: str
    scale: float
    neutral: tuple[float, ...]


Values = dict[str, float]


class Shape(NamedTuple):
    """What an action class promises, and what a tutor may say in it."""

    action: type[Action]
    kinds: tuple[str, ...]
    bounds: dict[str, tuple[float, float]]
    arms: dict[str, tuple[Arm, ...]]
    constants: dict[str, object]
    refuses: str = ""
    """Who is blamed for nothing hostile: the action itself, where its class refuses some values within bounds."""

    def draw(self, random: Random, kind: str | None = None) -> Action:
        """Return something that a tutor might say: mostly ordinary, often at an edge."""
        kind = kind or random.choice(self.kinds)
        neutral = {name: at for arm in self.arms[kind] for name, at in zip(arm.names, arm.neutral, strict=True)}
        draw = _faint if random.random() < 0.05 else _value
        while True:
            values = {name: draw(random, *ends, neutral.get(name, 0.0)) for name, ends in self.bounds.items()}
            try:
                return self.action(kind=kind, **values, **self.constants)
            except ValueError:
                if not self.refuses:
                    raise


def _faint(random: Random, low: float, high: float, neutral: float) -> float:
    return min(max(neutral + random.choice((0.0, *TINY)), low), high)


def _value(random: Random, low: float, high: float, neutral: float) -> float:
    high = min(high, 5.0) if high == INFINITY else high
    dice = random.random()
    if dice < 0.55:
        value = random.uniform(low, high)
    elif dice < 0.75:
        value = neutral + random.uniform(-0.1, 0.1) * (high - low)
    else:
        value = random.choice((low, high, neutral, neutral, -0.0, *(neutral + tiny for tiny in TINY)))
    return min(max(value, low), high)


DRIVE = Shape(
    DriveAction,
    ("stop", "forward", "backward", "left", "right"),
    {"translation": (-1.0, 1.0), "rotation": (-1.0, 1.0), "duration_s": (0.0, 3600.0)},
    {
        "stop": (),
        "forward": (Arm(("translation",), "+", 1.0, (0.0,)),),
        "backward": (Arm(("translation",), "-", 1.0, (0.0,)),),
        "left": (Arm(("rotation",), "+", 1.0, (0.0,)),),
        "right": (Arm(("rotation",), "-", 1.0, (0.0,)),),
    },
    {},
)
VALVE = Shape(
    Valve, ("command",), {"opening": (-1.0, 2.0)}, {"command": (Arm(("opening",), "outward", 2.0, (0.0,)),)}, {}
)
FLIGHT = Shape(
    Flight,
    ("cruise", "cruise", "cruise", "hover"),
    {"forward_mps": (-0.5, 2.0), "left_mps": (-1.0, 1.0), "up_mps": (-0.25, 0.5), "yaw_rps": (-3.0, 3.0)},
    {"cruise": (Arm(("forward_mps", "left_mps", "up_mps"), "outward", 0.5, (0.0, 0.0, 0.0)),), "hover": ()},
    {},
)
OVEN = Shape(
    Oven,
    ("heat", "cool", "hold"),
    {"power": (10.0, 100.0), "fan": (0.0, 10.0)},
    {
        "heat": (Arm(("power",), "+", 30.0, (40.0,)), Arm(("fan",), "+", 10.0, (2.0,))),
        "cool": (Arm(("power",), "-", 30.0, (40.0,)),),
        "hold": (Arm(("power",), "outward", 30.0, (40.0,)),),
    },
    {"label": "my oven"},
)
NOTCHED = Shape(
    Notched,
    ("command",),
    {"lever": (-1.0, 1.0)},
    {"command": (Arm(("lever",), "outward", 1.0, (0.0,)),)},
    {},
    refuses="action",
)
SHAPES = (DRIVE, VALVE, FLIGHT, OVEN, NOTCHED)

Law = Callable[[float, float], float]
"""(level x amount, the tutor's own magnitude in units of scale) -> distance in units of scale."""
LAWS: dict[str, Law] = {
    "additive": lambda amplification, magnitude: amplification,
    "multiplicative": lambda amplification, magnitude: amplification * magnitude,
}
