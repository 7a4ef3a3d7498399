"""What has to fit together before anything moves, and what is said where it does not."""

from __future__ import annotations

import re
from typing import Any

import pytest

from tests.core.oracle.scripted import KindStudent, Says, ScriptedTutor, engine, forward, level
from tests.core.oracle.shapes import Valve
from tutorstudent.core.words.actions import Action, component
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
