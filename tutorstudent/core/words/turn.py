"""One turn of the loop: a decision with all that becomes of it, from asking the tutor to teaching the student."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Generic, NamedTuple

from tutorstudent.core.words.actions import ActionT, Group
from tutorstudent.core.words.proposals import Proposal
from tutorstudent.core.words.records import Decision, GradedAction, Incident, Lesson, Moment, Outcome, StateT

Fractions = tuple[float, ...]
"""One distance for each group of the action's kind, in units of the group's scale; none where nothing moves."""
Ends = tuple[tuple[float, ...], ...]
"""The values that each group of the action's kind is brought to; none where nothing moves."""


class Rung(NamedTuple):
    """What one level moves."""

    fractions: Fractions = ()
    """As the change says."""
    ends: Ends = ()
    """Where that brings the values, clipped to the bounds."""


FOOT = Rung()
"""Level 0: the tutor's own action."""
FIELDS = ("decision", "outcome", "lesson", "limited_by", "void", "incidents")
"""What everybody may read of a turn."""
Seal = tuple[type[Any], Callable[[dict[str, Any]], tuple[Any, ...]], tuple[Any, ...]]
"""An action's class, how its fields are read, and the very objects that it holds."""


class Turn(Generic[StateT, ActionT]):
    """A decision, what was executed, what it led to, what was taught, and why.

    Core writes the underscored attributes while the turn goes on; everybody else reads the properties. Parts and
    observers are given a turn once it is over. Its actions are copies: nobody but core sees the tutor's own object.
    """

    _original: ActionT
    """The tutor's own action."""
    _groups: tuple[Group, ...]
    _moment: Moment[StateT, ActionT]
    _proposal: Proposal | None = None
    _foresight: Any
    """What each level would execute."""
    _selected: GradedAction[ActionT]
    _resulting: GradedAction[ActionT]
    _rung: Rung
    """What the resulting level moves."""
    _limited_by = ""
    _decided_by = ""
    """The same as it was when the decision was made."""
    _incidents: list[Incident]
    _action: ActionT
    """What leaves for the robot, or what somebody says was executed instead."""
    _seals: tuple[Seal, Seal]
    """Of the two copies in the records: the tutor's action and the executed one."""
    _asked: Decision[StateT, ActionT]
    """The decision as it was made, before anybody said that something else was executed."""
    _decision: Decision[StateT, ActionT]
    _outcome: Outcome[StateT] | None = None
    _lesson: Lesson[StateT, ActionT] | None = None
    _void = ""
    """Why the owner or the tutor's failure keeps it from teaching anything."""
    _untold = ""
    """Why it is not known which level was executed."""

    def __init__(
        self,
        decision: Decision[StateT, ActionT],
        outcome: Outcome[StateT] | None = None,
        lesson: Lesson[StateT, ActionT] | None = None,
        incidents: Sequence[Incident] = (),
        void: str = "",
        limited_by: str = "",
    ) -> None:
        """Make a turn that is over, as the tests of an observer need it."""
        self._decision, self._outcome, self._lesson = decision, outcome, lesson
        self._incidents, self._void, self._limited_by = list(incidents), void, limited_by

    @classmethod
    def begin(cls, incidents: list[Incident]) -> Turn[StateT, ActionT]:
        """Return a turn of which nothing is known yet; core writes the rest."""
        turn = cls.__new__(cls)
        turn._incidents = incidents
        return turn

    @property
    def number(self) -> int:
        """Decision number, counted from 0 over all trials."""
        return self._decision.moment.number

    @property
    def decision(self) -> Decision[StateT, ActionT]:
        """The decision, with what was really executed."""
        return self._decision

    @property
    def limited_by(self) -> str:
        """Why the level is another than the amplifier's: ``cap``, ``factor``, ``slew``, ``highest level``, ``bounds``,
        ``nothing to move``, ``executed`` (somebody says that less was executed), or empty.
        """
        return self._limited_by

    @property
    def outcome(self) -> Outcome[StateT] | None:
        """What it led to; None for a decision that was dropped."""
        return self._outcome

    @property
    def lesson(self) -> Lesson[StateT, ActionT] | None:
        """What was taught, or None."""
        return self._lesson

    @property
    def void(self) -> str:
        """Why the decision teaches nothing, or empty."""
        return self._void or self._untold

    @property
    def incidents(self) -> tuple[Incident, ...]:
        """What went wrong in parts, in order."""
        return tuple(self._incidents)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Turn):
            return NotImplemented
        return all(getattr(self, name) == getattr(other, name) for name in FIELDS)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"Turn({', '.join(f'{name}={value!r}' for name in FIELDS if (value := getattr(self, name)))})"
