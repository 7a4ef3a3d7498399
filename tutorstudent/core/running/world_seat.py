"""The world's seat in the loop: what it returns is checked, and a wrong thing is named with world and decision."""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from typing import Any

from tutorstudent.core.roles.world import Step, World
from tutorstudent.core.running.whereabouts import RESET, STEP, Whereabouts
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import ContractError, quote
from tutorstudent.core.words.proposals import require_number

AS_STEP = "return a step, as in ts.Step(state, {'event': 1.0}, done=False)"


class WorldSeat:
    """Calls a world and checks what it returns."""

    def __init__(self, world: World[Any, Any], at: Whereabouts) -> None:
        self._world, self._at = world, at
        self._events = list(world.event_names)

    def reset(self, seed: int) -> Any:
        """Begin a trial and return its first state."""
        self._at.enter(RESET)
        return self._world.reset(seed)

    def step(self, action: Any) -> Step[Any]:
        """Execute the action and return the step.

        Raises:
            ContractError: if that is none, or an event is no number.
        """
        self._at.enter(STEP)
        step = self._world.step(action)
        if not isinstance(step, Step):
            hint = "; that is what a Gymnasium environment returns" if _is_gymnasiums(step) else ""
            raise self._make_error(f"returned {_describe(step)}{hint}; {AS_STEP}.")
        if not isinstance(step.events, Mapping):
            raise self._make_error(f"the events are {_describe(step.events)}; {AS_STEP}.")
        for name in self._events:
            if type(value := step.events.get(name, 0.0)) is not float:
                self._check_event(name, value)
        return step

    def _check_event(self, name: str, value: Any) -> None:
        try:
            require_number(value)
        except (TypeError, ValueError, OverflowError):
            raise self._make_error(
                f"the event '{name}' is {_describe(value)}; return a number, or leave the event out."
            ) from None

    def _make_error(self, problem: str) -> ContractError:
        return ContractError(f"decision {self._at.decision}: world '{self._world.name}': step(): {problem}")


def _describe(value: Any) -> str:
    if isinstance(value, tuple):
        return f"a {type(value).__name__} of {len(value)}"
    return f"{quote(value)} ({type(value).__name__})" if value is not None else "None"


def _is_gymnasiums(step: Any) -> bool:
    return isinstance(step, tuple) and len(step) in (4, 5)


def check_methods(world: World[Any, Any]) -> None:
    """Refuse a world whose methods cannot be called as the loop calls them, or that has no action class.

    Raises:
        ContractError: if so; the message says how it is written.
    """
    action = getattr(world, "action", None)
    if not (inspect.isclass(action) and issubclass(action, Action)):
        found = "it has no 'action'" if action is None else f"'action' is {quote(action)}"
        raise ContractError(
            f"world '{world.name}': {found}; name the class of actions that it executes, as in "
            "action = ts.scalar(-1, 1)."
        )
    for name, argument in (("reset", "seed"), ("step", "action")):
        try:
            inspect.signature(getattr(world, name)).bind(None)
        except ValueError:  # what is not written in Python may have no signature
            continue
        except TypeError:
            raise ContractError(
                f"world '{world.name}': {name}() cannot be called with one argument; write "
                f"def {name}(self, {argument})."
            ) from None
