"""The scikit-learn regressor keeps scikit-learn's contract, over the very network of the student."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from sklearn.utils import get_tags
from sklearn.utils.estimator_checks import parametrize_with_checks

from tutorstudent.plugins.backprop.network import Network
from tutorstudent.plugins.backprop.regressor import BackpropRegressor


@parametrize_with_checks([BackpropRegressor(epochs=20)])  # type: ignore[untyped-decorator]
def test_it_passes_every_check_of_scikit_learn(estimator: Any, check: Callable[[Any], None]) -> None:
    check(estimator)


@pytest.mark.slow
@parametrize_with_checks([BackpropRegressor()])  # type: ignore[untyped-decorator]
def test_it_passes_every_check_of_scikit_learn_as_it_comes(estimator: Any, check: Callable[[Any], None]) -> None:
    check(estimator)


def test_it_asks_scikit_learn_for_no_leniency() -> None:
    tags = get_tags(BackpropRegressor())
    assert not tags.regressor_tags.poor_score
    assert not tags.non_deterministic
    assert not tags.no_validation


def curve(outputs: int | None = None) -> tuple[np.ndarray, np.ndarray]:
    x = np.random.default_rng(1).uniform(-20, 20, size=(80, 2))
    y = 1000 + 5 * x[:, 0] - 3 * np.abs(x[:, 1])
    return (x, y) if outputs is None else (x, np.stack([y * (k + 1) for k in range(outputs)], axis=1))


def test_a_curve_is_learned_in_its_own_units() -> None:
    x, y = curve()
    assert BackpropRegressor(random_state=7).fit(x, y).score(x, y) > 0.95


def test_several_outputs_are_learned_at_once() -> None:
    x, y = curve(3)
    regressor = BackpropRegressor(random_state=7).fit(x, y)
    assert y.shape == regressor.predict(x).shape
    assert regressor.score(x, y) > 0.95


def test_it_is_the_student_s_network_on_scaled_numbers() -> None:
    x, y = curve(2)
    regressor = BackpropRegressor(hidden=5, random_state=7).partial_fit(x, y)
    seed = np.random.RandomState(7).randint(2**31 - 1)
    network = Network(2, 5, 2, learning_rate=0.3, momentum=0.9)
    network.randomize(np.random.default_rng(seed), 0.1)
    for row, target in zip((x - x.min(0)) / np.ptp(x, 0), (y - y.min(0)) / np.ptp(y, 0), strict=True):
        network.teach(2 * row - 1, 0.1 + 0.8 * target)
    expected = np.array([network.forward(2 * row - 1).copy() for row in (x - x.min(0)) / np.ptp(x, 0)])
    np.testing.assert_allclose(regressor.predict(x), y.min(0) + (expected - 0.1) / 0.8 * np.ptp(y, 0), rtol=1e-9)


def test_examples_one_at_a_time_are_learned_and_widen_the_range() -> None:
    x, y = curve()
    regressor = BackpropRegressor(random_state=7)
    for row, target in zip(x, y, strict=True):
        regressor.partial_fit(row[None, :], [target])
    assert [y.min(), y.max()] == regressor.target_range_[:, 0].tolist()
    assert x.max(0).tolist() == regressor.input_range_[1].tolist()
    for _ in range(200):
        regressor.partial_fit(x, y)
    assert regressor.score(x, y) > 0.95


def test_a_target_that_never_changes_is_answered() -> None:
    x, y = curve()
    regressor = BackpropRegressor(random_state=7).fit(x, np.full_like(y, 42.0))
    np.testing.assert_allclose(regressor.predict(x), 42.0, atol=0.1)


def test_another_number_of_outputs_later_is_refused() -> None:
    x, y = curve(2)
    with pytest.raises(ValueError, match=r"y has 3 outputs; it had 2 before"):
        BackpropRegressor().partial_fit(x, y).partial_fit(*curve(3))


@pytest.mark.parametrize(
    ("params", "message"),
    [
        ({"hidden": 0}, r"hidden is 0; it must be at least 1"),
        ({"epochs": 0}, r"epochs is 0; it must be at least 1"),
        ({"learning_rate": 0.0}, r"learning_rate is 0.0; it must be above 0 and at most 10"),
        ({"initial_weight": float("nan")}, r"initial_weight is nan; it must be above 0 and at most 10"),
        ({"momentum": 1.0}, r"momentum is 1.0; it must be at least 0 and below 1"),
    ],
)
def test_wrong_parameters_are_named(params: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        BackpropRegressor(**params).fit(*curve())


@pytest.mark.process
def test_the_student_s_plugin_does_not_import_scikit_learn() -> None:
    code = """
import sys
import tutorstudent.plugins.backprop, tutorstudent.plugins.table, tutorstudent.plugins.sklearn_student
sys.exit(any(name.split(".")[0] == "sklearn" for name in sys.modules))
"""
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
