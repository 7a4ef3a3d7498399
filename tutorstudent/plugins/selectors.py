"""Action selectors (Thesis 3.2.2.3, 3.3.3)."""

from __future__ import annotations

from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.interfaces import ActionSelector
from tutorstudent.core.roles.part import Component
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.proposals import KindProposal
from tutorstudent.core.words.records import GradedAction


class SameKind(ActionSelector[ActionT, KindProposal]):
    """Select the student's level and ampbit where it names the tutor's kind; otherwise the tutor's action at level 0.

    Source: Thesis 3.3.3. A code that names no kind equals none.
    """

    name = "same-kind"
    proposal = KindProposal

    def select(self, tutor_action: ActionT, proposal: KindProposal) -> GradedAction[ActionT]:
        if proposal.kind == tutor_action.kind:
            return GradedAction(tutor_action, proposal.level, proposal.ampbit)
        return GradedAction(tutor_action, 0, True)


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the shipped selectors; the streamlined one is in its own plugin."""
    return [SameKind]
