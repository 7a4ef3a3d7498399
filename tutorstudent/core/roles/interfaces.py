"""The roles of the algorithm, in the order of Thesis 3.2.2. The page to read first.

The engine asks them once per decision, in this order::

    tutor_action = tutor.act(state)
    proposal = student.propose(moment)
    selected = selector.select(tutor_action, proposal)
    resulting = amplifier.amplify(selected, decision_number)

and once the resulting state is known::

    lesson = evaluator.evaluate(decision, outcome)
    student.teach(lesson)

No method may block, keep or change what it is handed.
"""

from __future__ import annotations

import abc
from typing import Any, ClassVar, Generic

from tutorstudent.core.roles.leaves import Change
from tutorstudent.core.roles.part import EnginePart
from tutorstudent.core.words.actions import Action, ActionT
from tutorstudent.core.words.proposals import Proposal, ProposalT
from tutorstudent.core.words.records import Decision, GradedAction, Lesson, Moment, Outcome, StateT

SLOTS = ("tutor", "student", "selector", "amplifier", "evaluator")
"""Where the parts of an engine stand in a pipeline, in the order in which they are made."""


class Tutor(EnginePart, Generic[StateT, ActionT]):
    """The existing, proven controller (Thesis 3.2.2.1). It stays in command of the action's kind."""

    role: ClassVar[str] = "tutor"
    action: type[Action]
    """The class of its actions."""

    @abc.abstractmethod
    def act(self, state: StateT) -> ActionT:
        """Return the action for this state. Called exactly once per decision, in order; it may keep a memory."""

    @property
    def situation(self) -> str:
        """What the tutor is in, after `act`: a planner's state, a behaviour tree's tip."""
        return ""

    def executed(self, action: ActionT) -> None:
        """Hear what was really executed, before the next `act` (for anti-windup)."""


class Student(EnginePart, Generic[StateT, ActionT, ProposalT]):
    """The learner: any function approximator (Thesis 3.2.2.2)."""

    role: ClassVar[str] = "student"
    learns: ClassVar[bool] = True
    """False in a control that is taught nothing: that it asks for nothing is then meant."""

    @property
    @abc.abstractmethod
    def proposal(self) -> type[Any]:
        """The proposal type that `propose` returns."""

    @abc.abstractmethod
    def propose(self, moment: Moment[StateT, ActionT]) -> ProposalT:
        """Return what the student would do at this moment."""

    @abc.abstractmethod
    def teach(self, lesson: Lesson[StateT, ActionT]) -> None:
        """Learn one lesson."""


class ActionSelector(EnginePart, Generic[ActionT, ProposalT]):
    """Chooses between tutor and student; what it selects has the tutor's kind (Thesis 3.2.2.3)."""

    role: ClassVar[str] = "selector"
    proposal: ClassVar[type[Proposal]]
    """The proposal type that it can read."""

    @abc.abstractmethod
    def select(self, tutor_action: ActionT, proposal: ProposalT) -> GradedAction[ActionT]:
        """Return the tutor's action with the level and ampbit that apply."""


class Amplifier(EnginePart, Generic[ActionT]):
    """Decides whether an action is amplified further, and how far a level moves a component (Thesis 3.2.2.4)."""

    role: ClassVar[str] = "amplifier"

    @abc.abstractmethod
    def amplify(self, selected: GradedAction[ActionT], decision_number: int) -> GradedAction[ActionT]:
        """Return the selected action with the level that results."""

    @property
    @abc.abstractmethod
    def amount(self) -> float:
        """Amplification per level (0.1 in the thesis)."""

    @property
    @abc.abstractmethod
    def change(self) -> Change:
        """How an amplification becomes a distance."""


class Evaluator(EnginePart, Generic[StateT, ActionT]):
    """Decides what the student is taught about a decision (Thesis 3.2.2.5)."""

    role: ClassVar[str] = "evaluator"

    @abc.abstractmethod
    def evaluate(self, decision: Decision[StateT, ActionT], outcome: Outcome[StateT]) -> Lesson[StateT, ActionT] | None:
        """Return the lesson, or None to teach nothing."""
