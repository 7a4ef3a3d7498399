"""From the tutor's action to selected and resulting level (Thesis 3.2.3, steps 4 to 9)."""

from __future__ import annotations

from typing import Any, Generic, NamedTuple

from tutorstudent.core.deciding.guard import Breach, Guard, check_intact, received, sealed
from tutorstudent.core.deciding.limiting import LevelLimiter
from tutorstudent.core.deciding.rendering import Permitted, render
from tutorstudent.core.roles.interfaces import ActionSelector, Amplifier, Student
from tutorstudent.core.words.actions import ActionT, Group, rebuild
from tutorstudent.core.words.proposals import Proposal, ProposalT
from tutorstudent.core.words.records import GradedAction, Moment, StateT


class Graded(NamedTuple, Generic[ActionT]):
    """The outcome of steps 4 to 9, already within the limits."""

    selected: GradedAction[ActionT]
    resulting: GradedAction[ActionT]
    permitted: Permitted
    proposal: Proposal | None


class Grader(Generic[StateT, ActionT, ProposalT]):
    """Asks student, selector and amplifier; where one fails, falls back to the tutor's own action."""

    def __init__(
        self,
        student: Student[StateT, ActionT, ProposalT],
        selector: ActionSelector[ActionT, ProposalT],
        amplifier: Amplifier[ActionT],
        levels: LevelLimiter,
        guard: Guard,
    ) -> None:
        self._student, self._selector, self._amplifier = student, selector, amplifier
        self._levels, self._guard = levels, guard
        self._proposal: Any = selector.proposal

    def grade(self, moment: Moment[StateT, ActionT], original: ActionT, groups: tuple[Group, ...]) -> Graded[ActionT]:
        """Return what is selected and what results for this moment."""
        shown, part = moment.tutor_action, "student"
        seal = sealed(shown)
        try:
            proposal = self._student.propose(moment)
            check_intact(shown, seal)
            if type(proposal) is not self._proposal:
                raise Breach(
                    "wrong-return", f"propose() returned {type(proposal).__name__}; return {self._proposal.__name__}."
                )
            part = "selector"
            selected = received(self._selector.select(shown, proposal), shown)
            check_intact(shown, seal)
            part = "amplifier"
            level = self._levels.select(selected.level, original, groups)
            selected = _at(selected, level)
            resulting = received(self._amplifier.amplify(selected, moment.number), shown)
            check_intact(shown, seal)
            level, permitted = self._levels.result(level, resulting.level, original, groups)
        except KeyboardInterrupt:
            raise
        except BaseException as error:
            self._guard.record(moment.number, part, error)
            return self.fall_back(original, groups)
        return Graded(_at(selected, level), _at(resulting, permitted.level), permitted, proposal)

    def fall_back(self, original: ActionT, groups: tuple[Group, ...]) -> Graded[ActionT]:
        """Return the tutor's own action at level 0 (through slew where that is set), ampbit 1."""
        permitted = self._levels.fall_back(original, groups)
        graded = GradedAction(rebuild(original), permitted.level, True)
        return Graded(graded, graded, permitted, None)

    def render(
        self, number: int, graded: Graded[ActionT], original: ActionT, groups: tuple[Group, ...]
    ) -> tuple[ActionT, Graded[ActionT]]:
        """Return the action to execute; the tutor's own where the action class refuses the amplified one."""
        try:
            return render(original, groups, graded.permitted.fractions), graded
        except KeyboardInterrupt:
            raise
        except BaseException as error:
            self._guard.record(number, "action", error)
            self._levels.forget()
            return original, self.fall_back(original, groups)


def _at(graded: GradedAction[ActionT], level: int) -> GradedAction[ActionT]:
    return graded if graded.level == level else GradedAction(graded.action, level, graded.ampbit)
