"""The algorithm (Thesis 3.2.3 and 5.2.1) and the behaviour contract round it.

The engine does no I/O, reads no clock and calls no plugin manager; it works in anybody's own loop::

    while True:
        robot.execute(engine.step(robot.sense()))
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Iterator, Sequence
from typing import Generic

from tutorstudent.core.deciding.checking import copy_checked
from tutorstudent.core.deciding.correcting import Corrector
from tutorstudent.core.deciding.cycle import Cycle
from tutorstudent.core.deciding.grading import Grader
from tutorstudent.core.deciding.guard import Guard, OnIncident
from tutorstudent.core.deciding.judging import Judge
from tutorstudent.core.deciding.limiting import Limiter
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.deciding.teaching import Teacher
from tutorstudent.core.deciding.turnstile import Turnstile
from tutorstudent.core.deciding.tutoring import TutorSeat
from tutorstudent.core.deciding.wiring import (
    check_conditions,
    check_failure_action,
    check_held,
    check_vocabulary,
    check_wiring,
)
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.roles.interfaces import SLOTS, ActionSelector, Amplifier, Evaluator, Student, Tutor
from tutorstudent.core.roles.leaves import Condition
from tutorstudent.core.roles.part import Component, EnginePart, Learned, find_listeners
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.proposals import ProposalT, require_level
from tutorstudent.core.words.records import Decision, Incident, StateT
from tutorstudent.core.words.turn import Turn


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
        check_held(tutor.action)
        check_failure_action(tutor, on_tutor_failure)
        self._guard = Guard(on_incident)
        check_conditions(self.conditions)
        self._labels = [f"conditions.{condition.label}" for condition in self.conditions]
        for slot, part in self.slots():
            part.bind(Binding(seed, slot, tutor.action))
        check_wiring(student, selector)
        limiter = Limiter(self.limits, amplifier, tutor.action)
        self._cycle = Cycle(
            TutorSeat(tutor, self._guard, on_tutor_failure, limiter),
            Grader(student, selector, amplifier, limiter, self._guard),
            limiter,
            Judge(self.conditions, self._guard),
            Teacher(evaluator, student, self._guard),
            [(part, self._guard.blame(slot)) for slot, part in find_listeners(self.slots())],
            self._guard,
        )
        self._corrector: Corrector[StateT, ActionT] = Corrector(limiter, self._guard)
        self._turnstile = Turnstile(self._guard)

    @property
    def decisions(self) -> int:
        """How many decisions were made, over all trials."""
        return self._cycle.decisions

    @property
    def last(self) -> Turn[StateT, ActionT] | None:
        """The newest decision whose outcome is known."""
        return self._cycle.last

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
        return self._cycle.turn.decision if self._cycle.turn else None

    def slots(self) -> Iterator[tuple[str, Component]]:
        """Yield every part with its slot."""
        yield from ((slot, getattr(self, slot)) for slot in SLOTS)
        yield from zip(self._labels, self.conditions, strict=True)

    def step(self, state: StateT, shown: StateT | None = None) -> ActionT:
        """Judge the previous decision by this state, then decide. Call once per decision.

        Args:
            state: What the tutor is asked with: always the very object.
            shown: What the other parts are shown instead, where they must not share the state with its owner.
        """
        seen = state if shown is None else shown
        with self._turnstile:
            self._cycle.evaluate(seen)
            return self._cycle.propagate(state, seen)

    def propagate(self, state: StateT) -> ActionT:
        """Return the action to execute (Thesis 3.2.3, propagation) and remember the decision (a-e).

        A decision that was never judged is dropped.
        """
        with self._turnstile:
            return self._cycle.propagate(state, state)

    def evaluate(self, resulting_state: StateT) -> Turn[StateT, ActionT] | None:
        """Judge the pending decision by the state it led to, and teach (Thesis 3.2.3 A-C).

        Returns:
            The whole turn, or None if no decision is pending.
        """
        with self._turnstile:
            return self._cycle.evaluate(resulting_state)

    def executed(self, action: ActionT) -> None:
        """Say what was really executed instead of the action that the engine returned.

        The lesson is then about the level that was really reached. Where that cannot be told (another kind, less than
        the tutor's own action, or other components changed) the decision teaches nothing.

        Raises:
            ContractError: if no decision is pending or the action is not of the tutor's class.
        """
        with self._turnstile:
            turn = self._get_pending("executed()")
            if type(action) is not self.tutor.action:
                raise ContractError(
                    f"executed(): found {type(action).__name__}; expected the tutor's {self.tutor.action.__name__}."
                )
            self._corrector.correct(turn, copy_checked(action, "executed()"))

    def refused(self, error: BaseException) -> None:
        """Say that the action could not be executed, and why: the tutor's own was executed instead, even past slew.

        Raises:
            ContractError: if no decision is pending, or where incidents are to be raised.
        """
        with self._turnstile:
            turn = self._get_pending("refused()")
            self._corrector.take_back(turn)
            self._guard.record("action", error)

    def void(self, reason: str) -> None:
        """Say that the pending decision must teach nothing (an emergency stop, teleoperation)."""
        if self._cycle.turn is not None:
            self._cycle.turn._void = reason or "no reason given"

    def drop(self) -> None:
        """Forget the pending decision without judging it (a trial that was cut off)."""
        with self._turnstile:
            self._cycle.drop()

    def reset(self) -> None:
        """Begin a trial. Decision count, learning phase and what was learned stay."""
        with self._turnstile:
            self._cycle.begin_trial()
            others = [(slot, part) for slot, part in self.slots() if slot != "tutor"]
            self._guard.call_all((slot, part.reset) for slot, part in others if isinstance(part, EnginePart))

    def close(self) -> None:
        """Let every part go, whatever some of them raise."""
        self._guard.begin_call()
        self._guard.attend(self.decisions)
        self._guard.call_all((slot, part.close) for slot, part in self.slots())

    def state_dict(self) -> Learned:
        """Return what was learned by all parts, and the decision count."""
        learned = {slot: state for slot, part in self.slots() if (state := part.state_dict())}
        return {"decisions": self.decisions} | learned

    def load_state_dict(self, state: Learned) -> None:
        """Take back what `state_dict` returned."""
        parts = dict(self.slots())
        if unknown := [slot for slot in state if slot not in parts and slot != "decisions"]:
            raise ContractError(f"learned state names the part '{unknown[0]}'; this pipeline has {', '.join(parts)}.")
        decisions = require_level(state.get("decisions", self.decisions))
        if decisions < 0:
            raise ContractError(f"learned state says {decisions} decisions; expected 0 or more.")
        for slot, part in parts.items():
            if slot in state:
                part.load_state_dict(state[slot])
        self._cycle.decisions = decisions

    def _get_pending(self, what: str) -> Turn[StateT, ActionT]:
        if self._cycle.turn is None:
            raise ContractError(f"{what}: no decision is pending; call it after step() and before the next step().")
        return self._cycle.turn
