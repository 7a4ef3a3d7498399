"""A controller in an owner's own types, the owner's state, and hostile parts that are shown it."""

from __future__ import annotations

from random import Random
from typing import Any

import numpy as np
from pydantic import BaseModel

from tests.core.oracle.behaviours import BLAMED, EVALUATION, PROPAGATION
from tests.core.oracle.cast import (
    PlottedAmplifier,
    PlottedChange,
    PlottedEvaluator,
    PlottedModifier,
    PlottedSameKind,
)
from tests.core.oracle.learner import Numbers, PlainKinds, PlainLevels, Plotted, PlottedStudent
from tests.core.oracle.plot import Plot
from tests.core.oracle.shapes import TINY
from tests.wrapping.oracle.imprint import imprint
from tests.wrapping.oracle.judge import Rules, Said, say
from tests.wrapping.oracle.kits import KITS, SCALARS, Bounds, Kit
from tests.wrapping.oracle.meddling import ACTS, HAND, OWN_CHANGED, SPOILS
from tutorstudent.core.roles.leaves import Condition

SHOWN = ("spoil propose", "spoil teach", "spoil violated")
BEHAVIOURS = PROPAGATION | EVALUATION | ACTS | dict.fromkeys(SHOWN, SPOILS)
BLAMES = BLAMED | dict.fromkeys(ACTS, ("action",))
EVERYTHING = [(slot, name) for slot, acts in BEHAVIOURS.items() for name in acts]
OFTEN = [*EVERYTHING, *(pair for pair in EVERYTHING if pair[0] in ACTS)] + 5 * [("whole", name) for name in OWN_CHANGED]
"""The same, with more of what only few forms of command give an opportunity for."""


class Robot:
    """An object inside a state."""

    def __init__(self, hot: bool) -> None:
        self.hot, self.parts = hot, [1, 2]


def make_state(random: Random, number: int) -> dict[str, Any]:
    """Return an owner's state: a mapping with an array, a list and an object in it."""
    hot = random.random() < 0.4
    scan = np.array([random.random(), number])
    return {"number": number, "hot": hot, "margin": random.random(), "scan": scan, "trace": [1, 2], "robot": Robot(hot)}


class Controller:
    """Say something valid; keep a record by value of what was said, and the very state that it was asked with."""

    def __init__(self, random: Random, rules: Rules) -> None:
        self._random, self._rules = random, rules
        self.asked: list[Any] = []
        self.said: Said | None = None
        self.fails: BaseException | None = None

    def __call__(self, state: Any) -> Any:
        self.asked.append(state)
        if self.fails is not None:
            raise self.fails
        dice, kit = self._random.random(), self._rules.kit
        if self.said is None or dice > 0.3:
            self.said = say(kit, draw(self._random, kit, self._rules.bounds))
        elif dice < 0.1:
            self.said = say(kit, refill(self.said.itself, draw(self._random, kit, self._rules.bounds)))
        HAND.awake = HAND.works
        return self.said.itself


def refill(buffer: Any, command: Any) -> Any:
    """Return the buffer with what a command holds, as controllers reuse theirs; the command where it is no buffer."""
    if isinstance(buffer, np.ndarray):
        buffer[...] = command
    elif isinstance(buffer, list):
        buffer[:] = command
    elif isinstance(buffer, dict):
        dict.clear(buffer)
        dict.update(buffer, command)
    elif isinstance(buffer, BaseModel | tuple) or not hasattr(buffer, "__dict__"):
        return command
    else:
        vars(buffer).update(vars(command))
    return buffer


class Hearing(Controller):
    """One that hears what was executed."""

    def __init__(self, random: Random, rules: Rules) -> None:
        super().__init__(random, rules)
        self.heard: list[Any] = []

    def executed(self, command: Any) -> None:
        self.heard.append(imprint(command))


class Shown(PlottedStudent):
    """A student that meddles with the state that it is shown."""

    name = "shown"

    def propose(self, moment: Any) -> Any:
        self.options.plot.twist("spoil propose", lambda: None, [moment.state])
        return super().propose(moment)

    def teach(self, lesson: Any) -> None:
        self.options.plot.twist("spoil teach", lambda: None, [lesson.moment.state])
        super().teach(lesson)


class Flag(Condition[Any]):
    """Too hot."""

    name = "flag"
    Options = Plotted

    def violated(self, state: Any) -> Any:
        self.options.plot.twist("spoil violated", lambda: None, [state])
        return self.options.plot.twist("condition", lambda: state["hot"])

    def margins(self, state: Any) -> Any:
        return self.options.plot.twist("margins", lambda: (state["margin"],))


def make_parts(plot: Plot, rules: Rules, phase: int, kinds: bool) -> dict[str, Any]:
    """Return all slots beside the controller, as `ts.wrap` takes them."""
    codec = PlainKinds(plot=plot) if kinds else PlainLevels(plot=plot)
    change = PlottedChange(plot=plot, law=rules.law)
    return {
        "student": Shown(plot=plot, encoder=Numbers(plot=plot), codec=codec),
        "selector": PlottedSameKind(plot=plot) if kinds else PlottedModifier(plot=plot),
        "amplifier": PlottedAmplifier(plot=plot, decisions=phase, amount=rules.amount, change=change),
        "evaluator": PlottedEvaluator(plot=plot),
        "conditions": [Flag(plot=plot)],
    }


def draw_rules(random: Random) -> Rules:
    """Return what some owner might have written."""
    kit, cap = random.choice(KITS), random.choice((0.1, 0.3, 0.5, 0.8, 0.8, 2.0, 500.0))
    return Rules(
        kit=kit,
        bounds=_draw_bounds(random, kit),
        cap=cap,
        factor=None if cap > 100 else random.choice((None, None, 1.0, 1.1, 1.3, 2.5)),  # where levels end at 1000
        slew=random.choice((None, None, 1, 2, 5)),
        amount=random.choice((0.1, 0.1, 0.05, 0.25, 0.037) if cap < 100 else (0.1, 1e-5)),
        law=random.choice(("additive", "multiplicative")),
    )


def _draw_bounds(random: Random, kit: Kit) -> Bounds:
    ends = random.choice(((-1.0, 1.0), (-0.1, 0.1), (-1.0, 2.0), (10.0, 100.0), (-5e4, 5e4), (-1e9, 1e9)))
    ends = (-3e4, 3e4) if "16" in kit.name and ends[1] > 3e4 else ends  # the type ends at 65504
    neutral = random.choice((0.0, 0.0, ends[0], ends[0] + 0.3 * (ends[1] - ends[0])))
    neutral = min(max(neutral, ends[0]), ends[1])
    if kit in SCALARS or (kit.size == 1 and "names" not in kit.how):
        scale = random.choice((max(map(abs, ends)), 0.25 * (ends[1] - ends[0])))
        return Bounds(ends[:1], ends[1:], neutral, scale)
    high = tuple(ends[1] * random.choice((1.0, 1.0, 1.5)) for _ in range(kit.size))
    low = (ends[0],) * kit.size
    return Bounds(low, high, neutral, min(max(abs(a), abs(b)) for a, b in zip(low, high, strict=True)))


def draw(random: Random, kit: Kit, bounds: Bounds) -> Any:
    """Return a command within bounds, also as the owner's type holds it."""
    while True:
        ends = zip(bounds.low, bounds.high, strict=True)
        command = kit.make([_draw_number(random, low, high, bounds.neutral) for low, high in ends])
        held = [float(number) for number in kit.read(command)]
        if all(low <= number <= high for number, low, high in zip(held, bounds.low, bounds.high, strict=True)):
            return command


def _draw_number(random: Random, low: float, high: float, neutral: float) -> float:
    dice = random.random()
    if dice < 0.55:
        value = random.uniform(low, high)
    elif dice < 0.85:
        value = neutral + random.uniform(-0.1, 0.1) * (high - low)
    else:
        value = random.choice((low, high, neutral, neutral, -0.0, *(neutral + tiny for tiny in TINY)))
    return min(max(value, low), high)
