"""The student that remembers: exact, last lesson wins, nothing generalizes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import tutorstudent as ts
from tests.plugins.pair import Pair, State, moment
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.words.records import Lesson, Outcome
from tutorstudent.plugins.codecs import KindLevelAmpbit
from tutorstudent.plugins.streamlined import LevelAmpbit
from tutorstudent.plugins.table import TableStudent
from tutorstudent.sims.pioneer.types import DriveAction

AnyStudent = TableStudent[State, DriveAction, Any]


class OddCodec(KindLevelAmpbit):
    """Claims a proposal type that nobody knows."""

    name = "odd"
    proposal = dict


class ThriftyCodec(KindLevelAmpbit):
    """Encodes into one buffer."""

    name = "thrifty"

    def setup(self) -> None:
        super().setup()
        self._buffer = np.empty(self.width)

    def encode(self, target: ts.GradedAction[Any]) -> np.ndarray:
        self._buffer[:] = super().encode(target)
        return self._buffer


def student_of(codec: ts.Codec[Any] | None = None) -> AnyStudent:
    student: AnyStudent = TableStudent(encoder=Pair(), codec=codec or KindLevelAmpbit())
    student.bind(Binding(seed=7, slot="student", action=DriveAction))
    return student


def lesson(state: State, kind: str, level: int, ampbit: bool, number: int = 0) -> Lesson[State, DriveAction]:
    target = ts.GradedAction(DriveAction.model_validate({"kind": kind}), level, ampbit)
    return Lesson(moment(state, number), target, level, target.action, Outcome(state, (), None, {}))


def test_what_was_never_taught_is_left_to_the_tutor() -> None:
    untaught = student_of().propose(moment((0.0, 1.0)))
    assert ts.KindProposal(kind=None, level=0, ampbit=True) == untaught
    assert ts.LevelProposal(level=0, ampbit=True) == student_of(LevelAmpbit()).propose(moment((0.0, 1.0)))


def test_the_last_lesson_for_the_same_inputs_wins_and_no_other_inputs_know_of_it() -> None:
    student = student_of()
    student.teach(lesson((0.0, 1.0), "left", 3, True))
    student.teach(lesson((0.0, 1.0), "right", 2, False))
    assert ts.KindProposal(kind="right", level=2, ampbit=False) == student.propose(moment((0.0, 1.0)))
    assert student.propose(moment((0.0, math.nextafter(1.0, 2.0)))).kind is None


def test_it_equals_a_dictionary_over_many_lessons() -> None:
    student, known, rng = student_of(LevelAmpbit()), dict[State, tuple[int, bool]](), np.random.default_rng(1)
    for number in range(500):
        state = (float(rng.integers(4)), float(rng.integers(4)))
        level, ampbit = known.get(state, (0, True))
        assert ts.LevelProposal(level=level, ampbit=ampbit) == student.propose(moment(state, number))
        known[state] = (int(rng.integers(8)), bool(rng.integers(2)))
        student.teach(lesson(state, "left", *known[state], number))
    assert len(known) == len(student.state_dict()["inputs"])


def test_a_codec_that_uses_its_buffer_again_does_not_fool_it() -> None:
    student = student_of(ThriftyCodec())
    student.teach(lesson((0.0, 1.0), "left", 3, True, 0))
    student.teach(lesson((1.0, 1.0), "right", 5, False, 1))
    assert ts.KindProposal(kind="left", level=3, ampbit=True) == student.propose(moment((0.0, 1.0), 2))


def test_zero_and_minus_zero_are_one_number() -> None:
    student = student_of()
    student.teach(lesson((-0.0, 1.0), "left", 3, True))
    assert student.propose(moment((0.0, 1.0), 1)).kind == "left"


@pytest.mark.parametrize("lessons", [0, 1, 20])
def test_what_was_learned_travels_as_two_arrays(lessons: int) -> None:
    student, other = student_of(), student_of()
    for number in range(lessons):
        student.teach(lesson((number, 0.0), "left", number % 8, True, number))
    learned = student.state_dict()
    assert ((lessons, 2), (lessons, 7)) == (learned["inputs"].shape, learned["outputs"].shape)
    other.teach(lesson((99.0, 99.0), "left", 1, True))
    other.load_state_dict(learned)
    learned["outputs"][:] = math.nan
    assert lessons == len(other.state_dict()["inputs"])
    for number in range(lessons):
        assert student.propose(moment((number, 0.0))) == other.propose(moment((number, 0.0)))


def test_reset_keeps_the_table() -> None:
    student = student_of()
    student.teach(lesson((0.0, 1.0), "left", 3, True))
    student.reset()
    assert student.propose(moment((0.0, 1.0))).level == 3


@pytest.mark.parametrize(
    ("state", "message"),
    [
        ({}, r"student 'table' misses 'inputs'; it takes inputs, outputs, found none"),
        ({"inputs": np.zeros((1, 2)), "output": 1}, r"learned nothing named 'output' \(did you mean 'outputs'\?\)"),
        (
            {"inputs": np.zeros((2, 2)), "outputs": np.zeros((3, 7))},
            r"student 'table' cannot load 2 inputs with 3 outputs",
        ),
        (
            {"inputs": np.zeros((2, 3)), "outputs": np.zeros((2, 7))},
            r"'inputs': found the shape \(2, 3\), it takes \(any, 2\)",
        ),
        ({"inputs": np.zeros((2, 2)), "outputs": np.zeros(7)}, r"found the shape \(7,\), it takes \(any, 7\)"),
        ({"inputs": np.zeros((1, 2)), "outputs": np.full((1, 7), math.inf)}, r"'outputs': some .* not finite"),
    ],
)
def test_a_hostile_state_is_refused_as_a_whole(state: dict[str, Any], message: str) -> None:
    student = student_of()
    student.teach(lesson((0.0, 1.0), "left", 3, True))
    with pytest.raises(ts.ContractError, match=message):
        student.load_state_dict(state)
    assert student.propose(moment((0.0, 1.0))).level == 3


def test_a_codec_of_an_unknown_proposal_type_is_refused() -> None:
    with pytest.raises(ts.PipelineError, match=r"codec 'odd' proposes dict; this student can say KindProposal, Level"):
        student_of(OddCodec())
