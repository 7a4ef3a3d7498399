"""What the engine remembers of one decision (Thesis 3.2.3 a-e and A-C); `turn.Turn` holds all of it together.

All records are immutable tuples. The tutor's action in them is a copy; the engine keeps the original to itself.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Generic, NamedTuple, Protocol, TypeVar

from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.proposals import Proposal

StateT = TypeVar("StateT")

Margins = Mapping[str, tuple[float, ...]]


class Levels(Protocol):
    """What each level would execute in one decision, after all limits. Asked only by those who want to know."""

    @property
    def highest(self) -> int:
        """The highest level that cap and factor allow for any command of the tutor's, up to the thesis's eight."""

    def settle(self, level: int) -> int:
        """Return the level that would be executed if this one resulted."""

    def measure(self, level: int) -> tuple[float, ...]:
        """Return how far from neutral it would bring each group of components, in units of the group's scale."""


class Moment(NamedTuple, Generic[StateT, ActionT]):
    """What is known when a decision is made: all that students and encoders are given."""

    number: int
    """Decision number, counted from 0 over all trials."""
    state: StateT
    tutor_action: ActionT
    situation: str
    """What the tutor says it is in; empty where it says nothing."""
    margins: Margins | None = None
    """How far this state is from a violation, for the conditions that declare it; None at the beginning."""
    levels: Levels | None = None
    """What each level would execute; None where nobody can say, as in a test of a part by itself."""


class GradedAction(NamedTuple, Generic[ActionT]):
    """The tutor's action with an amplification level and an ampbit (Thesis 3.3.2)."""

    action: ActionT
    level: int
    ampbit: bool


class Decision(NamedTuple, Generic[StateT, ActionT]):
    """One turn of the loop before its outcome is known."""

    moment: Moment[StateT, ActionT]
    selected: GradedAction[ActionT]
    resulting: GradedAction[ActionT]
    executed: ActionT
    """What was executed: the rendered resulting action, or what `Engine.executed` reported."""
    proposal: Proposal | None
    """What the student proposed; None where it was not asked or failed."""

    @property
    def amplified(self) -> bool:
        """True if the amplifier raised the level in this decision."""
        return self.resulting.level > self.selected.level


class Outcome(NamedTuple, Generic[StateT]):
    """What a decision led to, as the operational conditions see it."""

    state: StateT
    violated: tuple[str, ...]
    """Names of the violated conditions, in the order of the pipeline."""
    margins_before: Margins | None
    """Margins of the previous state; None where that state was never judged."""
    margins: Margins
    """Margins of the resulting state, for the conditions that declare any; 0 means violated."""


class Lesson(NamedTuple, Generic[StateT, ActionT]):
    """What the evaluator teaches: the moment, the target, and the evidence behind it."""

    moment: Moment[StateT, ActionT]
    target: GradedAction[ActionT]
    executed_level: int
    executed: ActionT
    outcome: Outcome[StateT]


class Incident(NamedTuple):
    """Something a part did that its contract forbids, or a failure of a part."""

    decision: int
    part: str
    """Slot path of the part, for example ``student``."""
    kind: str
    """``raised``, ``wrong-return``, ``mutated``, ``not-finite`` or ``out-of-bounds``."""
    message: str
