"""The thesis's numbered steps, slow and obvious (Thesis 3.2.3 and 5.2.1). Shares no code with the engine.

The Pioneer's actions are written as plain tuples. Comments carry the labels of the thesis's procedures.
"""

from __future__ import annotations

from typing import NamedTuple

AMPLIFICATION_CONSTANT = 0.1
KINDS = ("stop", "forward", "backward", "left", "right")


class Said(NamedTuple):
    """An action as the thesis passes it on: its description, its amplification level and its ampbit."""

    kind: str | None
    level: int
    ampbit: int


class Components(NamedTuple):
    """The component form of an action (Thesis 3.3.1)."""

    translation: float
    rotation: float
    duration: float


class Taught(NamedTuple):
    """A state with the action that the student is to give for it."""

    state: int
    action: Said


def component_form(kind: str | None, tutor: Components, level: int) -> Components:
    """Add or subtract constant x level to the component that the description calls for (Thesis 3.3.2)."""
    value = AMPLIFICATION_CONSTANT * level
    translation, rotation, duration = tutor
    if kind == "forward":
        translation = min(translation + value, 1.0)
    elif kind == "backward":
        translation = max(translation - value, -1.0)
    elif kind == "left":
        rotation = min(rotation + value, 1.0)
    elif kind == "right":
        rotation = max(rotation - value, -1.0)
    return Components(round(translation, 9), round(rotation, 9), round(duration, 9))


def moved_level(kind: str, tutor: Components, level: int) -> int:
    """Return the lowest level with this effect: ours, not the thesis's (docs/decisions/0013)."""
    return min(
        lower for lower in range(level + 1) if component_form(kind, tutor, lower) == component_form(kind, tutor, level)
    )


def action_selector(tutor_kind: str, student: Said) -> Said:
    """Compare the descriptions (Thesis 3.3.3)."""
    if student.kind == tutor_kind:
        return student
    return Said(tutor_kind, 0, 1)


def action_modifier(tutor_kind: str, student: Said) -> Said:
    """Modify the tutor's action with the student's level (Thesis 5.2.1, step 7)."""
    return Said(tutor_kind, student.level, student.ampbit)


def amplifier(selected: Said, in_learning_phase: bool) -> Said:
    """Amplify if the ampbit is true or the learning phase lasts (Thesis 3.3.4). A stop has no component to amplify."""
    if selected.kind == "stop":
        return selected
    if selected.ampbit == 1 or in_learning_phase:
        return Said(selected.kind, selected.level + 1, selected.ampbit)
    return selected


class Stored(NamedTuple):
    """What the evaluator stores in the pre-evaluation phase (a-e)."""

    previous_state: int
    tutor: Said
    selected: Said
    resulting: Said


def evaluator(stored: Stored, violated: bool) -> Taught:
    """Decide what is taught (Thesis 3.2.3 C; ampbit by success, 3.3.5)."""
    amplified = stored.resulting.level != stored.selected.level
    if amplified:  # C(a)
        chosen = stored.selected if violated else stored.resulting
    else:  # C(b)
        chosen = stored.tutor if violated else stored.resulting
    return Taught(stored.previous_state, Said(chosen.kind, chosen.level, 0 if violated else 1))


class Period(NamedTuple):
    """What one time period brings: the state's number, whether it violates, and what tutor and student say there."""

    state: int
    violated: bool
    tutor_kind: str
    tutor: Components
    student: Said


class Produced(NamedTuple):
    """What the algorithm makes of one time period."""

    selected: Said
    resulting: Said
    executed: Components
    taught: Taught | None


class TutorStudentAlgorithm:
    """Both versions of the algorithm, one time period after the other.

    Args:
        streamlined: Whether an action modifier takes the action selector's place (5.2.1).
        learning_phase: Its length in decisions.
    """

    def __init__(self, streamlined: bool, learning_phase: int) -> None:
        self.streamlined = streamlined
        self.learning_phase = learning_phase
        self.decisions = 0
        self.stored: Stored | None = None

    def time_period(self, now: Period) -> Produced:
        """Evaluate the previous period with this state (A-C), then propagate (1-11) and store (a-e)."""
        taught = None if self.stored is None else evaluator(self.stored, now.violated)
        choose = action_modifier if self.streamlined else action_selector
        selected = self.lower(now, choose(now.tutor_kind, now.student))
        resulting = self.lower(now, amplifier(selected, self.decisions < self.learning_phase))
        executed = component_form(now.tutor_kind, now.tutor, resulting.level)
        self.stored = Stored(now.state, Said(now.tutor_kind, 0, 1), selected, resulting)
        self.decisions += 1
        return Produced(selected, resulting, executed, taught)

    def lower(self, now: Period, said: Said) -> Said:
        """Take away the levels that move nothing."""
        return Said(said.kind, moved_level(now.tutor_kind, now.tutor, said.level), said.ampbit)
