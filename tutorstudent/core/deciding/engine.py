"""The algorithm (Thesis 3.2.3 and 5.2.1) and the behaviour contract round it.

The engine does no I/O, reads no clock and calls no plugin manager; it works in anybody's own loop::

    while True:
        robot.execute(engine.step(robot.sense()))
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Iterator, Sequence
from typing import Generic

from tutorstudent.core.deciding.corrections import UNKNOWN, corrected
from tutorstudent.core.deciding.grading import Graded, Grader
from tutorstudent.core.deciding.guard import Guard, OnIncident, checked_replica, sealed
from tutorstudent.core.deciding.judging import Judge
from tutorstudent.core.deciding.limiting import LevelLimiter
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.deciding.teaching import Pending, Teacher
from tutorstudent.core.deciding.tutoring import TutorSeat
from tutorstudent.core.deciding.wiring import check_failure_action, check_vocabulary, check_wiring
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.roles.interfaces import ActionSelector, Amplifier, Evaluator, Student, Tutor
from tutorstudent.core.roles.leaves import Condition
from tutorstudent.core.roles.part import Component, EnginePart, Learned
from tutorstudent.core.words.actions import ActionT, Group, rebuild
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.proposals import ProposalT, require_level
from tutorstudent.core.words.records import Decision, Incident, Moment, StateT, Turn


class Engine(Generic[StateT, ActionT, ProposalT]):
    """Tutor, student, selector, amplifier and evaluator, turned once per decision.

    Args:
        tutor: The controller that stays in command.
        student: The learner.
        selector: Reads the student's proposals; its proposal type must be the student's.
        amplifier: Raises levels and says how far a level moves a component.
        evaluator: Decides what is taught.
        conditions: Operational conditions; true means violated.
        limits: How far amplification may go.
        seed: The one seed; every part draws from a stream of its own, keyed by its slot.
        on_incident: ``continue`` records what goes wrong in a part and goes on with the tutor; ``raise`` raises it.
        on_tutor_failure: The action to execute when the tutor itself fails, or None to let its exception through.

    Raises:
        ContractError: if the parts do not fit together.
    """

    def __init__(
        self,
        *,
        tutor: Tutor[StateT, ActionT],
        student: Student[StateT, ActionT, ProposalT],
        selector: ActionSelector[ActionT, ProposalT],
        amplifier: Amplifier[ActionT],
        evaluator: Evaluator[StateT, ActionT],
        conditions: Sequence[Condition[StateT]] = (),
        limits: Limits | None = None,
        seed: int = 0,
        on_incident: OnIncident = "continue",
        on_tutor_failure: ActionT | None = None,
    ) -> None:
        self.tutor, self.student, self.selector = tutor, student, selector
        self.amplifier, self.evaluator, self.conditions = amplifier, evaluator, tuple(conditions)
        self.limits, self.on_tutor_failure = limits or Limits(), on_tutor_failure
        check_vocabulary(tutor)
        check_failure_action(tutor, on_tutor_failure)
        self._guard = Guard(on_incident)
        self._judge = Judge(self.conditions, self._guard)
        for slot, part in self.slots():
            part.bind(Binding(seed, slot, tutor.action))
        check_wiring(student, selector)
        self._seat = TutorSeat(tutor, self._guard, on_tutor_failure)
        self._levels = LevelLimiter(self.limits, amplifier)
        self._grader = Grader(student, selector, amplifier, self._levels, self._guard)
        self._teacher = Teacher(evaluator, student, self._guard)
        self.decisions = 0
        self.last: Turn[StateT, ActionT] | None = None
        """The newest decision whose outcome is known."""
        self._pending: Pending | None = None
        self._void = self._untold = ""

    @property
    def incidents(self) -> deque[Incident]:
        """The newest incidents, oldest first."""
        return self._guard.log

    @property
    def incident_counts(self) -> Counter[tuple[str, str]]:
        """All incidents so far, by (part, kind)."""
        return self._guard.counts

    @property
    def pending(self) -> Decision[StateT, ActionT] | None:
        """The decision that waits for its outcome."""
        return self._pending.decision if self._pending else None

    def slots(self) -> Iterator[tuple[str, Component]]:
        """Yield every part with its slot."""
        for slot in ("tutor", "student", "selector", "amplifier", "evaluator"):
            yield slot, getattr(self, slot)
        yield from ((f"conditions.{condition.label}", condition) for condition in self.conditions)

    def step(self, state: StateT) -> ActionT:
        """Judge the previous decision by this state, then decide. Call once per decision."""
        self.evaluate(state)
        return self.propagate(state)

    def propagate(self, state: StateT) -> ActionT:
        """Return the action to execute (Thesis 3.2.3 1-11) and remember the decision (a-e).

        A decision that was never judged is dropped.
        """
        if self._pending is not None:
            self.drop()
        self._guard.turn = []
        original, shown, situation, failed = self._seat.ask(self.decisions, state)
        groups = self.tutor.action.vocabulary.groups[original.kind]
        moment = Moment(self.decisions, state, shown, situation)
        if failed:
            self._void = "the tutor failed"
            self._levels.forget()
            graded = self._grader.fall_back(original, groups)
        else:
            graded = self._grader.grade(moment, original, groups)
        action, graded = self._grader.render(self.decisions, graded, original, groups)
        self._remember(moment, graded, original, action, groups)
        self.decisions += 1
        return action

    def evaluate(self, resulting_state: StateT) -> Turn[StateT, ActionT] | None:
        """Judge the pending decision by the state it led to, and teach (Thesis 3.2.3 A-C).

        Returns:
            The whole turn, or None if no decision is pending.
        """
        if self._pending is None:
            return None
        pending, self._pending = self._pending, None
        number = pending.decision.moment.number
        if self._seat.hears:
            self._seat.tell(number, pending.decision.executed)
        outcome = self._judge.judge(number, resulting_state)
        incidents = len(self._guard.turn)
        void = self._void or self._untold
        lesson = None if void else self._teacher.teach(pending, outcome)
        decision = pending.decision if len(self._guard.turn) == incidents else pending.renewed()
        self.last = Turn(decision, outcome, lesson, tuple(self._guard.turn), void)
        self._void = self._untold = ""
        return self.last

    def executed(self, action: ActionT) -> None:
        """Say what was really executed instead of the action that the engine returned.

        The lesson is then about the level that was really reached. Where that cannot be told (another kind, less than
        the tutor's own action, or other components changed) the decision teaches nothing.

        Raises:
            ContractError: if no decision is pending or the action is not of the tutor's class.
        """
        if self._pending is None:
            raise ContractError("executed(): no decision is pending; call it after step() and before the next step().")
        if type(action) is not self.tutor.action:
            raise ContractError(
                f"executed(): found {type(action).__name__}; expected the tutor's {self.tutor.action.__name__}."
            )
        self._correct(self._pending, checked_replica(action, "executed()"))

    def refused(self, error: BaseException) -> None:
        """Say that the action could not be executed, and why: the tutor's own was executed instead.

        Raises:
            ContractError: if no decision is pending, or where incidents are to be raised.
        """
        if self._pending is None:
            raise ContractError("refused(): no decision is pending; call it after step() and before the next step().")
        self._correct(self._pending, self._pending.original)
        self._guard.record(self._pending.decision.moment.number, "action", error)

    def void(self, reason: str) -> None:
        """Say that the pending decision must teach nothing (an emergency stop, teleoperation)."""
        if self._pending is not None:
            self._void = reason or "no reason given"

    def drop(self) -> None:
        """Forget the pending decision without judging it (a trial that was cut off)."""
        if self._pending is not None:
            pending, self._pending = self._pending, None
            self._judge.forget()
            if self._seat.hears:
                self._seat.tell(pending.decision.moment.number, pending.decision.executed)
            self.last = Turn(pending.decision, None, None, tuple(self._guard.turn), self._void or "dropped")
        self._void = self._untold = ""

    def reset(self) -> None:
        """Begin a trial. Decision count, learning phase and what was learned stay."""
        self.drop()
        self._judge.forget()
        self._levels.forget()
        self._seat.reset(self.decisions)
        for slot, part in self.slots():
            if slot != "tutor" and isinstance(part, EnginePart):
                self._guard.call(self.decisions, slot, part.reset)

    def close(self) -> None:
        """Let every part go."""
        for slot, part in self.slots():
            self._guard.call(self.decisions, slot, part.close)

    def state_dict(self) -> Learned:
        """Return what was learned by all parts, and the decision count."""
        learned = {slot: state for slot, part in self.slots() if (state := part.state_dict())}
        return {"decisions": self.decisions} | learned

    def load_state_dict(self, state: Learned) -> None:
        """Take back what `state_dict` returned."""
        parts = dict(self.slots())
        for slot, value in state.items():
            if slot == "decisions":
                self.decisions = require_level(value)
            elif slot in parts:
                parts[slot].load_state_dict(value)
            else:
                raise ContractError(f"learned state names the part '{slot}'; this pipeline has {', '.join(parts)}.")

    def _correct(self, pending: Pending, executed: ActionT) -> None:
        self._untold = UNKNOWN  # should telling it raise
        self._pending, permitted, self._untold = corrected(pending, executed, self._levels, self._guard)
        self._levels.remember(pending.original.kind, permitted)

    def _remember(
        self,
        moment: Moment[StateT, ActionT],
        graded: Graded[ActionT],
        original: ActionT,
        action: ActionT,
        groups: tuple[Group, ...],
    ) -> None:
        shown = graded.resulting.action
        if shown is not moment.tutor_action:
            moment = moment._replace(tutor_action=shown)
        record = shown if action is original else rebuild(action)
        decision = Decision(moment, graded.selected, graded.resulting, record, graded.proposal)
        seal = sealed(shown)
        seals = (seal, seal if record is shown else sealed(record))
        self._pending = Pending(decision, original, action, groups, seals, decision)
        self._levels.remember(original.kind, graded.permitted)
