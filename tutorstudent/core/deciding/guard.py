"""Keeps what goes wrong in a part from reaching the robot, and remembers it."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Iterable
from contextlib import ExitStack
from inspect import CO_VARARGS
from itertools import pairwise
from sys import getrecursionlimit, setrecursionlimit
from types import FrameType, TracebackType
from typing import Any, Literal

from tutorstudent.core.words.errors import ContractError, UnreadableState
from tutorstudent.core.words.records import Incident

OnIncident = Literal["continue", "raise"]
REMEMBERED = 1000
_find_trace = BaseException.__dict__["__traceback__"].__get__
LIMIT_CHANGED = "mutated", "Python's recursion limit was changed; it is the owner's."
MESSAGE = 500
"""Longest message of an incident, in characters."""


class Breach(Exception):
    """A part did something that its contract forbids, other than raising. Never leaves the engine."""

    def __init__(self, kind: str, message: str) -> None:
        super().__init__(message)
        self.kind = kind


class Guard:
    """Records incidents. It never grows without bound: it counts all and remembers the newest."""

    def __init__(self, on_incident: OnIncident) -> None:
        self.on_incident = on_incident
        self.counts: Counter[tuple[str, str]] = Counter()
        """Incidents by (part, kind)."""
        self.log: deque[Incident] = deque(maxlen=REMEMBERED)
        self._first: int | None = None
        """The number of the first decision; None before it."""
        self._decision = 0
        self._incidents: list[Incident] = []
        self.recursion_limit = getrecursionlimit()
        """Python's, as it was when the owner called."""

    def begin_call(self) -> None:
        """Take in that the owner calls: what the recursion limit is now, is the owner's."""
        self.recursion_limit = getrecursionlimit()

    def attend(self, decision: int) -> list[Incident]:
        """Return the list that everything goes into which goes wrong from now on, until the next call."""
        self._decision, self._incidents = decision, []
        self._first = decision if self._first is None else self._first
        return self._incidents

    def blame(self, part: str) -> Blame:
        """Return the context in which a part works; what it raises there is an incident. It can be entered again."""
        return Blame(self, part)

    def record(self, part: str, error: BaseException) -> None:
        """Remember what a part raised; in ``raise`` mode, raise it. What is the owner's is raised again.

        Raises:
            ContractError: where incidents are to be raised.
            UnreadableState: in the first decision, since a part that cannot read the state will never work.
        """
        if getrecursionlimit() != self.recursion_limit:  # first of all: the next call may be one too many
            setrecursionlimit(self.recursion_limit)
        if is_owners(error) or (issubclass(type(error), UnreadableState) and self._decision == self._first):
            raise error
        kind, message = _say(error)
        incident = Incident(self._decision, part, kind, message)
        self.counts[part, kind] += 1
        self.log.append(incident)
        self._incidents.append(incident)
        if self.on_incident == "raise":
            raise ContractError(f"decision {self._decision}: {part}: {kind}: {message}") from error

    def check_recursion(self) -> None:
        """Put Python's recursion limit back and raise a `Breach`, where a part changed it."""
        if getrecursionlimit() != self.recursion_limit:
            setrecursionlimit(self.recursion_limit)
            raise Breach(*LIMIT_CHANGED)

    def call(self, part: str, function: Callable[[], Any]) -> None:
        """Call something that belongs to a part; what it raises is an incident."""
        with self.blame(part):
            function()

    def call_all(self, calls: Iterable[tuple[str, Callable[[], Any]]]) -> None:
        """Call one after the other, all of them, whatever some raise; only then is anything raised."""
        with ExitStack() as stack:
            for part, function in reversed(list(calls)):  # a stack is emptied from its end
                stack.callback(self.call, part, function)


class Blame:
    """Turns what a part raises into its incident. `failed` says afterwards whether it raised.

    The few places that every decision passes say `try` and `Guard.record` instead, which cost nothing where nothing
    is raised.
    """

    __slots__ = ("_guard", "_part", "failed")

    def __init__(self, guard: Guard, part: str) -> None:
        self._guard, self._part = guard, part
        self.failed = False

    def __enter__(self) -> None:
        self.failed = False

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> bool:
        if error is None:
            if getrecursionlimit() == self._guard.recursion_limit:
                return False
            setrecursionlimit(self._guard.recursion_limit)  # not by a call: it may be one too many
            error = Breach(*LIMIT_CHANGED)
        elif is_owners(error):
            return False
        self.failed = True
        self._guard.record(self._part, error)
        return True


def is_owners(error: BaseException) -> bool:
    """Return whether an exception is a stop from outside and not a part's.

    It is the owner's if it is Ctrl-C, or if a signal handler raised it. A handler is told apart by its call: Python
    calls it with the signal's number and the very frame that it interrupts, so that a function stands in the traceback
    whose last two arguments are a number and the frame below it.
    """
    if issubclass(type(error), KeyboardInterrupt):
        return True
    trace: TracebackType | None = _find_trace(error)  # a part's class may say otherwise
    while trace is not None:
        if _handles_a_signal(trace.tb_frame):
            return True
        trace = trace.tb_next
    return False


def _handles_a_signal(frame: FrameType) -> bool:
    code, below = frame.f_code, frame.f_back
    if below is None:
        return False
    values = frame.f_locals
    given = [values.get(name) for name in code.co_varnames[: code.co_argcount]]
    if code.co_flags & CO_VARARGS:
        rest = values.get(code.co_varnames[code.co_argcount + code.co_kwonlyargcount])
        given += rest if type(rest) is tuple else ()  # the function may have put something else there
    return any(argument is below and isinstance(number, int) for number, argument in pairwise(given))


def _say(error: BaseException) -> tuple[str, str]:
    """Return kind and message of what a part raised, however it behaves when it is looked at."""
    try:
        if type(error) is Breach and type(error.kind) is str:
            return error.kind, str(error)[:MESSAGE]
        name = str(type(error).__name__)
        try:
            return "raised", f"{name}: {error}"[:MESSAGE]
        except BaseException as another:
            if is_owners(another):
                raise
            return "raised", f"{name} (its message could not be read)"
    except BaseException as another:
        if is_owners(another):
            raise
        return "raised", "an exception that cannot even be named"
