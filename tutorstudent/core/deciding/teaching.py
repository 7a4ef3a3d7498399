"""From an outcome to a lesson, and from the lesson to the student (Thesis 3.2.3 C)."""

from __future__ import annotations

from typing import Any, Generic

from tutorstudent.core.deciding.checking import check_graded, check_records
from tutorstudent.core.deciding.guard import Breach, Guard
from tutorstudent.core.roles.interfaces import Evaluator, Student
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.records import Decision, Lesson, Outcome, StateT
from tutorstudent.core.words.turn import Turn


class Teacher(Generic[StateT, ActionT]):
    """Asks the evaluator for a lesson and teaches it; where either fails, nothing is taught."""

    def __init__(
        self, evaluator: Evaluator[StateT, ActionT], student: Student[StateT, ActionT, Any], guard: Guard
    ) -> None:
        self._evaluator, self._student, self._guard = evaluator, student, guard

    def teach(self, turn: Turn[StateT, ActionT], outcome: Outcome[StateT]) -> None:
        """Write the lesson that was taught, if any."""
        part = "evaluator"
        try:
            lesson = self._ask(turn, outcome)
            if lesson is None:
                return
            part = "student"
            self._student.teach(lesson)
            self._guard.check_recursion()
            check_records(turn)
            turn._lesson = lesson
        except BaseException as error:
            self._guard.record(part, error)

    def _ask(self, turn: Turn[StateT, ActionT], outcome: Outcome[StateT]) -> Lesson[StateT, ActionT] | None:
        decision = turn._decision
        lesson = self._evaluator.evaluate(decision, outcome)
        self._guard.check_recursion()
        check_records(turn)
        if lesson is None:
            return None
        if type(lesson) is not Lesson:
            raise Breach("wrong-return", f"evaluate() returned {type(lesson).__name__}; return a Lesson or None.")
        target = check_graded(lesson.target, decision.moment.tutor_action)
        if target is not lesson.target:
            lesson = lesson._replace(target=target)
        _check_evidence(lesson, decision, outcome)
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
