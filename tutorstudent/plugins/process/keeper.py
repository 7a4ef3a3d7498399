"""Keeps a program running: starts it, greets it, asks it, and restarts it where that is allowed."""

from __future__ import annotations

import time

from tutorstudent.core.words.errors import ContractError, PipelineError
from tutorstudent.plugins.process import protocol
from tutorstudent.plugins.process.process_options import ProcessOptions
from tutorstudent.plugins.process.program import Program, Trouble
from tutorstudent.plugins.process.protocol import Answer, Unreadable

LONGEST_BACKOFF_S = 60.0
_NOT_STARTED = "Its path counts from the working directory, or from cwd, and it has to be executable."
_NOT_GREETED = "It has to say hello on its standard output; docs/process-protocol.md shows how."


class Keeper:
    """One program at a time. An answer counts only for the decision whose number it bears.

    Args:
        options: Of the tutor.
        hello: The first line that every program is told.
    """

    def __init__(self, options: ProcessOptions, hello: bytes) -> None:
        self._options, self._hello = options, hello
        self._program: Program | None = None
        self._restarts = self._late = 0
        self._reason, self._not_before_s = "", 0.0
        self._closed = False

    def start(self) -> None:
        """Start the program and wait until it says hello.

        Raises:
            PipelineError: if it does not.
        """
        try:
            program = self._begin()
            while not self._await_greeting(program, program.started_s + self._options.start_timeout_s):
                pass
        except Trouble as trouble:
            remedy = _NOT_STARTED if self._program is None else _NOT_GREETED
            self._lose(trouble)
            raise PipelineError(f"{self._format_name()}: {self._reason} {remedy}") from None

    def ask(self, number: int, message: bytes, until_s: float) -> Answer:
        """Return the answer to decision `number`.

        A program that broke down is restarted and asked again, as often as `restarts` allows and while there is time.

        Raises:
            ContractError: There is no answer; never later than at `until_s` of the monotonic clock.
        """
        while True:
            try:
                program = self._require_running(until_s)
                if not self._await_greeting(program, until_s):
                    raise ContractError(f"{self._format_name()}: {self._reason} It is being restarted.")
                if answer := self._await_answer(program, number, message, until_s):
                    self._late = 0
                    return answer
                raise self._count_late(program)
            except Trouble as trouble:
                self._lose(trouble)

    def tell(self, message: bytes) -> None:
        """Send a message that needs no answer, if the program runs."""
        if self._program is not None and self._program.greeted:
            try:
                self._program.send(message)
            except Trouble as trouble:
                self._lose(trouble)

    def close(self) -> None:
        """End the program; it is not started again."""
        if self._program is not None:
            self._program.close(protocol.make_line("close"))
            self._program = None
        self._closed = True

    def _require_running(self, until_s: float) -> Program:
        if self._program is not None:
            return self._program
        if self._closed:
            raise ContractError(f"{self._format_name()}: it was closed; a closed tutor cannot be asked.")
        if self._restarts >= self._options.restarts:
            used = f"all {self._restarts} restarts are used up" if self._restarts else "restarts: 0"
            raise ContractError(f"{self._format_name()}: {self._reason} It is not restarted ({used}).")
        if self._not_before_s >= until_s:
            raise ContractError(f"{self._format_name()}: {self._reason} It is restarted later (backoff_s).")
        time.sleep(max(0.0, self._not_before_s - time.monotonic()))
        self._restarts += 1
        return self._begin()

    def _begin(self) -> Program:
        self._program = Program(self._options)
        self._program.send(self._hello)
        return self._program

    def _await_greeting(self, program: Program, until_s: float) -> bool:
        if program.greeted:
            return True
        ready_s = program.started_s + self._options.start_timeout_s
        said = program.receive(min(until_s, ready_s))
        if said is None:
            if time.monotonic() >= ready_s:
                raise Trouble(f"it said no hello within {self._options.start_timeout_s:g} s (start_timeout_s)")
            return False
        try:
            protocol.check_hello(said)
        except Unreadable as error:
            raise Trouble(str(error)) from None
        program.greeted = True
        return True

    def _await_answer(self, program: Program, number: int, message: bytes, until_s: float) -> Answer | None:
        while (said := program.receive(0.0)) is not None:
            _read(said, number - 1)  # said before it was asked: old answers only, nobody can know what comes
            if time.monotonic() >= until_s:
                return None
        program.send(message)
        while (said := program.receive(until_s)) is not None:
            answer = _read(said, number)
            if answer.number == number:
                return answer
            if time.monotonic() >= until_s:
                return None
        return None

    def _count_late(self, program: Program) -> ContractError:
        self._late += 1
        waited = f"no answer within {self._options.deadline_s:g} s (deadline_s)"
        error = ContractError(f"{self._format_name()}: {waited}.{program.quote_errors()}")
        if self._late >= self._options.patience:
            self._lose(Trouble(f"{waited}, {self._late} times in a row (patience)"))
        return error

    def _lose(self, trouble: Trouble) -> None:
        self._reason = f"{trouble}."
        if self._program is not None:
            self._reason += self._program.quote_errors()
            self._program.kill()
            self._program = None
        self._late = 0
        wait_s = min(self._options.backoff_s * 2.0 ** min(self._restarts, 16), LONGEST_BACKOFF_S)
        self._not_before_s = time.monotonic() + wait_s

    def _format_name(self) -> str:
        return f"tutor 'process' ({self._options.program[0]})"


def _read(said: bytes, newest: int) -> Answer:
    try:
        answer = protocol.read_answer(said)
    except Unreadable as error:
        raise Trouble(str(error)) from None
    if answer.number > newest:
        raise Trouble(f"it answered decision {answer.number}, which it was not asked yet")
    return answer
