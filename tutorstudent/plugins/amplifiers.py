"""Amplifiers (Thesis 3.2.2.4, 3.3.4)."""

from __future__ import annotations

from tutorstudent.core.roles import part
from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.interfaces import Amplifier
from tutorstudent.core.roles.leaves import Change
from tutorstudent.core.roles.part import Component, Field
from tutorstudent.core.roles.part_options import Part
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.records import GradedAction
from tutorstudent.plugins.changes import Additive


class Never(Amplifier[ActionT]):
    """Raise nothing. What is selected is executed; with the silent student, that is the tutor alone."""

    name = "never"

    class Options(part.Options):
        """How far a level moves a component."""

        amount: float = Field(default=0.1, gt=0, description="amplification per level, in units of the scale (Table 1)")
        change: Part[Change] = Field(default_factory=Additive, description="how an amplification becomes a distance")

    @property
    def amount(self) -> float:
        return float(self.options.amount)

    @property
    def change(self) -> Change:
        found: Change = self.options.change
        return found

    def amplify(self, selected: GradedAction[ActionT], decision_number: int) -> GradedAction[ActionT]:
        return selected


class LearningPhase(Never[ActionT]):
    """Raise the level by one if the ampbit is set or the learning phase lasts (Thesis 3.3.4).

    Kinds with nothing to amplify are never raised. Choice: what hold_at does, see docs/fidelity.md.
    """

    name = "learning-phase"

    class Options(Never.Options):
        """How long the ampbit is overruled, and where raising ends."""

        decisions: int = Field(default=2500, ge=0, description="length of the learning phase, in decisions (4.2)")
        hold_at: int | None = Field(default=None, ge=0, description="levels from here on are not raised; none: never")

    def amplify(self, selected: GradedAction[ActionT], decision_number: int) -> GradedAction[ActionT]:
        action, level, ampbit = selected
        if not (ampbit or decision_number < self.options.decisions):
            return selected
        if not action.vocabulary.groups[action.kind] or (
            self.options.hold_at is not None and level >= self.options.hold_at
        ):
            return selected
        return GradedAction(action, level + 1, ampbit)


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the shipped amplifiers."""
    return [Never, LearningPhase]
