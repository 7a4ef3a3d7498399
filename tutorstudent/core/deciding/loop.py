"""A learner round a controller that works, in the owner's own loop and types."""

from __future__ import annotations

import logging
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.function_tutor import FunctionTutor
from tutorstudent.core.deciding.guard import Breach, is_owners
from tutorstudent.core.deciding.watching import ENOUGH, Notice, Watch
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import ContractError, TutorStudentWarning
from tutorstudent.core.words.snapshots import PLAIN, Snapshot


class Loop:
    """An engine round an existing controller, in the owner's own types.

    The first incident of each part and kind is logged as a warning of the logger ``tutorstudent``; all are in
    ``engine.incidents`` and counted in ``engine.incident_counts``.

    A learner that has no effect is told as a `TutorStudentWarning`: at once where that can be known, else after 200
    decisions, each kind of fault once. Where the owner has set up logging, the logger hears it too.
    """

    def __init__(self, engine: Engine[Any, Any, Any]) -> None:
        self.engine = engine
        self._counts = engine.incident_counts
        self._told: set[tuple[str, str]] = set()
        self._tutor = engine.tutor if isinstance(engine.tutor, FunctionTutor) else None
        watch = Watch(engine)
        self._watch: Watch | None = watch
        self._seen = engine.last
        self._noticed = {notice.kind for notice in watch.at_assembly}
        for notice in watch.at_assembly:
            self._point_out(notice)

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
        if self._watch is not None:
            self._look(self._watch)
        return command

    def _write(self, tutor: FunctionTutor, action: Action) -> Any:
        try:
            command, executed = tutor.write(action)
            if executed is not None:
                self.engine.executed(executed)
            tutor.left = executed or action, command
        except BaseException as error:
            if tutor.said is None and type(error) is Breach:  # the controller failed: its last command is an old one
                raise ContractError(f"on_tutor_failure: the action cannot be written: {error}") from error
            if tutor.said is None or is_owners(error):
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
        with _command_first():
            logging.getLogger("tutorstudent").warning(text, *words)

    def _look(self, watch: Watch) -> None:
        turn = self.engine.last
        if turn is None or turn is self._seen:
            return
        self._seen = turn
        watch.observe(turn)
        if watch.decisions < ENOUGH:
            return
        self._watch = None
        for notice in watch.find_notices():
            if notice.kind not in self._noticed:
                self._point_out(notice)

    def _point_out(self, notice: Notice) -> None:
        if logging.getLogger("tutorstudent").hasHandlers():
            self._warn("%s", notice.says)
        with _command_first():
            warnings.warn(notice.says, TutorStudentWarning, stacklevel=4)

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


@contextmanager
def _command_first() -> Iterator[None]:
    """Let nothing but a stop from outside come out: the command matters more than any logging or warning."""
    try:
        yield
    except BaseException as error:
        if is_owners(error):
            raise
