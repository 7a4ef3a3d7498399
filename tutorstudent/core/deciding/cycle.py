"""The phases of the algorithm (Thesis 3.2.3): propagation, pre-evaluation, evaluation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Generic

from tutorstudent.core.deciding.checking import check_records, renew_records, seal
from tutorstudent.core.deciding.grading import Grader
from tutorstudent.core.deciding.guard import Blame, Guard
from tutorstudent.core.deciding.judging import Judge
from tutorstudent.core.deciding.limiting import Limiter
from tutorstudent.core.deciding.teaching import Teacher
from tutorstudent.core.deciding.tutoring import TutorSeat
from tutorstudent.core.roles.part import EnginePart
from tutorstudent.core.words.actions import ActionT, rebuild
from tutorstudent.core.words.proposals import ProposalT
from tutorstudent.core.words.records import Decision, StateT
from tutorstudent.core.words.turn import Turn


class Cycle(Generic[StateT, ActionT, ProposalT]):
    """Takes one turn after the other; at most one waits for its outcome."""

    def __init__(
        self,
        seat: TutorSeat[StateT, ActionT],
        grader: Grader[StateT, ActionT, ProposalT],
        limiter: Limiter,
        judge: Judge[StateT],
        teacher: Teacher[StateT, ActionT],
        listeners: Sequence[tuple[EnginePart, Blame]],
        guard: Guard,
    ) -> None:
        self._seat, self._grader, self._limiter = seat, grader, limiter
        self._judge, self._teacher, self._listeners, self._guard = judge, teacher, listeners, guard
        self.decisions = 0
        self.turn: Turn[StateT, ActionT] | None = None
        """The one that waits for its outcome."""
        self.last: Turn[StateT, ActionT] | None = None
        """The newest one that is over."""

    def propagate(self, state: StateT, shown: StateT) -> ActionT:
        """Return the action to execute, and remember the decision (a-e). An earlier one that was not judged is dropped.

        Args:
            state: What the tutor is asked with.
            shown: What the parts are shown of it.
        """
        if self.turn is not None:
            self.drop()
        executed_last = self._limiter.last
        try:
            turn: Turn[StateT, ActionT] = Turn.begin(self._guard.attend(self.decisions))
            self._seat.ask(turn, self.decisions, state, shown, self._judge.margins)  # the tutor says its action
            if turn._void:
                self._limiter.forget()
                self._grader.fall_back(turn)
            else:
                self._grader.grade(turn)  # student, selector and amplifier: proposal, selected and resulting action
            self._grader.render(turn)  # the resulting action as the robot gets it
            self._remember(turn)  # a-e
        except BaseException:  # a stop from outside: nothing of this decision was executed
            self.turn, self._limiter.last = None, executed_last
            raise
        self.decisions += 1
        return turn._action

    def evaluate(self, resulting_state: StateT) -> Turn[StateT, ActionT] | None:
        """Judge the turn that waits by the state it led to (A-C), and teach; None if none waits."""
        turn, self.turn = self.turn, None
        if turn is None:
            return None
        if self._seat.hears:
            self._seat.tell(turn)
        outcome = self._judge.judge(resulting_state)  # A, B, and the conditions of C
        turn._outcome, before = outcome, len(turn._incidents)
        if not (turn._void or turn._untold):
            self._teacher.teach(turn, outcome)  # C(a), C(b)
        self._end(turn, before)
        return turn

    def drop(self) -> None:
        """Forget the turn that waits, without judging it."""
        turn, self.turn = self.turn, None
        if turn is None:
            return
        self._judge.forget()
        if self._seat.hears:
            self._seat.tell(turn)
        turn._void = turn._void or "dropped"
        self._end(turn, len(turn._incidents))

    def begin_trial(self) -> None:
        """Forget what belongs to a trial: the turn that waits, the margins before it, the level of slew."""
        self.drop()
        self._guard.attend(self.decisions)
        self._judge.forget()
        self._limiter.forget()
        self._seat.reset()

    def _remember(self, turn: Turn[StateT, ActionT]) -> None:
        shown = turn._moment.tutor_action
        record = shown
        if turn._action is not turn._original:
            record = rebuild(turn._action)
            turn._seals = turn._seals[0], seal(record)
        turn._decided_by = turn._limited_by
        turn._decision = turn._asked = Decision(turn._moment, turn._selected, turn._resulting, record, turn._proposal)
        self._limiter.remember(turn._original.kind, turn._resulting.level, turn._rung)
        self.turn = turn

    def _end(self, turn: Turn[StateT, ActionT], incidents: int) -> None:
        """Show the turn to the parts that listen; what a part spoilt in its records is mended."""
        if len(turn._incidents) > incidents:
            renew_records(turn)
        for part, blame in self._listeners:
            with blame:
                part.judged(turn)
                self._guard.check_recursion()
                check_records(turn)
            if blame.failed:
                renew_records(turn)
        self.last = turn
