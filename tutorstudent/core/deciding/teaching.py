"""From an outcome to a lesson, and from the lesson to the student (Thesis 3.2.3 C)."""

from __future__ import annotations

from typing import Any, Generic, NamedTuple

from tutorstudent.core.deciding.guard import Breach, Guard, Seal, check_intact, received
from tutorstudent.core.roles.interfaces import Evaluator, Student
from tutorstudent.core.words.actions import ActionT, Group, rebuild
from tutorstudent.core.words.records import Decision, Lesson, Outcome, StateT


class Pending(NamedTuple):
    """The decision that waits for its outcome, with the actions that nobody else sees."""

    decision: Decision[Any, Any]
    original: Any
    executed: Any
    groups: tuple[Group, ...]
    seals: tuple[Seal, Seal]
    """Of the tutor's action and the executed action in the record."""
    asked: Decision[Any, Any]
    """The decision as it was made, before anybody said that something else was executed."""

    def check_intact(self) -> None:
        """Raise a `Breach` if a part spoilt what it was shown."""
        tutor_action, executed = self.decision.moment.tutor_action, self.decision.executed
        check_intact(tutor_action, self.seals[0])
        if executed is not tutor_action:
            check_intact(executed, self.seals[1])

    def renewed(self) -> Decision[Any, Any]:
        """Return the decision with fresh copies, for the record, after a part spoilt the old ones."""
        decision, shown = self.decision, rebuild(self.original)
        return decision._replace(
            moment=decision.moment._replace(tutor_action=shown),
            selected=decision.selected._replace(action=shown),
            resulting=decision.resulting._replace(action=shown),
            executed=rebuild(self.executed),
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
            target = received(lesson.target, shown)
            if target is not lesson.target:
                lesson = lesson._replace(target=target)
            _check_evidence(lesson, decision, outcome)
            part = "student"
            self._student.teach(lesson)
            pending.check_intact()
        except KeyboardInterrupt:
            raise
        except BaseException as error:
            self._guard.record(decision.moment.number, part, error)
            return None
        return lesson


def _check_evidence(lesson: Lesson[Any, Any], decision: Decision[Any, Any], outcome: Outcome[Any]) -> None:
    """Raise a `Breach` unless the lesson is about this decision; an evaluator may hide evidence, not make it up."""
    same = lesson.moment is decision.moment and lesson.executed is decision.executed
    if not same or lesson.executed_level != decision.resulting.level or type(lesson.executed_level) is not int:
        raise Breach("wrong-return", "the lesson is about another decision than the one that is judged.")
    told = lesson.outcome
    if told is outcome:
        return
    if type(told) is not Outcome or told.state is not outcome.state or not set(told.violated) <= set(outcome.violated):
        raise Breach("wrong-return", "the lesson's outcome is not the one that was judged.")
    if any(margins and margins not in (outcome.margins, outcome.margins_before) for margins in told[2:]):
        raise Breach("wrong-return", "the lesson's margins are not the ones that were measured.")
