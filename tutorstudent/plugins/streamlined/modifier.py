"""The action modifier, which takes the selector's place in the streamlined algorithm (Thesis 5.2.1)."""

from __future__ import annotations

from typing import ClassVar

from tutorstudent.core.roles.interfaces import ActionSelector
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.proposals import LevelProposal, Proposal
from tutorstudent.core.words.records import GradedAction


class Modifier(ActionSelector[ActionT, LevelProposal]):
    """Give the tutor's action the student's level and ampbit, whatever its kind (Thesis 5.2.1, step 7)."""

    name = "modifier"
    proposal: ClassVar[type[Proposal]] = LevelProposal

    def select(self, tutor_action: ActionT, proposal: LevelProposal) -> GradedAction[ActionT]:
        return GradedAction(tutor_action, proposal.level, proposal.ampbit)
