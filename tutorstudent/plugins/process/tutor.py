"""A controller in another program as a tutor."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from typing import Any, ClassVar

from pydantic import ValidationError

from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.roles.option_problems import find_option_problems
from tutorstudent.core.roles.part import Component
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import ContractError, PipelineError
from tutorstudent.plugins.process import protocol
from tutorstudent.plugins.process.keeper import Keeper
from tutorstudent.plugins.process.plain import make_plain
from tutorstudent.plugins.process.process_options import ProcessOptions
from tutorstudent.plugins.process.vocabulary import find_action_class


class ProcessTutor(Tutor[Any, Any]):
    """Ask a program for every action, over its standard streams; any language, any environment.

    A decision takes `deadline_s` at most: then, or where the program breaks down, the tutor fails, and
    ``on_tutor_failure`` of the pipeline says what happens. docs/process-protocol.md is the protocol.
    """

    name: ClassVar[str] = "process"
    Options = ProcessOptions
    options: ProcessOptions

    _keeper: Keeper | None = None

    def __init__(self, **options: Any) -> None:
        super().__init__(**options)
        self.action: type[Action] = find_action_class(self.options.action, self.options.action_of)
        self._number = -1
        self._situation = ""

    def parts(self) -> Iterator[tuple[str, Component]]:
        """Yield nothing: only the action class of the world in the options is used; the world is never set up."""
        yield from ()

    def setup(self) -> None:
        """Start the program.

        Raises:
            PipelineError: It cannot be started, or does not say hello in time, or this is no POSIX system.
        """
        if not hasattr(os, "killpg"):
            raise PipelineError("tutor 'process' needs a POSIX system: process groups and pipes with a deadline.")
        seed = int(self.rng.integers(2**31))
        self._keeper = Keeper(self.options, protocol.make_hello(self.action, seed))
        self._keeper.start()

    def act(self, state: Any) -> Any:
        until_s = time.monotonic() + self.options.deadline_s
        self._number += 1
        self._situation = ""
        message = protocol.make_line("decide", number=self._number, state=make_plain(state))
        answer = self._require_keeper().ask(self._number, message, until_s)
        action = self._make_action(answer.action)
        self._situation = answer.situation
        return action

    @property
    def situation(self) -> str:
        return self._situation

    def executed(self, action: Any) -> None:
        if self._keeper is not None:
            self._keeper.tell(protocol.make_line("executed", number=self._number, action=action.model_dump()))

    def reset(self) -> None:
        super().reset()
        if self._keeper is not None:
            self._keeper.tell(protocol.make_line("reset"))

    def close(self) -> None:
        """End the program, with all that it started."""
        super().close()
        if self._keeper is not None:
            self._keeper.close()

    def _require_keeper(self) -> Keeper:
        if self._keeper is None:
            raise ContractError(
                "tutor 'process': the program was not started; bind the tutor, or give it to an engine."
            )
        return self._keeper

    def _make_action(self, values: dict[str, Any]) -> Action:
        try:
            return self.action(**values)
        except ValidationError as error:
            _, problem = find_option_problems(self.action, error)[0]
            raise ContractError(
                f"tutor 'process' ({self.options.program[0]}): its answer to decision {self._number} is not a "
                f"{self.action.__name__}: {problem}"
            ) from None
