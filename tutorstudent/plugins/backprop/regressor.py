"""The thesis's network as a scikit-learn regressor (``pip install 'tutorstudent[sklearn]'``)."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, RegressorMixin
from sklearn.utils import check_random_state
from sklearn.utils.validation import check_is_fitted, validate_data

from tutorstudent.plugins.backprop.network import Network

Matrix = NDArray[np.float64]

# Targets are mapped into the part of the logistic function's range that finite net inputs reach easily.
_LOWEST, _HIGHEST = 0.1, 0.9


class BackpropRegressor(RegressorMixin, BaseEstimator):  # type: ignore[misc]  # scikit-learn has no types
    """Incremental backpropagation (Thesis Appendix C, Table 1) behind scikit-learn's interface.

    Inputs are mapped to [-1, 1] and targets to [0.1, 0.9] by the smallest and largest values seen so far; when
    `partial_fit` widens these, earlier answers stretch with them.

    >>> X = np.linspace(0, 1, 50)[:, None]
    >>> regressor = BackpropRegressor(random_state=7).fit(X, 3 * X[:, 0] + 5)
    >>> bool(abs(regressor.predict([[0.5]])[0] - 6.5) < 0.2)
    True

    Args:
        hidden: Number of hidden neurons.
        learning_rate: Step along the error.
        momentum: Part of the last change that is made again, in [0, 1).
        initial_weight: Largest size of a weight at the start.
        epochs: How often `fit` teaches every example, each time in a new order.
        random_state: Seed of the initial weights and of the orders.
    """

    def __init__(
        self,
        hidden: int = 30,
        *,
        learning_rate: float = 0.3,
        momentum: float = 0.9,
        initial_weight: float = 0.1,
        epochs: int = 200,
        random_state: int | np.random.RandomState | None = None,
    ) -> None:
        self.hidden = hidden
        self.learning_rate = learning_rate
        self.momentum = momentum
        self.initial_weight = initial_weight
        self.epochs = epochs
        self.random_state = random_state

    def fit(self, X: ArrayLike, y: ArrayLike) -> Self:  # noqa: N803 - scikit-learn's name
        """Forget, then teach every example `epochs` times.

        Args:
            X: Inputs, shape (examples, inputs).
            y: Targets, shape (examples,) or (examples, outputs).
        """
        rng = self._make_generator()
        inputs, targets = self._begin(X, y, rng)
        for _ in range(self.epochs):
            self._teach(inputs, targets, rng.permutation(len(inputs)))
        return self

    def partial_fit(self, X: ArrayLike, y: ArrayLike) -> Self:  # noqa: N803 - scikit-learn's name
        """Teach every example once, in order, on top of what was learned.

        Args:
            X: Inputs, shape (examples, inputs).
            y: Targets, shape (examples,) or (examples, outputs).
        """
        goes_on = hasattr(self, "network_")
        inputs, targets = self._go_on(X, y) if goes_on else self._begin(X, y, self._make_generator())
        self._teach(inputs, targets, np.arange(len(inputs)))
        return self

    def predict(self, X: ArrayLike) -> Matrix:  # noqa: N803 - scikit-learn's name
        """Return the answers, shape (examples,) or (examples, outputs).

        Args:
            X: Inputs, shape (examples, inputs).
        """
        check_is_fitted(self)
        inputs = self._scale_inputs(validate_data(self, X, reset=False, dtype=np.float64))
        scaled = np.array([self.network_.forward(row).copy() for row in inputs])
        low, span = self.target_range_[0], _find_span(self.target_range_)
        answers: Matrix = low + (scaled - _LOWEST) / (_HIGHEST - _LOWEST) * span
        return answers[:, 0] if self._flat else answers

    def _check_params(self) -> None:
        for name in ("hidden", "epochs"):
            if getattr(self, name) < 1:
                raise ValueError(f"{name} is {getattr(self, name)}; it must be at least 1.")
        for name in ("learning_rate", "initial_weight"):
            if not 0.0 < getattr(self, name) <= 10.0:
                raise ValueError(f"{name} is {getattr(self, name)}; it must be above 0 and at most 10.")
        if not 0.0 <= self.momentum < 1.0:
            raise ValueError(f"momentum is {self.momentum}; it must be at least 0 and below 1.")

    def _make_generator(self) -> np.random.Generator:
        return np.random.default_rng(check_random_state(self.random_state).randint(2**31 - 1))

    def _begin(self, X: ArrayLike, y: ArrayLike, rng: np.random.Generator) -> tuple[Matrix, Matrix]:  # noqa: N803
        self._check_params()
        inputs, targets = validate_data(self, X, y, dtype=np.float64, multi_output=True, y_numeric=True)
        self._flat = targets.ndim == 1
        targets = _make_columns(targets)
        self.input_range_, self.target_range_ = _find_range(inputs), _find_range(targets)
        self.network_ = Network(
            inputs.shape[1],
            self.hidden,
            targets.shape[1],
            learning_rate=self.learning_rate,
            momentum=self.momentum,
        )
        self.network_.randomize(rng, self.initial_weight)
        return inputs, targets

    def _go_on(self, X: ArrayLike, y: ArrayLike) -> tuple[Matrix, Matrix]:  # noqa: N803
        inputs, targets = validate_data(self, X, y, reset=False, dtype=np.float64, multi_output=True, y_numeric=True)
        targets = _make_columns(targets)
        if targets.shape[1] != self.target_range_.shape[1]:
            raise ValueError(f"y has {targets.shape[1]} outputs; it had {self.target_range_.shape[1]} before.")
        self.input_range_ = _find_range(np.vstack([self.input_range_, inputs]))
        self.target_range_ = _find_range(np.vstack([self.target_range_, targets]))
        return inputs, targets

    def _teach(self, inputs: Matrix, targets: Matrix, order: NDArray[np.int64]) -> None:
        scaled = self._scale_inputs(inputs)
        fractions = (targets - self.target_range_[0]) / _find_span(self.target_range_)
        wanted = _LOWEST + (_HIGHEST - _LOWEST) * fractions
        for index in order:
            self.network_.teach(scaled[index], wanted[index])

    def _scale_inputs(self, inputs: Matrix) -> Matrix:
        scaled: Matrix = 2.0 * (inputs - self.input_range_[0]) / _find_span(self.input_range_) - 1.0
        return scaled

    def __sklearn_tags__(self) -> Any:
        tags = super().__sklearn_tags__()
        tags.target_tags.multi_output = True
        return tags


def _make_columns(targets: Matrix) -> Matrix:
    columns: Matrix = np.asarray(targets, dtype=np.float64)
    return columns[:, None] if columns.ndim == 1 else columns


def _find_range(values: Matrix) -> Matrix:
    return np.array([values.min(axis=0), values.max(axis=0)])


def _find_span(limits: Matrix) -> Matrix:
    span: Matrix = limits[1] - limits[0]
    return np.where(span > 0, span, 1.0)
