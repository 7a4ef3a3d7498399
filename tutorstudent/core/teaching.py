"""From an outcome to a lesson, and from the lesson to the student (Thesis 3.2.3 C)."""

from __future__ import annotations

from typing import Any, Generic, NamedTuple

from tutorstudent.core.actions import ActionT, Group
from tutorstudent.core.guard import Breach, Guard, check_intact, received, replica
from tutorstudent.core.interfaces import Evaluator, Student
from tutorstudent.core.records import Decision, Lesson, Outcome, StateT


class Pending(NamedTuple):
    """The decision that waits for its outcome, with the actions that nobody else sees."""

    decision: Decision[Any, Any]
    original: Any
    executed: Any
    groups: tuple[Group, ...]

    def check_intact(self) -> None:
        """Raise a `Breach` if a part spoilt what it was shown."""
        check_intact(self.decision.moment.tutor_action, self.original)
        if self.decision.executed is not self.decision.moment.tutor_action:
            check_intact(self.decision.executed, self.executed)

    def renewed(self) -> Decision[Any, Any]:
        """Return the decision with fresh copies, for the record, after a part spoilt the old ones."""
        decision, shown = self.decision, replica(self.original)
        return decision._replace(
            moment=decision.moment._replace(tutor_action=shown),
            selected=decision.selected._replace(action=shown),
            resulting=decision.resulting._replace(action=shown),
            executed=replica(self.executed),
        )


class Teacher(Generic[StateT, ActionT]):
    """Asks the evaluator for a lesson and teaches it; where either fails, nothing is taught."""

    def __init__(
        self, evaluator: Evaluator[StateT, ActionT], student: Student[StateT, ActionT, Any], guard: Guard
    ) -> None:
        self._evaluator, self._student, self._guard = evaluator, student, guard

    def teach(self, pending: Pending, outcome: Outcome[StateT]) -> Lesson[StateT, ActionT] | None:
        """Return the lesson that was taught, or None."""
        decision, part = pending.decision, "evaluator"
        shown = decision.moment.tutor_action
        try:
            lesson = self._evaluator.evaluate(decision, outcome)
            pending.check_intact()
            if lesson is None:
                return None
            if type(lesson) is not Lesson:
                raise Breach("wrong-return", f"evaluate() returned {type(lesson).__name__}; return a Lesson or None.")
            target = received(lesson.target, shown, pending.original)
            if target is not lesson.target:
                lesson = lesson._replace(target=target)
            part = "student"
            self._student.teach(lesson)
            pending.check_intact()
        except KeyboardInterrupt:
            raise
        except BaseException as error:
            self._guard.record(decision.moment.number, part, error)
            return None
        return lesson
