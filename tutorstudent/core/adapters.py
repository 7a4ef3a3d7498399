"""Existing controllers as tutors: any callable of a state."""

from __future__ import annotations

import copy
from collections.abc import Callable
from typing import Any

import numpy as np

from tutorstudent.core.actions import Action
from tutorstudent.core.commands import Command
from tutorstudent.core.engine import Engine
from tutorstudent.core.errors import ContractError
from tutorstudent.core.interfaces import Tutor


class FunctionTutor(Tutor[Any, Any]):
    """A callable of the state that returns an action, or a command that its action class can read."""

    name = "function"

    def __init__(self, function: Callable[[Any], Any], action: type[Action]) -> None:
        super().__init__()
        self._function = function
        self.action = action
        self.command: Any = None
        """The last command of the callable that could be read, in the owner's own type."""
        self.said: Action | None = None
        """The same as an action."""

    def act(self, state: Any) -> Any:
        command = self._function(state)
        if isinstance(command, self.action):
            self.said = command
        elif issubclass(self.action, Command):
            self.said = self.action.read(command)
        else:
            raise ContractError(f"the controller returned {type(command).__name__}; expected {self.action.__name__}.")
        self.command = command
        return self.said


def as_tutor(controller: Any, action: type[Action] | None) -> Tutor[Any, Any]:
    """Return a tutor as it is, and any other callable as a `FunctionTutor`.

    Raises:
        ContractError: if it is neither, or the action class is missing.
    """
    if isinstance(controller, Tutor):
        return controller
    if not callable(controller):
        raise ContractError(
            f"a controller is a Tutor or a callable of the state, not {type(controller).__name__}; "
            "pass the method that computes the command."
        )
    if not (isinstance(action, type) and issubclass(action, Action)):
        raise ContractError(
            f"action={action!r}: a callable needs the action class of what it returns, as in action=ts.scalar(-1, 1)."
        )
    return FunctionTutor(controller, action)


class Loop:
    """An engine round an existing controller, in the owner's own types."""

    def __init__(self, engine: Engine[Any, Any, Any]) -> None:
        self.engine = engine
        self._tutor = engine.tutor

    def step(self, state: Any) -> Any:
        """Return the command for this state, in the type that the controller returned.

        At level 0 it is the controller's own object.
        """
        return self._written(self.engine.step(read_only(state)))

    def executed(self, command: Any) -> None:
        """Say what was really executed instead of the last command."""
        tutor = self._tutor
        readable = isinstance(tutor, FunctionTutor) and issubclass(tutor.action, Command)
        self.engine.executed(tutor.action.read(command) if readable else command)  # type: ignore[attr-defined]

    def void(self, reason: str) -> None:
        """Say that the last command must teach nothing (an emergency stop, teleoperation)."""
        self.engine.void(reason)

    def _written(self, action: Action) -> Any:
        tutor = self._tutor
        if not isinstance(tutor, FunctionTutor) or not isinstance(action, Command):
            return action
        return tutor.command if action is tutor.said else action.write(tutor.command)


def read_only(state: Any) -> Any:
    """Return a copy of a state that its owner's buffers cannot change any more; its arrays are read-only.

    >>> frozen = read_only({"scan": np.zeros(2)})
    >>> frozen["scan"].flags.writeable
    False
    """
    if state is None or isinstance(state, str | bytes | bool | int | float | complex | np.generic):
        return state
    if isinstance(state, np.ndarray):
        copied = state.copy()
        copied.setflags(write=False)
        return copied
    if isinstance(state, dict):
        return {key: read_only(value) for key, value in state.items()}
    if isinstance(state, list):
        return [read_only(item) for item in state]
    if isinstance(state, tuple):
        items = [read_only(item) for item in state]
        return state._make(items) if hasattr(state, "_make") else tuple(items)
    return copy.deepcopy(state)
