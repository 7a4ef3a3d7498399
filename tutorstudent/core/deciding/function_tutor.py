"""Existing controllers as tutors: any callable of a state."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tutorstudent.core.deciding.gate import check_written
from tutorstudent.core.deciding.guard import Breach, is_owners
from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.backup import Backup
from tutorstudent.core.words.commands import Command
from tutorstudent.core.words.errors import ContractError, quote
from tutorstudent.core.words.snapshots import PLAIN


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
        self.left: tuple[Action | None, Any] = None, None
        """What left for the owner last, as an action and in the owner's own type."""
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

    def write(self, action: Action) -> tuple[Any, Action | None]:
        """Return an action in the type that the callable returns, and what it really says if that is another action.

        Where it is what the callable said, that is its own object. The callable's own command stays as it is, whatever
        writing another one does to it.

        Raises:
            Breach: if the owner must not get what was written.
        """
        if action is self.said:
            return self.command, None
        if not isinstance(action, Command) or type(self.command) is self.action:
            return action, None
        backup = None if type(self.command) in PLAIN else Backup(self.command)
        try:
            command = action.write(self.command)
            executed = check_written(self.said or action, action, command, self.command)
        except BaseException as error:
            if backup is None or not backup.restore() or is_owners(error):
                raise
        else:
            if backup is None or not backup.restore():
                return command, executed
        raise Breach("mutated", "writing the amplified command changed the controller's own.")

    def _try_to_write(self, said: Action, command: Any) -> None:
        # A command that cannot be written is told at once, not when it is amplified for the first time.
        if isinstance(said, Command) and said is not command:
            backup = Backup(command)
            try:
                said.write(command)
            except Exception as error:
                raise ContractError(
                    f"the controller's command is {quote(command)}: a copy with other numbers cannot be made: "
                    f"{type(error).__name__}: {error}. Give read= and write= to ts.scalar() or ts.vector()."
                ) from error
            finally:
                backup.restore()
        self._writable = True


class HearingTutor(FunctionTutor):
    """A callable object with a method ``executed(command)``, which hears what was executed in its own type."""

    def executed(self, action: Any) -> None:
        said, command = self.left
        if action != said:  # whoever turns the engine without a `Loop`
            command = self.command if action == self.said else self.write(action)[0]
        self._function.executed(command)  # type: ignore[attr-defined]


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
