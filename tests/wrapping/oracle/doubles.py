"""Broken loops, each broken in one way: the judge has to name what is wrong with every one of them."""

from __future__ import annotations

import copy
from collections.abc import Callable
from typing import Any

import numpy as np

import tutorstudent as ts
from tests.wrapping.oracle.imprint import Path
from tests.wrapping.oracle.kits import Kit


class Broken:
    """A loop round a sound one, which does something else with what leaves."""

    def __init__(self, controller: Any, *, action: Any, **others: Any) -> None:
        self.controller, self.rules = controller, controller._rules
        self.loop = ts.wrap(controller, action=action, **self.change(others))
        self.engine, self.executed, self.void = self.loop.engine, self.loop.executed, self.loop.void

    def change(self, others: dict[str, Any]) -> dict[str, Any]:
        return others

    def step(self, state: Any) -> Any:
        return self.spoil(self.loop.step(state), self.controller.said.itself)

    def spoil(self, received: Any, own: Any) -> Any:
        return received


def replacing(number: Callable[[float, Any], float]) -> type[Broken]:
    """Return a loop that puts another number in the place of the first."""

    def spoil(self: Broken, received: Any, own: Any) -> Any:
        kit = self.rules.kit
        return put(kit, received, number(float(kit.read(own)[0]), self.rules))

    return type("Replacing", (Broken,), {"spoil": spoil})


def put(kit: Kit, command: Any, number: float) -> Any:
    """Return a command with another first number, as nobody should make one; itself where that is hard to do."""
    if isinstance(command, np.ndarray):
        made = command.copy()
        made.flat[0] = number
        return made
    if kit.skipped == ((),):
        return type(command)(number)
    if isinstance(command, tuple):
        return (
            type(command)((number, *command[1:])) if type(command) is tuple else command._make((number, *command[1:]))
        )
    if not kit.skipped:
        return command
    made = copy.deepcopy(command)
    _set(made, kit.skipped[0], number)
    return made


def _set(made: Any, path: Path, number: Any) -> None:
    *way, last = path
    for step in way:
        made = made[step] if isinstance(made, dict | list) else getattr(made, step)
    if isinstance(made, dict):
        dict.__setitem__(made, last, number)
    elif isinstance(made, list):
        made[last] = number
    else:
        object.__setattr__(made, last, number)


class Forgetful(Broken):
    """Forgets the limits."""

    forgets: dict[str, Any] = {}

    def change(self, others: dict[str, Any]) -> dict[str, Any]:
        limits = others["limits"] | {key: value for key, value in self.forgets.items() if key == "cap"}
        return others | {key: value for key, value in self.forgets.items() if key != "cap"} | {"limits": limits}


def forgetting(**limits: Any) -> type[Forgetful]:
    """Return a loop with other limits than its owner wrote."""
    return type("Forgetting", (Forgetful,), {"forgets": limits})


class Retyping(Broken):
    """Returns lists for tuples, floats for other numbers, and dictionaries for objects."""

    def spoil(self, received: Any, own: Any) -> Any:
        kit = self.rules.kit
        if kit.size == 1 and kit.skipped == ((),):
            return float(received)
        if isinstance(received, tuple | list | np.ndarray):
            return kit.read(received) if not isinstance(received, list) else tuple(received)
        return dict(vars(received)) if hasattr(received, "__dict__") else received


class Tidying(Broken):
    """Changes what is not declared."""

    def spoil(self, received: Any, own: Any) -> Any:
        made = copy.deepcopy(received)
        for name in ("mode", "frame", "label", "gear", "path"):
            if isinstance(made, dict) and name in made:
                dict.__setitem__(made, name, "tidy")
            elif hasattr(made, name) and not isinstance(made, tuple):
                object.__setattr__(made, name, "tidy")
        return made


class Scribbling(Broken):
    """Writes into the controller's own command."""

    def spoil(self, received: Any, own: Any) -> Any:
        kit = self.rules.kit
        if isinstance(own, np.ndarray):
            own.flat[0] = own.flat[0] / 2 + 1
        elif kit.skipped and kit.skipped != ((),) and not isinstance(own, tuple):
            _set(own, kit.skipped[0], float(kit.read(own)[0]) / 2 + 1)
        return received


class Asking(Broken):
    """Asks the controller twice."""

    def step(self, state: Any) -> Any:
        self.controller(state)
        return super().step(state)


class Copying(Broken):
    """Asks the controller with a copy of the state."""

    def step(self, state: Any) -> Any:
        return super().step(copy.deepcopy(state))


class Meddling(Broken):
    """Changes the owner's state."""

    def step(self, state: Any) -> Any:
        received = super().step(state)
        state["scan"][0] += 1
        return received


class Mute(Broken):
    """Keeps silent about incidents."""

    def __init__(self, controller: Any, **others: Any) -> None:
        super().__init__(controller, **others)
        self.engine._guard.record = lambda *args: None  # type: ignore[method-assign]


class Paranoid(Broken):
    """Blames the student for nothing."""

    def spoil(self, received: Any, own: Any) -> Any:
        self.engine._guard.record("student", ValueError("I do not trust it"))
        return received


class Ungated(Broken):
    """Lets out whatever the owner's types make."""

    def __init__(self, controller: Any, **others: Any) -> None:
        super().__init__(controller, **others)
        tutor: Any = self.engine.tutor
        tutor.write = lambda action: (tutor.command if action is tutor.said else action.write(tutor.command), None)


class Stubborn(Broken):
    """Returns something else where the action was refused."""

    def spoil(self, received: Any, own: Any) -> Any:
        return copy.deepcopy(received)


class Misleading(Broken):
    """Tells the controller that its own command was executed."""

    def spoil(self, received: Any, own: Any) -> Any:
        tutor: Any = self.engine.tutor
        tutor.left = tutor.left[0], own
        return received


class Reusing(Broken):
    """Writes into what it returned before."""

    before: Any = None

    def spoil(self, received: Any, own: Any) -> Any:
        if isinstance(self.before, np.ndarray) and self.before is not own and self.before is not received:
            self.before.flat[0] = self.before.flat[0] / 2 + 1
        self.before = received
        return received


class Fragile(Broken):
    """Lets a part's exceptions through."""

    def change(self, others: dict[str, Any]) -> dict[str, Any]:
        return others | {"on_incident": "raise"}


BROKEN: dict[str, tuple[type[Broken], str]] = {
    "puts NaN into a command": (replacing(lambda own, rules: float("nan")), "finite"),
    "goes out of bounds": (replacing(lambda own, rules: rules.bounds.high[0] * 2), "bounds"),
    "turns round": (replacing(lambda own, rules: rules.bounds.neutral), "direction"),
    "goes to the end": (replacing(lambda own, rules: rules.bounds.high[0]), "cap"),
    "goes to the end whatever the factor": (replacing(lambda own, rules: rules.bounds.high[0]), "factor"),
    "forgets the cap": (forgetting(cap=50.0), "cap"),
    "forgets the factor": (forgetting(factor=None), "factor"),
    "forgets the slew": (forgetting(slew=None), "slew"),
    "returns other types": (Retyping, "type"),
    "changes what is not declared": (Tidying, "rest"),
    "writes into the controller's own command": (Scribbling, "own changed"),
    "asks twice": (Asking, "asked"),
    "hands out a copy of the state": (Copying, "state"),
    "changes the state": (Meddling, "state"),
    "keeps silent about incidents": (Mute, "incident"),
    "blames a part for nothing": (Paranoid, "false alarm"),
    "has no gate": (Ungated, "finite"),
    "returns a copy where the action was refused": (Stubborn, "fallback"),
    "tells the controller something else": (Misleading, "heard"),
    "writes into what was received before": (Reusing, "given"),
    "lets exceptions through": (Fragile, "loop"),
}
