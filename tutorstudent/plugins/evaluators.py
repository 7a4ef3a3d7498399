"""Evaluators (Thesis 3.2.2.5, 3.2.3 C, 3.3.5)."""

from __future__ import annotations

from tutorstudent.core.actions import ActionT
from tutorstudent.core.component import Component
from tutorstudent.core.hookspecs import hookimpl
from tutorstudent.core.interfaces import Evaluator
from tutorstudent.core.records import Decision, GradedAction, Lesson, Outcome, StateT


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


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the shipped evaluators."""
    return [Conditions]
