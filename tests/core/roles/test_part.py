"""Components: options, places, random streams, nested parts, learned state."""

from __future__ import annotations

from typing import Any

import pytest

import tutorstudent as ts
from tutorstudent.core.roles.binding import Binding, make_stream
from tutorstudent.plugins.amplifiers import LearningPhase
from tutorstudent.plugins.changes import Additive
from tutorstudent.plugins.controls import Random
from tutorstudent.plugins.table import TableStudent
from tutorstudent.sims.pioneer.types import DriveAction


@pytest.mark.parametrize(
    ("build", "message"),
    [
        (lambda: LearningPhase(decisons=3), "amplifier 'learning-phase': unknown option 'decisons' (did you mean"),
        (lambda: LearningPhase(decisions=-1), "option 'decisions': input should be greater than or equal to 0, found"),
        (lambda: LearningPhase(amount=float("nan")), "option 'amount': input should be"),
        (lambda: LearningPhase(change="additive"), "must be a part (Change), not 'additive'; in Python give an"),
        (lambda: TableStudent(), "student 'table': option 'encoder' is required."),
    ],
)
def test_wrong_options_are_told_with_what_is_allowed(build: Any, message: str) -> None:
    with pytest.raises(ts.PipelineError) as caught:
        build()
    assert message in str(caught.value)


def test_a_default_that_is_a_part_is_refused_where_it_is_written() -> None:
    with pytest.raises(ts.ContractError, match=r"change: the default is one part, .*default_factory=Additive"):

        class Shared(ts.Options):
            change: ts.Part[ts.Change] = Additive()


def test_a_default_of_the_wrong_type_is_refused() -> None:
    class Loud(ts.Amplifier[Any]):
        name = "loud"

        class Options(ts.Options):
            change: ts.Part[ts.Change] = "additive"  # type: ignore[assignment]

        amount = 0.1
        change = Additive()

        def amplify(self, selected: Any, decision_number: int) -> Any:
            return selected

    with pytest.raises(ts.PipelineError, match="option 'change' must be a part"):
        Loud()


def test_a_part_has_one_slot() -> None:
    student = Random()
    student.bind(Binding(1, "student", DriveAction))
    with pytest.raises(ts.ContractError, match="student 'random' is already at 'student' of a pipeline"):
        student.bind(Binding(1, "student", DriveAction))


def test_streams_depend_on_seed_and_slot_only() -> None:
    assert make_stream(7, "student").random() == make_stream(7, "student").random()
    drawn = {make_stream(seed, slot).random() for seed in (7, 8) for slot in ("student", "tutor", "student.encoder")}
    assert 6 == len(drawn)


def test_a_part_describes_itself_as_a_pipeline_would_name_it() -> None:
    described = {"use": "learning-phase", "amount": 0.1, "change": {"use": "additive"}, "decisions": 9, "hold_at": None}
    assert described == LearningPhase(decisions=9).describe()


def test_repr_shows_what_was_given() -> None:
    assert "LearningPhase(decisions=9)" == repr(LearningPhase(decisions=9))


def test_learned_state_of_a_part_that_is_not_there_is_refused() -> None:
    with pytest.raises(ts.ContractError, match="student 'random' learned nothing named 'w'"):
        Random().load_state_dict({"w": 1})
