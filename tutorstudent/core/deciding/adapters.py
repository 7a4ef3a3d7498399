"""Existing controllers as tutors: any callable of a state."""

from __future__ import annotations

import logging
from collections.abc import Callable
from typing import Any

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.commands import Command
from tutorstudent.core.words.errors import ContractError, quote
from tutorstudent.core.words.freezing import freeze


class FunctionTutor(Tutor[Any, Any]):
    """A callable of the state that returns an action, or a command that its action class can read.

    Where the callable is an object with a method ``reset()`` or a string ``situation``, they are the tutor's.
    """

    name = "function"

    def __init__(self, function: Callable[[Any], Any], action: type[Action]) -> None:
        super().__init__()
        self._function = function
        self.action = action
        self._command = action if issubclass(action, Command) else None
        self.command: Any = None
        """The last command of the callable that could be read, in the owner's own type."""
        self.said: Action | None = None
        """The same as an action; None where the callable's last command could not be read."""
        self._writable = False

    @property
    def situation(self) -> str:
        found = getattr(self._function, "situation", "")
        return found if isinstance(found, str) else ""

    def reset(self) -> None:
        if callable(reset := getattr(self._function, "reset", None)):
            reset()

    def act(self, state: Any) -> Any:
        self.said = None
        command = self._function(state)
        said = self.read(command)
        if not self._writable:
            self._try_to_write(said, command)
        self.said, self.command = said, command
        return said

    def read(self, command: Any) -> Action:
        """Return the action that a command stands for; raises ContractError if it is none of the action class."""
        if self._command is not None and type(command) is not self._command:
            return self._command.read(command)
        if isinstance(command, self.action):
            return command
        raise ContractError(f"the controller returned {type(command).__name__}; expected {self.action.__name__}.")

    def written(self, action: Action) -> Any:
        """Return an action in the type that the callable returns; its own object where that is what it said."""
        if action is self.said:
            return self.command
        if not isinstance(action, Command) or type(self.command) is self.action:
            return action
        return action.write(self.command)

    def _try_to_write(self, said: Action, command: Any) -> None:
        # A command that cannot be written is told at once, not when it is amplified for the first time.
        if isinstance(said, Command) and said is not command:
            try:
                said.write(command)
            except Exception as error:
                raise ContractError(
                    f"the controller's command is {quote(command)}: a copy with other numbers cannot be made: "
                    f"{type(error).__name__}: {error}. Give read= and write= to ts.scalar() or ts.vector()."
                ) from error
        self._writable = True


class HearingTutor(FunctionTutor):
    """A callable object with a method ``executed(command)``, which hears what was executed in its own type."""

    def executed(self, action: Any) -> None:
        own = self.command if action == self.said else self.written(action)
        self._function.executed(own)  # type: ignore[attr-defined]


def as_tutor(controller: Any, action: type[Action] | None) -> Tutor[Any, Any]:
    """Return a tutor as it is, and any other callable as a `FunctionTutor`, or a `HearingTutor` where it can hear.

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
    hears = callable(getattr(controller, "executed", None))
    return (HearingTutor if hears else FunctionTutor)(controller, action)


class Loop:
    """An engine round an existing controller, in the owner's own types.

    The first incident of each part and kind is logged as a warning of the logger ``tutorstudent``; all are in
    ``engine.incidents`` and counted in ``engine.incident_counts``.
    """

    def __init__(self, engine: Engine[Any, Any, Any]) -> None:
        self.engine = engine
        self._counts = engine.incident_counts
        self._told: set[tuple[str, str]] = set()
        self._tutor = engine.tutor if isinstance(engine.tutor, FunctionTutor) else None

    def step(self, state: Any) -> Any:
        """Return the command for this state, in the type that the controller returned.

        At level 0 it is the controller's own object; also where no other could be made, which is an incident.
        """
        command = self._write(self.engine.step(freeze(state)))
        if len(self._counts) > len(self._told):
            self._tell()
        return command

    def _write(self, action: Action) -> Any:
        tutor = self._tutor
        if tutor is None:
            return action
        try:
            return tutor.written(action)
        except Exception as error:
            if tutor.said is None:  # the controller failed: its last command is an old one
                raise
            self.engine.refused(error)
            return tutor.command

    def _tell(self) -> None:
        for decision, part, kind, message in self.engine.incidents:
            if (part, kind) not in self._told:
                self._told.add((part, kind))
                logging.getLogger("tutorstudent").warning(
                    "decision %d: %s: %s: %s (others of this kind are only counted)", decision, part, kind, message
                )

    def executed(self, command: Any) -> None:
        """Say what was really executed instead of the last command."""
        self.engine.executed(self._tutor.read(command) if self._tutor else command)

    def void(self, reason: str) -> None:
        """Say that the last command must teach nothing (an emergency stop, teleoperation)."""
        self.engine.void(reason)
