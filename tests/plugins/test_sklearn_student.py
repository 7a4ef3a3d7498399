"""The student over any scikit-learn regressor with partial_fit, and its learned state without pickle."""

from __future__ import annotations

import io
import math
import subprocess
import sys
import threading
from typing import Any

import numpy as np
import pytest
from sklearn.base import BaseEstimator, RegressorMixin

import tutorstudent as ts
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.running.arrays import flatten, nest
from tutorstudent.core.words.records import Lesson, Moment, Outcome
from tutorstudent.plugins import sklearn_student
from tutorstudent.plugins.codecs import KindLevelAmpbit
from tutorstudent.plugins.estimator_state import export_state, fill_state
from tutorstudent.plugins.sklearn_student import SklearnStudent
from tutorstudent.plugins.streamlined import LevelAmpbit
from tutorstudent.sims.pioneer.types import DriveAction

MLP = "sklearn.neural_network.MLPRegressor"
SGD = "sklearn.linear_model.SGDRegressor"
BACKPROP = "tutorstudent.plugins.backprop.regressor.BackpropRegressor"
SMALL: dict[str, dict[str, Any]] = {MLP: {"hidden_layer_sizes": (6,)}, SGD: {"average": True}, BACKPROP: {"hidden": 5}}

State = tuple[float, ...]
AnyStudent = SklearnStudent[State, DriveAction, Any]


class Pair(ts.Encoder[State, DriveAction]):
    """The two numbers of the state."""

    name = "pair"

    @property
    def width(self) -> int:
        return 2

    def encode(self, moment: Moment[State, DriveAction]) -> np.ndarray:
        return np.array(moment.state, dtype=float)


class Stubborn(RegressorMixin, BaseEstimator):  # type: ignore[misc]  # scikit-learn has no types
    """Learns by keeping something that no array holds."""

    def __init__(self, fault: str = "lock") -> None:
        self.fault = fault

    def partial_fit(self, X: np.ndarray, y: np.ndarray) -> Stubborn:
        self.width_ = y.shape[1] if self.fault != "narrow" else 1
        self.kept_: Any = {"lock": threading.Lock(), "function": partial_function}.get(self.fault)
        return self

    def predict(self, X: np.ndarray) -> np.ndarray:
        return np.zeros((len(X), self.width_))


def partial_function() -> None:
    """Something that cannot be saved."""


def student_of(
    estimator: str = SGD, *, seed: int = 7, codec: ts.Codec[Any] | None = None, **options: Any
) -> AnyStudent:
    options = {"params": SMALL.get(estimator, {})} | options
    student: AnyStudent = SklearnStudent(encoder=Pair(), codec=codec or LevelAmpbit(), estimator=estimator, **options)
    student.bind(Binding(seed=seed, slot="student", action=DriveAction))
    return student


def moment(state: State, number: int = 0) -> Moment[State, DriveAction]:
    return Moment(number, state, DriveAction(kind="forward"), "")


def lesson(state: State, level: int, ampbit: bool = True, number: int = 0) -> Lesson[State, DriveAction]:
    target = ts.GradedAction(DriveAction(kind="left"), level, ampbit)
    return Lesson(moment(state, number), target, level, target.action, Outcome(state, (), None, {}))


def taught(student: AnyStudent, lessons: int = 12, first: int = 0) -> AnyStudent:
    for number in range(first, first + lessons):
        student.teach(lesson((number % 2, number % 3), number % 8, number % 2 == 0, number))
    return student


def saved(student: AnyStudent) -> dict[str, Any]:
    """What was learned, as it would come back from a file."""
    stored = io.BytesIO()
    np.savez(stored, allow_pickle=False, **flatten(student.state_dict()))
    stored.seek(0)
    with np.load(stored, allow_pickle=False) as arrays:
        return nest(dict(arrays.items()))


def numbers(student: AnyStudent) -> dict[str, bytes]:
    return {name: array.tobytes() for name, array in flatten(student.state_dict()).items()}


@pytest.mark.parametrize("estimator", [MLP, SGD, BACKPROP])
@pytest.mark.parametrize("codec", [KindLevelAmpbit, LevelAmpbit])
def test_the_first_proposal_is_that_of_one_that_was_taught_nothing(estimator: str, codec: type[ts.Codec[Any]]) -> None:
    proposal = student_of(estimator, codec=codec()).propose(moment((0.0, 1.0)))
    assert {"kind": None} | proposal.model_dump() == {"kind": None, "level": 0, "ampbit": True}


QUICK: dict[str, dict[str, Any]] = {
    MLP: {"hidden_layer_sizes": (6,), "learning_rate_init": 0.02},
    SGD: {"learning_rate": "constant", "eta0": 0.2},
    BACKPROP: {"hidden": 5},
}


@pytest.mark.parametrize("estimator", [MLP, SGD, BACKPROP])
def test_a_repeated_lesson_becomes_the_proposal(estimator: str) -> None:
    student = student_of(estimator, params=QUICK[estimator])
    for number in range(0, 120, 2):
        student.teach(lesson((0.0, 1.0), 6, True, number))
        student.teach(lesson((1.0, 0.0), 1, False, number + 1))
    assert ts.LevelProposal(level=6, ampbit=True) == student.propose(moment((0.0, 1.0)))
    assert ts.LevelProposal(level=1, ampbit=False) == student.propose(moment((1.0, 0.0)))


@pytest.mark.parametrize("estimator", [MLP, SGD, BACKPROP])
def test_the_same_seed_learns_the_same(estimator: str) -> None:
    assert numbers(taught(student_of(estimator, seed=3))) == numbers(taught(student_of(estimator, seed=3)))


def test_another_seed_learns_otherwise_unless_the_random_state_is_given() -> None:
    assert numbers(taught(student_of(MLP, seed=3))) != numbers(taught(student_of(MLP, seed=4)))
    params = SMALL[MLP] | {"random_state": 1}
    third, fourth = student_of(MLP, seed=3, params=params), student_of(MLP, seed=4, params=params)
    assert numbers(taught(third)) == numbers(taught(fourth))


@pytest.mark.parametrize("rate", [1, 4])
def test_a_teaching_rate_of_n_equals_n_lessons(rate: int) -> None:
    at_once, one_by_one = student_of(teaching_rate=rate), student_of(teaching_rate=1)
    for number in range(10):
        at_once.teach(lesson((number, 1.0), number % 8))
        for _ in range(rate):
            one_by_one.teach(lesson((number, 1.0), number % 8))
    assert numbers(one_by_one) == numbers(at_once)


def test_an_estimator_of_one_output_is_repeated_for_each() -> None:
    learned = taught(student_of(SGD)).state_dict()["estimator"]
    assert sorted(learned["estimators_"]) == ["0", "1", "2", "3"]


@pytest.mark.parametrize("estimator", [MLP, SGD, BACKPROP])
def test_what_was_learned_comes_back_from_a_file_and_goes_on_alike(estimator: str) -> None:
    student, other = taught(student_of(estimator)), taught(student_of(estimator), lessons=3, first=9)
    other.load_state_dict(saved(student))
    assert numbers(student) == numbers(other)
    assert numbers(taught(student, first=12)) == numbers(taught(other, first=12))
    assert student.propose(moment((1.0, 2.0))) == other.propose(moment((1.0, 2.0)))


def test_a_student_that_was_taught_nothing_has_nothing_to_save_and_can_be_emptied_again() -> None:
    assert student_of().state_dict() == {}
    student = taught(student_of())
    student.load_state_dict({})
    assert student.state_dict() == {}
    assert numbers(taught(student_of())) == numbers(taught(student))


def test_a_state_dict_is_a_copy() -> None:
    student = taught(student_of(MLP))
    before = numbers(student)
    for array in flatten(student.state_dict()).values():
        array.fill(0) if array.ndim and array.dtype.kind == "f" else None
    assert before == numbers(student)


def changed(path: str, value: Any, estimator: str = MLP) -> dict[str, Any]:
    arrays: dict[str, Any] = flatten(taught(student_of(estimator)).state_dict())
    arrays[path] = np.asarray(value)
    return nest(arrays)


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        ("estimator/coefs_/0", np.zeros((2, 5)), r"estimator.coefs_.0 .*found the shape \(2, 5\), it takes \(2, 6\)"),
        ("estimator/coefs_/0", np.full((2, 6), math.nan), r"coefs_.0 .*some of its values are not finite"),
        ("estimator/coefs_/2", np.zeros(2), r"estimator.coefs_: found 0, 1, 2; it takes 0, 1\."),
        ("estimator/loss_curve_", np.array(["a"]), r"loss_curve_ .*found <U1 values; it takes real numbers"),
        ("estimator/out_activation_", "tanh", r"found 'tanh', the estimator has 'identity'"),
        ("estimator/t_", 1.5, r"estimator.t_: found 1.5; it takes a int\."),
        ("estimator/t_", math.inf, r"estimator.t_: found inf; it takes a int\."),
        ("estimator/t_", "x", r"estimator.t_: found 'x'; it takes a int\."),
        ("estimator/n_iter_", [1], r"estimator.n_iter_: found array"),
        ("estimator/_random_state", 1.0, r"found .*_random_state.*; it takes .*coefs_"),
        ("estimator/predict", 1.0, r"found .*predict.*; it takes .*coefs_"),
        ("other", 1.0, r"found estimator, other; it takes estimator\."),
    ],
)
def test_a_hostile_state_is_refused_as_a_whole(path: str, value: Any, message: str) -> None:
    student = taught(student_of(MLP, seed=5))
    before = numbers(student)
    with pytest.raises(ts.ContractError, match=message):
        student.load_state_dict(changed(path, value))
    assert before == numbers(student)


@pytest.mark.parametrize("state", [{"estimator": 3.0}, {"estimator": np.zeros(3)}, {"estimator": {}}])
def test_a_state_without_structure_is_refused(state: dict[str, Any]) -> None:
    with pytest.raises(ts.ContractError, match=r"MLPRegressor.estimator: found .*; it takes .*coefs_"):
        student_of(MLP).load_state_dict(state)


def test_a_state_of_another_estimator_is_refused() -> None:
    with pytest.raises(ts.ContractError, match=r"it takes estimators_, n_features_in_"):
        student_of(SGD).load_state_dict(saved(taught(student_of(MLP))))


@pytest.mark.parametrize(("fault", "kind"), [("lock", "lock"), ("function", "function")])
def test_an_estimator_that_keeps_more_than_arrays_can_learn_but_not_be_saved(fault: str, kind: str) -> None:
    student = taught(student_of(f"{__name__}.Stubborn", params={"fault": fault}))
    message = rf"Stubborn.kept_ is a {kind}; only arrays, plain values .* can be saved\. Use another estimator"
    with pytest.raises(ts.ContractError, match=message):
        student.state_dict()


def test_an_estimator_that_keeps_itself_is_refused_instead_of_followed_forever() -> None:
    endless: dict[str, Any] = {}
    endless["again"] = endless
    with pytest.raises(ts.ContractError, match=r"x(\.again)+ is a dict"):
        export_state(endless, "x")


def test_whole_numbers_stay_whole() -> None:
    with pytest.raises(ts.ContractError, match=r"x: some of its values are no int64"):
        fill_state(np.arange(3), np.array([0.0, 1e300, 2.0]), "x")
    with pytest.raises(ts.ContractError, match=r"x: some of its values are no bool"):
        fill_state(np.array([True]), np.array([2]), "x")


@pytest.mark.parametrize(
    "value",
    [
        {"a": 1, "b": 2.5, "c": "word", "d": True, "e": None},
        [np.arange(3), np.ones((2, 2))],
        ([1.0, 2.0], (np.zeros(2), 3)),
        {"empty": [], "none": None, "full": [1.0]},
        {"flags": np.array([True, False]), "best": np.float64(-math.inf), "unknown": np.float64(math.nan)},
    ],
)
def test_values_come_back_in_the_form_of_their_template(value: Any) -> None:
    exported = export_state(value, "x")
    again = fill_state(value, exported, "x")
    assert type(value) is type(again)
    np.testing.assert_equal(export_state(again, "x"), exported)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            {"estimator": "sklearn.neural_network.MLPRegresor"},
            r"has no 'MLPRegresor' \(did you mean 'MLPRegressor'\?\)",
        ),
        ({"estimator": "sklearn.neural_nets.MLP"}, r"module 'sklearn.neural_nets' cannot be imported"),
        ({"estimator": "math.sqrt"}, r"'math.sqrt' is no scikit-learn estimator with partial_fit; use for example"),
        ({"estimator": "sklearn.linear_model.Ridge"}, r"Ridge' is no scikit-learn estimator with partial_fit"),
        ({"estimator": "subprocess.Popen"}, r"'subprocess.Popen' is no scikit-learn estimator with partial_fit"),
        ({"estimator": "sklearn.linear_model.SGDClassifier"}, r"it is no regressor; use for example sklearn"),
        (
            {"params": {"alfa": 1.0}},
            r"SGDRegressor' has no parameter 'alfa' \(did you mean 'alpha'\?\); parameters: alp",
        ),
        ({"params": {"alpha": -1.0}}, r"cannot learn 2 -> 4 numbers: The 'alpha' parameter of SGDRegressor must be"),
        ({"estimator": f"{__name__}.Stubborn", "params": {"fault": "narrow"}}, r"it answers with the shape \(1,\)"),
    ],
)
def test_an_estimator_that_cannot_be_used_is_refused_at_once(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ts.PipelineError, match=message):
        student_of(**{"estimator": SGD} | options)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({}, r"option 'estimator' is required"),
        ({"estimator": "MLPRegressor"}, r"option 'estimator': string should match pattern"),
        ({"estimator": "os; x.y"}, r"option 'estimator': string should match pattern"),
        ({"estimator": SGD, "teaching_rate": 0}, r"option 'teaching_rate': input should be greater than or equal to 1"),
    ],
)
def test_wrong_options_are_named(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ts.PipelineError, match=message):
        SklearnStudent(encoder=Pair(), codec=LevelAmpbit(), **options)


def test_without_scikit_learn_the_remedy_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "sklearn.base", None)
    with pytest.raises(ts.PipelineError, match=r"needs scikit-learn; install it with: pip install 'tutorstudent\[skl"):
        student_of()


def test_the_plugin_is_importable_without_scikit_learn() -> None:
    code = "import sys; sys.modules['sklearn'] = None; import tutorstudent.plugins.sklearn_student"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_the_plugin_names_its_student() -> None:
    assert [cls.name for cls in sklearn_student.tutorstudent_components()] == ["sklearn"]
