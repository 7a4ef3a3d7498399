"""How tutors, students, selectors, amplifiers and evaluators are used."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import cycle, product
from typing import Any

from tutorstudent.checks.outcome import CheckSkipped, expect
from tutorstudent.checks.roles.sound import expect_action, expect_graded, expect_number, expect_proposal
from tutorstudent.checks.usage import Question, Usage
from tutorstudent.core.roles.leaves import Change
from tutorstudent.core.words.proposals import KindProposal, LevelProposal
from tutorstudent.core.words.records import Decision, GradedAction, Lesson, Moment, Outcome

LEVELS = (0, 1, 3)
BITS = (True, False)


def make_moments(actions: Sequence[Any], states: Sequence[Any]) -> list[Moment[Any, Any]]:
    """Return one moment for each state, the actions taking turns."""
    return [
        Moment(number, state, action, "")
        for number, (state, action) in enumerate(zip(states, cycle(actions), strict=False))
    ]


def make_decision(moment: Moment[Any, Any], amplified: bool) -> Decision[Any, Any]:
    """Return a decision whose level was raised, or not."""
    action = moment.tutor_action
    selected = GradedAction(action, 1, amplified)
    return Decision(moment, selected, selected._replace(level=1 + amplified), action, None)


def make_outcome(state: Any, violated: bool) -> Outcome[Any]:
    """Return an outcome in which one condition is violated, or none."""
    margins = {"stand-in": (0.0 if violated else 1.0,)}
    return Outcome(state, ("stand-in",) if violated else (), None, margins)


class TutorUsage(Usage):
    """Asked for one action in each state, and told that it was executed."""

    reads_states = True

    def make_questions(self, states: Sequence[Any]) -> list[Question]:
        return [(state,) for state in states]

    def ask(self, part: Any, question: Question) -> Any:
        action = part.act(question[0])
        situation = part.situation
        part.executed(action)
        return action, situation

    def judge(self, part: Any, question: Question, answer: Any) -> None:
        action, situation = answer
        expect_action(action, part.action, "act()")
        expect(isinstance(situation, str), "situation is a string", f"{situation!r}", "return a word, or ''")


class StudentUsage(Usage):
    """Asked for one proposal at each moment, and taught one lesson about it."""

    reads_states = True

    def make_questions(self, states: Sequence[Any]) -> list[Question]:
        return [(moment, self._make_lesson(moment)) for moment in make_moments(self.subject.actions, states)]

    def ask(self, part: Any, question: Question) -> Any:
        proposal = part.propose(question[0])
        part.teach(question[1])
        return proposal

    def recall(self, part: Any, question: Question) -> Any:
        return part.propose(question[0])

    def judge(self, part: Any, question: Question, answer: Any) -> None:
        expect_proposal(answer, part.proposal, self.subject.action, "propose()")

    def _make_lesson(self, moment: Moment[Any, Any]) -> Lesson[Any, Any]:
        violated = moment.number % 3 == 2
        target = GradedAction(moment.tutor_action, 1 + moment.number % 3, not violated)
        return Lesson(moment, target, target.level, moment.tutor_action, make_outcome(moment.state, violated))


class SelectorUsage(Usage):
    """Given every action with every proposal that it can read."""

    def make_questions(self, states: Sequence[Any]) -> list[Question]:
        proposals = self._make_proposals()
        return [(action, proposal) for action in self.subject.actions for proposal in proposals]

    def ask(self, part: Any, question: Question) -> Any:
        return part.select(*question)

    def judge(self, part: Any, question: Question, answer: Any) -> None:
        expect_graded(answer, question[0], "select()")

    def _make_proposals(self) -> list[Any]:
        declared: Any = getattr(self.subject.cls, "proposal", None)
        grades = list(product(LEVELS, BITS))
        if declared is LevelProposal:
            return [LevelProposal(level=level, ampbit=bit) for level, bit in grades]
        if declared is KindProposal:
            kinds = (None, *self.subject.action.vocabulary.kinds)
            return [KindProposal(kind=kind, level=level, ampbit=bit) for kind in kinds for level, bit in grades]
        raise CheckSkipped(f"its 'proposal' is {declared!r}; the checks know KindProposal and LevelProposal")


class AmplifierUsage(Usage):
    """Given every action at several levels, with either ampbit, early and late."""

    def make_questions(self, states: Sequence[Any]) -> list[Question]:
        cases = product(self.subject.actions, LEVELS, BITS, (0, 1_000_000))
        return [(GradedAction(action, level, bit), number) for action, level, bit, number in cases]

    def ask(self, part: Any, question: Question) -> Any:
        return part.amplify(*question)

    def judge(self, part: Any, question: Question, answer: Any) -> None:
        expect_graded(answer, question[0].action, "amplify()")
        expect_number(part.amount, "amount")
        change = part.change
        expect(isinstance(change, Change), "change is a Change", f"{change!r}", "return one, for example an option's")


class EvaluatorUsage(Usage):
    """Given decisions that were amplified or not, with outcomes that are violated or not."""

    def make_questions(self, states: Sequence[Any]) -> list[Question]:
        cases = product((True, False), repeat=2)
        found = make_moments(self.subject.actions, [0.0] * len(self.subject.actions))
        return [
            (make_decision(moment, amplified), make_outcome(moment.state, violated))
            for amplified, violated in cases
            for moment in found
        ]

    def ask(self, part: Any, question: Question) -> Any:
        return part.evaluate(*question)

    def judge(self, part: Any, question: Question, answer: Any) -> None:
        if answer is None:
            return
        moment = question[0].moment
        expect(
            type(answer) is Lesson and answer.moment is moment,
            "evaluate() returns a Lesson about the moment of the decision, or None",
            f"{answer!r}",
            "return Lesson(decision.moment, ...)",
        )
        expect_graded(answer.target, moment.tutor_action, "the target of evaluate()")
