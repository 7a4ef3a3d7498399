"""Evaluators (Thesis 3.2.2.5, 3.2.3 C, 3.3.5)."""

from __future__ import annotations

from typing import Any

from pydantic import model_validator

from tutorstudent.core.roles import part
from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.interfaces import Evaluator
from tutorstudent.core.roles.part import Component, Field
from tutorstudent.core.roles.part_options import Part
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.records import Decision, GradedAction, Lesson, Outcome, StateT


class Conditions(Evaluator[StateT, ActionT]):
    """Teach by whether the action was amplified and whether an operational condition is violated (Thesis 3.2.3 C).

    | amplified | violated | taught |
    |---|---|---|
    | yes | yes | the selected action (C(a)i) |
    | yes | no | the resulting action (C(a)ii) |
    | no | yes | the tutor's action, level 0 (C(b)i) |
    | no | no | the resulting action, which is the selected one (C(b)ii) |

    The ampbit taught is 1 for success and 0 for failure (Thesis 3.3.5).
    """

    name = "conditions"

    def evaluate(self, decision: Decision[StateT, ActionT], outcome: Outcome[StateT]) -> Lesson[StateT, ActionT] | None:
        violated = bool(outcome.violated)
        if not violated:
            level = decision.resulting.level
        elif decision.amplified:
            level = decision.selected.level
        else:
            level = 0
        target = GradedAction(decision.moment.tutor_action, level, not violated)
        return Lesson(decision.moment, target, decision.resulting.level, decision.executed, outcome)


class IntervalOptions(part.Options):
    """Which decisions are taught about, and how."""

    begin: int = Field(default=0, ge=0, description="first decision that is taught about, counted from 0")
    end: int | None = Field(default=None, ge=1, description="first decision that no longer is; none: no end")
    evaluator: Part[Evaluator[Any, Any]] = Field(default_factory=Conditions, description="says what is taught")

    @model_validator(mode="after")
    def _refuse_empty(self) -> IntervalOptions:
        if self.end is not None and self.end <= self.begin:
            raise ValueError(f"end ({self.end}) must be more than begin ({self.begin}), or nothing is ever taught")
        return self


class Interval(Evaluator[StateT, ActionT]):
    """Teach as another evaluator does, but only about the decisions in [begin, end) (Thesis 5.2.5).

    Violations are counted throughout; outside the interval the other evaluator is not asked.
    """

    name = "interval"
    Options = IntervalOptions

    def evaluate(self, decision: Decision[StateT, ActionT], outcome: Outcome[StateT]) -> Lesson[StateT, ActionT] | None:
        begin, end = self.options.begin, self.options.end
        if decision.moment.number < begin or (end is not None and decision.moment.number >= end):
            return None
        lesson: Lesson[StateT, ActionT] | None = self.options.evaluator.evaluate(decision, outcome)
        return lesson


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the shipped evaluators."""
    return [Conditions, Interval]
