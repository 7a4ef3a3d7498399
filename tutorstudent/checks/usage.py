"""How parts of a role are used: what they are asked, and what a sound answer is."""

from __future__ import annotations

import abc
from collections.abc import Callable, Sequence
from typing import Any, ClassVar

from tutorstudent.checks.likeness import Unreadable
from tutorstudent.checks.outcome import RAISED, CheckFailed, CheckSkipped, describe_error
from tutorstudent.checks.subject import SEED, Subject
from tutorstudent.core.roles.part import EnginePart

Question = tuple[Any, ...]
"""What a part is handed at once."""


class Usage(abc.ABC):
    """Uses parts of one role as a pipeline would."""

    reads_states: ClassVar[bool] = False
    """Whether what it is asked is made of states."""

    def __init__(self, subject: Subject) -> None:
        self.subject = subject

    @abc.abstractmethod
    def make_questions(self, states: Sequence[Any]) -> list[Question]:
        """Return what the part is asked, in order."""

    @abc.abstractmethod
    def ask(self, part: Any, question: Question) -> Any:
        """Ask once, and return everything that the part says."""

    @abc.abstractmethod
    def judge(self, part: Any, question: Question, answer: Any) -> None:
        """Raise `CheckFailed` if the answer is not sound."""

    def recall(self, part: Any, question: Question) -> Any:
        """Ask without teaching."""
        return self.ask(part, question)

    def begin(self, part: Any) -> None:
        """Begin a trial."""
        if isinstance(part, EnginePart):
            part.reset()

    @property
    def states(self) -> Sequence[Any]:
        """The states that questions are made of."""
        return self.subject.states if self.reads_states else ()

    def make_usual(self) -> list[Question]:
        """Return what the part is asked in normal times."""
        return self.make_questions(self.states)

    def make_unreadable(self) -> Question:
        """Return a question that cannot be read."""
        if self.reads_states:
            return self.make_questions([Unreadable()])[0]
        return tuple(Unreadable() for _ in self.make_usual()[0])


def collect_answers(usage: Usage, part: Any, ask: Callable[[Any, Question], Any] | None = None) -> list[Any]:
    """Begin a trial, ask everything (by `ask` instead of the usage's own, if given), and return the answers.

    Raises:
        CheckSkipped: if the part raises, which is for the check ``works`` to tell.
    """
    try:
        usage.begin(part)
        return [(ask or usage.ask)(part, question) for question in usage.make_usual()]
    except (CheckFailed, CheckSkipped):
        raise
    except RAISED as error:
        raise explain_unusable(error) from error


def make_fresh(usage: Usage, slot: str = "", seed: int = SEED) -> Any:
    """Return a fresh, bound part.

    Raises:
        CheckSkipped: if it cannot be bound, which is for the check ``works`` to tell.
    """
    try:
        return usage.subject.make_bound(slot, seed)
    except RAISED as error:
        raise explain_unusable(error) from error


def close(part: Any) -> None:
    """Close a part.

    Raises:
        CheckSkipped: if it raises, which is for the check ``works`` to tell.
    """
    try:
        part.close()
    except RAISED as error:
        raise explain_unusable(error) from error


def explain_unusable(error: BaseException) -> CheckSkipped:
    """Return why other checks than ``works`` have nothing to say."""
    return CheckSkipped(f"see the check 'works': it cannot be used: {describe_error(error)}")
