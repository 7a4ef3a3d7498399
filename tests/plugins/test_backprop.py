"""The backpropagation student: encoder, network, codec (Thesis 3.3.2, 3.3.5, Table 1)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

import tutorstudent as ts
from tutorstudent.core.roles.binding import Binding, make_stream
from tutorstudent.core.words.records import Lesson, Moment, Outcome
from tutorstudent.plugins.backprop import BackpropStudent, Network
from tutorstudent.plugins.codecs import KindLevelAmpbit
from tutorstudent.plugins.streamlined import LevelAmpbit
from tutorstudent.sims.pioneer.types import DriveAction

State = np.ndarray
AnyStudent = BackpropStudent[State, DriveAction, Any]


class Numbers(ts.Encoder[State, DriveAction]):
    """The state itself, in one buffer that is used again, as encoders may; counts its calls."""

    name = "numbers"

    class Options(ts.Options):
        size: int = 14

    def setup(self) -> None:
        self.calls = 0
        self._buffer = np.empty(self.width)

    @property
    def width(self) -> int:
        return int(self.options.size)

    def encode(self, moment: Moment[State, DriveAction]) -> np.ndarray:
        self.calls += 1
        self._buffer[:] = moment.state
        return self._buffer


class Wrong(Numbers):
    """Says 14 and returns what it is given."""

    name = "wrong"

    def encode(self, moment: Moment[State, DriveAction]) -> np.ndarray:
        return moment.state


class WrongCodec(KindLevelAmpbit):
    """A codec whose encoding can be spoilt."""

    name = "wrong-codec"
    spoilt: np.ndarray

    def encode(self, target: ts.GradedAction[Any]) -> np.ndarray:
        return self.spoilt


def student_of(codec: ts.Codec[Any] | None = None, *, seed: int = 7, **options: Any) -> AnyStudent:
    student: AnyStudent = BackpropStudent(
        encoder=options.pop("encoder", None) or Numbers(), codec=codec or KindLevelAmpbit(), **options
    )
    student.bind(Binding(seed=seed, slot="student", action=DriveAction))
    return student


def moment(number: int, state: np.ndarray, kind: str = "forward") -> Moment[State, DriveAction]:
    return Moment(number, state, DriveAction.model_validate({"kind": kind}), "")


def lesson(
    about: Moment[State, DriveAction], kind: str = "right", level: int = 5, ampbit: bool = False
) -> Lesson[State, DriveAction]:
    target = ts.GradedAction(DriveAction.model_validate({"kind": kind}), level, ampbit)
    return Lesson(about, target, level, target.action, Outcome(about.state, (), None, {}))


def bits(seed: int, size: int = 14) -> np.ndarray:
    return (np.random.default_rng(seed).random(size) > 0.5).astype(float)


def weights(student: AnyStudent) -> dict[str, bytes]:
    return {name: array.tobytes() for name, array in student.state_dict().items()}


def test_the_defaults_are_table_1() -> None:
    student = student_of()
    learned = student.state_dict()
    assert learned["hidden_weights"].shape == (30, 14 + 1)
    assert learned["output_weights"].shape == (7, 30 + 1)
    options = student.options
    assert (options.learning_rate, options.momentum, options.teaching_rate) == (0.3, 0.9, 3)
    assert options.codec.name == "kind-level-ampbit"


def test_the_codec_may_be_left_out_of_a_pipeline() -> None:
    options: dict[str, Any] = {"encoder": Numbers()}
    assert BackpropStudent(**options).proposal is ts.KindProposal


def test_the_proposal_type_is_the_codec_s_before_and_after_binding() -> None:
    assert BackpropStudent(encoder=Numbers(), codec=LevelAmpbit()).proposal is ts.LevelProposal
    assert student_of(LevelAmpbit()).proposal is ts.LevelProposal


def test_it_proposes_what_a_network_with_the_slot_s_random_stream_says() -> None:
    student, codec = student_of(), KindLevelAmpbit()
    codec.bind(Binding(seed=1, slot="x", action=DriveAction))
    network = Network(14, 30, 7, learning_rate=0.3, momentum=0.9)
    network.randomize(make_stream(7, "student"), 0.1)
    for number in range(60):
        about = moment(number, bits(number % 9))
        assert codec.decode(network.forward(about.state)) == student.propose(about)
        taught = lesson(about, level=number % 8, ampbit=number % 3 > 0)
        student.teach(taught)
        network.teach(about.state, codec.encode(taught.target), 3)


@pytest.mark.parametrize("codec", [KindLevelAmpbit, LevelAmpbit])
def test_a_repeated_lesson_becomes_the_proposal(codec: type[ts.Codec[Any]]) -> None:
    student = student_of(codec())
    about = moment(0, bits(1))
    for _ in range(200):
        student.propose(about)
        student.teach(lesson(about, "backward", 6, True))
    expected = {"kind": "backward", "level": 6, "ampbit": True}
    proposed = student.propose(about).model_dump()
    assert {key: expected[key] for key in proposed} == proposed


@pytest.mark.parametrize("rate", [1, 3, 7])
def test_a_teaching_rate_of_n_equals_n_lessons(rate: int) -> None:
    at_once, one_by_one = student_of(teaching_rate=rate), student_of(teaching_rate=1)
    for number in range(20):
        taught = lesson(moment(number, bits(number)), level=number % 8)
        at_once.teach(taught)
        for _ in range(rate):
            one_by_one.teach(taught)
    assert weights(one_by_one) == weights(at_once)


def test_the_same_seed_gives_the_same_weights_and_another_seed_others() -> None:
    assert weights(student_of(seed=3)) == weights(student_of(seed=3))
    assert weights(student_of(seed=3)) != weights(student_of(seed=4))


def test_the_initial_weights_fill_their_interval() -> None:
    drawn = student_of(initial_weight=0.5).state_dict()["hidden_weights"]
    assert 0.45 < np.abs(drawn).max() <= 0.5


def test_the_moment_of_a_lesson_is_not_encoded_again() -> None:
    student = student_of()
    about = moment(4, bits(1))
    student.propose(about)
    student.teach(lesson(about))
    assert student.options.encoder.calls == 1


def test_a_lesson_about_another_decision_is_encoded_anew() -> None:
    student, other = student_of(), student_of()
    student.propose(moment(5, bits(2)))
    student.teach(lesson(moment(4, bits(1))))
    other.teach(lesson(moment(4, bits(1))))
    assert student.options.encoder.calls == 2
    assert weights(other) == weights(student)


def test_lessons_about_what_was_never_proposed_for_are_told_apart_whatever_their_number() -> None:
    student, other = student_of(), student_of()
    for number, seed in ((0, 1), (0, 2)):
        student.teach(lesson(moment(number, bits(seed))))
    for number, seed in ((0, 1), (1, 2)):
        other.teach(lesson(moment(number, bits(seed))))
    assert weights(other) == weights(student)


def test_a_lesson_about_another_decision_in_between_is_not_taken_for_the_proposed_one() -> None:
    student, other = student_of(), student_of()
    student.propose(moment(0, bits(1)))
    for about in (moment(5, bits(2)), moment(0, bits(1))):
        student.teach(lesson(about))
        other.teach(lesson(about))
    assert weights(other) == weights(student)


def test_a_state_whose_buffer_is_used_again_does_not_fool_it() -> None:
    student, other, buffer = student_of(), student_of(), bits(1)
    about = moment(0, buffer)
    student.propose(about)
    buffer[:] = bits(2)  # the same object, other numbers, before the lesson about the first comes
    student.teach(lesson(about))
    other.teach(lesson(moment(0, bits(1))))
    assert weights(other) == weights(student)
    student.propose(moment(1, buffer))
    student.teach(lesson(moment(1, buffer)))
    other.teach(lesson(moment(1, bits(2))))
    assert weights(other) == weights(student)


def test_a_state_equal_to_the_last_is_still_encoded_for_its_own_decision() -> None:
    student, state = student_of(), bits(1)
    student.propose(moment(0, state))
    student.propose(moment(1, state))
    assert student.options.encoder.calls == 2


def test_reset_keeps_what_was_learned_and_forgets_the_moment() -> None:
    student = student_of()
    about = moment(0, bits(1))
    student.propose(about)
    student.teach(lesson(about))
    before = weights(student)
    student.reset()
    assert before == weights(student)
    student.teach(lesson(about))
    assert student.options.encoder.calls == 2


@pytest.mark.parametrize(
    ("state", "message"),
    [
        (np.full(14, math.nan), r"encoder 'wrong' returned numbers that are not finite"),
        (np.array([math.inf] + [0.0] * 13), r"encoder 'wrong' returned numbers that are not finite"),
        (np.zeros(1), r"encoder 'wrong' returned the shape \(1,\); its width says \(14,\)"),
        (np.zeros(()), r"encoder 'wrong' returned the shape \(\); its width says \(14,\)"),
        (np.zeros((14, 1)), r"encoder 'wrong' returned the shape \(14, 1\); its width says \(14,\)"),
    ],
)
def test_a_broken_encoding_is_refused_and_nothing_is_learned_from_it(state: np.ndarray, message: str) -> None:
    student = student_of(encoder=Wrong())
    before = weights(student)
    with pytest.raises(ts.ContractError, match=message):
        student.propose(moment(0, state))
    with pytest.raises(ts.ContractError, match=message):
        student.teach(lesson(moment(0, state)))
    assert before == weights(student)


@pytest.mark.parametrize("spoilt", [np.full(7, math.nan), np.zeros(1), np.zeros(8)])
def test_a_broken_target_is_refused_and_nothing_is_learned_from_it(spoilt: np.ndarray) -> None:
    codec = WrongCodec()
    student = student_of(codec)
    codec.spoilt = spoilt
    before = weights(student)
    with pytest.raises(ts.ContractError, match=r"codec 'wrong-codec' returned"):
        student.teach(lesson(moment(0, bits(1))))
    assert before == weights(student)


def test_learned_weights_travel_to_another_student_with_their_momentum() -> None:
    student, other = student_of(seed=1), student_of(seed=2)
    for number in range(10):
        student.teach(lesson(moment(number, bits(number))))
    other.load_state_dict(student.state_dict())
    student.teach(lesson(moment(10, bits(10))))
    other.teach(lesson(moment(10, bits(10))))
    assert weights(student) == weights(other)


def test_a_state_dict_is_a_copy() -> None:
    student = student_of()
    kept = student.state_dict()
    before = weights(student)
    kept["hidden_weights"][:] = 0.0
    assert before == weights(student)
    student.load_state_dict(kept)
    kept["hidden_weights"][:] = 1.0
    assert not student.state_dict()["hidden_weights"].any()


def spoil(name: str, value: Any) -> dict[str, Any]:
    return {**student_of().state_dict(), name: value}


def without(name: str) -> dict[str, Any]:
    return {key: value for key, value in student_of().state_dict().items() if key != name}


@pytest.mark.parametrize(
    ("state", "message"),
    [
        ({}, r"student 'backprop' misses 'hidden_weights'; it takes .*, found none"),
        (without("output_changes"), r"misses 'output_changes'; it takes .*output_changes.*, found hidden_changes"),
        (spoil("hiden_weights", 0.0), r"learned nothing named 'hiden_weights' \(did you mean 'hidden_weights'\?\)"),
        (
            spoil("hidden_weights", np.zeros((30, 14))),
            r"'hidden_weights': found the shape \(30, 14\), it takes \(30, 15\)",
        ),
        (spoil("hidden_weights", np.float64(1.0)), r"'hidden_weights': found the shape \(\), it takes \(30, 15\)"),
        (spoil("output_weights", np.full((7, 31), math.nan)), r"'output_weights': some of its values are not finite"),
        (spoil("output_weights", np.zeros((7, 31), dtype=complex)), r"found complex128 values; it takes real numbers"),
        (spoil("output_weights", [["a"] * 31] * 7), r"found <U1 values; it takes real numbers"),
        (spoil("output_weights", None), r"found object values; it takes real numbers"),
        (spoil("output_weights", [[1.0], [1.0, 2.0]]), r"cannot load 'output_weights': it is no array"),
    ],
)
def test_a_hostile_state_is_refused_as_a_whole(state: Mapping[str, Any], message: str) -> None:
    student = student_of(seed=5)
    before = weights(student)
    with pytest.raises(ts.ContractError, match=message):
        student.load_state_dict(state)
    assert before == weights(student)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"hiden": 20}, r"unknown option 'hiden' \(did you mean 'hidden'\?\)"),
        ({"hidden": 0}, r"option 'hidden': input should be greater than or equal to 1, found 0"),
        ({"learning_rate": 0}, r"option 'learning_rate': input should be greater than 0"),
        ({"momentum": 1.0}, r"option 'momentum': input should be less than 1"),
        ({"teaching_rate": 0}, r"option 'teaching_rate': input should be greater than or equal to 1"),
        ({"initial_weight": math.nan}, r"option 'initial_weight': input should be"),
        ({"codec": "level-ampbit"}, r"option 'codec' must be a part \(Codec\), not 'level-ampbit'"),
    ],
)
def test_wrong_options_are_named(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ts.PipelineError, match=message):
        BackpropStudent(**{"encoder": Numbers(), "codec": KindLevelAmpbit()} | options)


def test_an_encoder_is_required() -> None:
    options: dict[str, Any] = {}
    with pytest.raises(ts.PipelineError, match=r"student 'backprop': option 'encoder' is required"):
        BackpropStudent(**options)
