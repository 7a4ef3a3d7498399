"""From the tutor's action to the resulting action (Thesis 3.2.3, propagation): student, selector, amplifier."""

from __future__ import annotations

from typing import Any, Generic

from tutorstudent.core.deciding.checking import check_graded, check_proposal, check_seal, seal
from tutorstudent.core.deciding.guard import Guard
from tutorstudent.core.deciding.limiting import Limiter
from tutorstudent.core.deciding.rendering import render
from tutorstudent.core.roles.interfaces import ActionSelector, Amplifier, Student
from tutorstudent.core.words.actions import ActionT, rebuild
from tutorstudent.core.words.proposals import ProposalT
from tutorstudent.core.words.records import GradedAction, StateT
from tutorstudent.core.words.turn import Turn


class Grader(Generic[StateT, ActionT, ProposalT]):
    """Asks student, selector and amplifier; where one fails, falls back to the tutor's own action, through slew."""

    def __init__(
        self,
        student: Student[StateT, ActionT, ProposalT],
        selector: ActionSelector[ActionT, ProposalT],
        amplifier: Amplifier[ActionT],
        limiter: Limiter,
        guard: Guard,
    ) -> None:
        self._student, self._selector, self._amplifier = student, selector, amplifier
        self._limiter = limiter
        self._steps = (("student", self._propose), ("selector", self._select), ("amplifier", self._amplify))
        self._guard, self._in_action = guard, guard.blame("action")
        self._proposal: Any = selector.proposal

    def grade(self, turn: Turn[StateT, ActionT]) -> None:
        """Write what is proposed, what is selected and what results, within the limits."""
        part = ""
        try:
            for step in self._steps:
                part, take = step
                take(turn)
                self._guard.check_recursion()
                check_seal(turn._moment.tutor_action, turn._seals[0])
        except BaseException as error:
            self._guard.record(part, error)
            self.fall_back(turn)

    def fall_back(self, turn: Turn[StateT, ActionT]) -> None:
        """Write the tutor's own action at level 0 (through slew where that is set), ampbit 1."""
        shown = rebuild(turn._original)  # what failed may have spoilt the first copy
        limited = self._limiter.fall_back(turn)
        turn._moment = turn._moment._replace(tutor_action=shown)
        turn._seals = (held := seal(shown)), held
        turn._proposal = None
        turn._selected = turn._resulting = GradedAction(shown, limited.level, True)
        turn._rung, turn._limited_by = limited.rung, limited.by

    def render(self, turn: Turn[StateT, ActionT]) -> None:
        """Write the action to execute; the tutor's own where the action class refuses the amplified one."""
        turn._action = turn._original
        if not turn._rung.ends:
            return
        with self._in_action:
            turn._action = render(turn._original, turn._groups, turn._rung.ends)
        if self._in_action.failed:
            self._limiter.forget()
            self.fall_back(turn)

    def _propose(self, turn: Turn[StateT, ActionT]) -> None:
        proposal = self._student.propose(turn._moment)
        check_proposal(proposal, self._proposal)
        turn._proposal = proposal

    def _select(self, turn: Turn[StateT, ActionT]) -> None:
        shown, proposal = turn._moment.tutor_action, turn._proposal
        turn._selected = check_graded(self._selector.select(shown, proposal), shown)  # type: ignore[arg-type]

    def _amplify(self, turn: Turn[StateT, ActionT]) -> None:
        moment, limiter = turn._moment, self._limiter
        level, by = limiter.limit_selected(turn)
        selected = _put(turn._selected, level)
        resulting = check_graded(self._amplifier.amplify(selected, moment.number), moment.tutor_action)
        limited = limiter.limit_resulting(turn, resulting.level)
        # Where slew holds the level up, the selected one rises too: slowing down never counts as amplification.
        turn._selected = _put(selected, max(level, limited.level)) if limited.is_held else selected
        turn._resulting, turn._rung = _put(resulting, limited.level), limited.rung
        turn._limited_by = limited.by or (by if limited.level >= level else "")


def _put(graded: GradedAction[ActionT], level: int) -> GradedAction[ActionT]:
    return graded if graded.level == level else GradedAction(graded.action, level, graded.ampbit)
