"""A learner round a controller that works, in the owner's own loop and types."""

from __future__ import annotations

import logging
from typing import Any

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.function_tutor import FunctionTutor
from tutorstudent.core.deciding.guard import is_owners
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.snapshots import PLAIN, Snapshot


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

        The controller is asked with the very object; the other parts see copies of what they read. At level 0 the
        command is the controller's own object. So it is where a changed command could not be made, or did not pass the
        last gate; that is an incident.
        """
        if type(state) in PLAIN:
            action = self.engine.step(state)
        else:
            with Snapshot() as snapshot:
                action = self.engine.step(state, snapshot.take(state, "state"))
        command = action if self._tutor is None else self._write(self._tutor, action)
        if len(self._counts) > len(self._told):
            self._tell()
        return command

    def _write(self, tutor: FunctionTutor, action: Action) -> Any:
        try:
            command, executed = tutor.write(action)
            if executed is not None:
                self.engine.executed(executed)
            tutor.left = executed or action, command
        except BaseException as error:
            if tutor.said is None or is_owners(error):  # the controller failed: its last command is an old one
                raise
            tutor.left = tutor.said, tutor.command
            self.engine.refused(error)
        return tutor.left[1]

    def _tell(self) -> None:
        for decision, part, kind, message in self.engine.incidents:
            if (part, kind) not in self._told:
                self._told.add((part, kind))
                self._warn(
                    "decision %d: %s: %s: %s (others of this kind are only counted)", decision, part, kind, message
                )

    def _warn(self, text: str, *words: object) -> None:
        try:
            logging.getLogger("tutorstudent").warning(text, *words)
        except BaseException as error:  # whatever the owner's logging is made of, the command is more important
            if is_owners(error):
                raise

    def executed(self, command: Any) -> None:
        """Say what was really executed instead of the last command."""
        if self._tutor is None:
            self.engine.executed(command)
            return
        action = self._tutor.read(command)
        self.engine.executed(action)
        self._tutor.left = action, command

    def void(self, reason: str) -> None:
        """Say that the last command must teach nothing (an emergency stop, teleoperation)."""
        self.engine.void(reason)
