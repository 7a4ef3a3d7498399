"""Tests the operational conditions on a resulting state (Thesis 3.2.2.5, 3.2.3 A-C)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Generic

from tutorstudent.core.deciding.guard import Breach, Guard
from tutorstudent.core.roles.leaves import Condition
from tutorstudent.core.words.proposals import require_bit, require_number
from tutorstudent.core.words.records import Margins, Outcome, StateT


class ReadOnly(Mapping[str, tuple[float, ...]]):
    """Margins by condition, for reading; unlike a mapping proxy it can be copied and sent to another process."""

    __slots__ = ("_margins",)

    def __init__(self, margins: Mapping[str, tuple[float, ...]]) -> None:
        self._margins = dict(margins)

    def __getitem__(self, name: str) -> tuple[float, ...]:
        return self._margins[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._margins)

    def __len__(self) -> int:
        return len(self._margins)

    def __repr__(self) -> str:
        return repr(self._margins)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._margins,)


NO_MARGINS: Margins = ReadOnly({})


class Judge(Generic[StateT]):
    """Asks every condition once about every resulting state. A condition that fails counts as violated."""

    def __init__(self, conditions: Sequence[Condition[StateT]], guard: Guard) -> None:
        self._conditions = [(condition, condition.label, _declares_margins(condition)) for condition in conditions]
        self._guard = guard
        self.margins: Margins | None = None
        """Of the state that was judged last; None at the beginning of a trial."""

    def forget(self) -> None:
        """Begin a trial: the next state has nothing before it."""
        self.margins = None

    def judge(self, state: StateT) -> Outcome[StateT]:
        """Return what the conditions say about the state that a decision led to."""
        violated: list[str] = []
        margins: dict[str, tuple[float, ...]] = {}
        for condition, name, declares in self._conditions:
            try:
                answer = _ask(condition, state)
                self._guard.check_recursion()
                if declares and (found := condition.margins(state)) is not None:
                    margins[name] = _check_margins(found)
            except BaseException as error:
                answer = True  # where it cannot say
                self._guard.record(f"conditions.{name}", error)
            if answer:
                violated.append(name)
        before, self.margins = self.margins, ReadOnly(margins) if margins else NO_MARGINS
        return Outcome(state, tuple(violated), before, self.margins)


def _declares_margins(condition: Condition[Any]) -> bool:
    return type(condition).margins is not Condition.margins


def _ask(condition: Condition[Any], state: Any) -> bool:
    answer = condition.violated(state)
    if answer is True or answer is False:
        return answer
    try:
        return require_bit(answer)
    except (TypeError, ValueError):
        raise Breach("wrong-return", f"violated() returned {type(answer).__name__}; return a bool.") from None


def _check_margins(found: Sequence[float]) -> tuple[float, ...]:
    margins = tuple(map(require_number, found))
    if any(math.isnan(margin) for margin in margins):
        raise Breach("not-finite", "margins() returned NaN; a condition whose margin is unknown counts as violated.")
    return margins
