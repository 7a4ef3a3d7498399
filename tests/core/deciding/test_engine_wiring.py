"""What has to fit together before anything moves, and what is said where it does not."""

from __future__ import annotations

import re
from enum import Enum
from typing import Annotated, Any, Literal

import pytest
from pydantic import BaseModel, create_model, field_validator

from tests.core.oracle.scripted import KindStudent, Says, ScriptedTutor, engine, forward, level
from tests.core.oracle.shapes import Valve
from tutorstudent.core.deciding.wiring import can_be_held
from tutorstudent.core.words.actions import Action, component, read_vocabulary
from tutorstudent.core.words.errors import ContractError
from tutorstudent.plugins.amplifiers import Never
from tutorstudent.plugins.changes import Additive
from tutorstudent.plugins.selectors import SameKind
from tutorstudent.sims.pioneer.types import DriveAction


def refusal(**parts: Any) -> str:
    """Return what is said when these parts are put together."""
    student = parts.pop("student", None) or level(1)
    with pytest.raises(ContractError) as caught:
        engine(forward(0.1), student, **parts)
    return str(caught.value)


def test_a_tutor_with_nothing_to_amplify_is_refused_with_the_reason() -> None:
    class Frozen(Action):
        speed: float = component(0.0, 1.0)
        angle: float = component(0.0, 1.0)

    class Still(ScriptedTutor):
        name = "still"
        action = Frozen

    expected = (
        "tutor 'still': the action class Frozen has nothing to amplify; its components are angle, speed. "
        "Name at least one in its 'amplification'."
    )
    assert expected == refusal(tutor=Still(act=len))


def test_a_selector_that_cannot_read_the_students_proposals_is_refused_with_the_remedy() -> None:
    message = refusal(selector=SameKind())
    assert re.search(
        "selector 'same-kind' needs KindProposal but student 'scripted-level' makes LevelProposal", message
    )
    assert "'same-kind' reads the codec 'kind-level-ampbit'; the selector 'modifier' reads 'level-ampbit'" in message


def test_the_streamlined_selector_cannot_read_kinds() -> None:
    message = refusal(student=KindStudent(propose=len))
    assert "selector 'modifier' needs LevelProposal but student 'scripted-kind' makes KindProposal" in message


def test_a_failure_action_of_another_class_is_refused() -> None:
    message = refusal(on_tutor_failure=Valve(opening=0.0))
    assert message == "on_tutor_failure: found Valve; expected the tutor's DriveAction."


def test_a_failure_action_that_was_tampered_with_is_refused() -> None:
    stop = DriveAction(kind="stop")
    stop.__dict__["translation"] = float("nan")
    with pytest.raises((ContractError, ValueError)):
        engine(forward(0.1), level(1), on_tutor_failure=stop)


def test_two_conditions_of_one_name_are_refused() -> None:
    message = refusal(conditions=[Says(violated=bool), Says(violated=len)])
    assert message == "condition 'says' stands there twice; each condition has a name of its own."


def test_a_nested_part_has_one_slot_only() -> None:
    shared = Additive()
    engine(forward(0.1), level(1), amplifier=Never(change=shared))
    message = refusal(amplifier=Never(change=shared))
    assert message == "change 'additive' is already at 'amplifier.change' of a pipeline; make one for each slot."


def test_parts_are_told_their_slots() -> None:
    wrapped = engine(
        forward(0.1), level(1), conditions=[Says(violated=bool, label="a"), Says(violated=bool, label="b")]
    )
    expected = ["tutor", "student", "selector", "amplifier", "evaluator", "conditions.a", "conditions.b"]
    assert expected == [slot for slot, _ in wrapped.slots()]
    assert expected == [part.slot for _, part in wrapped.slots()]
    assert wrapped.amplifier.change.slot == "amplifier.change"
    assert {DriveAction} == {part.action_class for _, part in wrapped.slots()}


class Inner(BaseModel):
    """A nested model."""

    x: float = 0.0


class Mood(Enum):
    CALM = 1


@pytest.mark.parametrize(
    "annotation", [list[float], dict[str, float], Inner, Any, tuple[list[int], ...], set[int] | None]
)
def test_a_component_that_parts_could_change_is_refused_by_name(annotation: Any) -> None:
    made = create_model("Loose", __base__=DriveAction, extra_thing=(annotation, None))
    made.vocabulary = read_vocabulary(made)
    tutor = ScriptedTutor(act=lambda state: made(kind="stop"))
    tutor.action = made
    message = "action class Loose: the component 'extra_thing' is a .* Use numbers, texts, enums, literals, or tuples"
    with pytest.raises(ContractError, match=message):
        engine(lambda state: made(kind="stop"), level(0), tutor=tutor)


@pytest.mark.parametrize(
    "annotation", [int, str | None, Literal["a", 1], Mood, tuple[float, ...], Annotated[bool, "x"]]
)
def test_a_component_that_nobody_can_change_is_taken(annotation: Any) -> None:
    assert can_be_held(annotation)


class Heading(DriveAction):
    """A validator that is not idempotent: degrees to radians."""

    heading: float = 0.0

    @field_validator("heading")
    @classmethod
    def _to_radians(cls, value: float) -> float:
        return value / 57.3


def test_an_action_class_that_changes_an_undeclared_component_when_it_is_made_again_is_never_amplified() -> None:
    own = Heading(kind="forward", translation=0.2, heading=90.0)
    tutor = ScriptedTutor(act=lambda state: own)
    tutor.action = Heading
    wrapped = engine(lambda state: own, level(3), tutor=tutor)
    for state in range(3):
        assert wrapped.step(state) is own
    assert {("action", "mutated"): 3} == wrapped.incident_counts
    assert "gave 'heading' another value" in wrapped.incidents[0].message
