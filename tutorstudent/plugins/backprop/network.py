"""Incremental backpropagation for one hidden layer (Thesis Appendix C), with momentum (Table 1).

Plain numpy, which knows neither parts nor robots. Every buffer is allocated once, so that `Network.forward` and
`Network.teach` allocate nothing.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
Matrix = NDArray[np.float64]

# Zero-dimensional arrays: a ufunc takes them in two thirds of the time that it needs for a Python float.
_HALF = np.array(0.5)
_ONE = np.array(1.0)
_COARSE = np.array(1e-290)


class Network:
    """A logistic network with one hidden layer and biases, taught one example at a time.

    A bias is the weight of an input that is always 1, the last column of each weight matrix. Momentum is carried over
    from one lesson to the next (Choice, see docs/fidelity.md). Appendix C's error of a hidden neuron is read as
    ``o_h (1 - o_h) * sum_k w_kh delta_k`` (Choice, see docs/fidelity.md).

    >>> network = Network(2, 3, 1, learning_rate=0.5, momentum=0.9)
    >>> network.randomize(np.random.default_rng(7), 0.1)
    >>> network.teach(np.array([0.0, 1.0]), np.array([1.0]), times=100)
    >>> bool(network.forward(np.array([0.0, 1.0]))[0] > 0.9)
    True

    Args:
        inputs: Number of inputs, at least 1.
        hidden: Number of hidden neurons, at least 1.
        outputs: Number of outputs, at least 1.
        learning_rate: Step along the error, above 0.
        momentum: Part of the last change that is made again, in [0, 1).
    """

    hidden_weights: Matrix
    """Weights into the hidden layer, shape (hidden, inputs + 1), the bias last; a live view."""
    output_weights: Matrix
    """Weights into the output layer, shape (outputs, hidden + 1), the bias last; a live view."""
    hidden_changes: Matrix
    """Last changes of the hidden weights, same shape; a live view."""
    output_changes: Matrix
    """Last changes of the output weights, same shape; a live view."""

    def __init__(self, inputs: int, hidden: int, outputs: int, *, learning_rate: float, momentum: float) -> None:
        self.sizes = (inputs, hidden, outputs)
        self.learning_rate = learning_rate
        self.momentum = momentum
        self._allocate()

    def randomize(self, rng: np.random.Generator, bound: float) -> None:
        """Draw every weight and bias uniformly from [-`bound`, `bound`] and forget the last changes."""
        self._weights[:] = rng.uniform(-bound, bound, self._weights.size)
        self._changes.fill(0.0)

    def arrays(self) -> dict[str, Matrix]:
        """Return the live weights and last changes by name: all that was learned."""
        names = ("hidden_weights", "output_weights", "hidden_changes", "output_changes")
        return {name: getattr(self, name) for name in names}

    def forward(self, inputs: Vector) -> Vector:
        """Return the outputs, shape (outputs,), each in [0, 1]; the next call overwrites them."""
        np.copyto(self._inputs, inputs)
        self._propagate()
        return self._outputs

    def teach(self, inputs: Vector, targets: Vector, times: int = 1) -> None:
        """Teach one example `times` times in a row (the teaching rate, Thesis 3.3.5).

        Args:
            inputs: What is seen, shape (inputs,).
            targets: What should be answered, shape (outputs,), each in [0, 1].
            times: Number of iterations.
        """
        np.copyto(self._inputs, inputs)
        for _ in range(times):
            self._propagate()
            self._find_errors(targets)
            self._change_weights()
        # Changes that fade would end as denormal numbers, ten times slower; this rounds them to a step far above those.
        np.add(self._changes, _COARSE, self._changes)
        np.subtract(self._changes, _COARSE, self._changes)

    def _allocate(self) -> None:
        inputs, hidden, outputs = self.sizes
        split, size = hidden * (inputs + 1), hidden * (inputs + 1) + outputs * (hidden + 1)
        self._weights, self._changes, self._gradient = np.zeros(size), np.zeros(size), np.empty(size)
        self.hidden_weights, self.output_weights = _split_matrices(self._weights, split, hidden, outputs)
        self.hidden_changes, self.output_changes = _split_matrices(self._changes, split, hidden, outputs)
        self._hidden_gradient, self._output_gradient = _split_matrices(self._gradient, split, hidden, outputs)
        self._biased_inputs, self._biased_hidden = np.ones(inputs + 1), np.ones(hidden + 1)
        self._inputs, self._hidden = self._biased_inputs[:-1], self._biased_hidden[:-1]
        self._outputs, self._output_errors, self._output_slopes = (
            np.empty(outputs),
            np.empty(outputs),
            np.empty(outputs),
        )
        self._biased_hidden_errors, self._hidden_slopes = np.empty(hidden + 1), np.empty(hidden + 1)
        # The same buffers as rows and columns, for the outer products delta_j x_ji.
        self._input_row, self._hidden_row = self._biased_inputs[None, :], self._biased_hidden[None, :]
        self._hidden_error_column = self._biased_hidden_errors[:-1, None]
        self._output_error_column = self._output_errors[:, None]
        self._rate, self._momentum = np.array(self.learning_rate), np.array(self.momentum)

    def _propagate(self) -> None:
        self.hidden_weights.dot(self._biased_inputs, self._hidden)
        _apply_logistic(self._hidden)
        self.output_weights.dot(self._biased_hidden, self._outputs)
        _apply_logistic(self._outputs)

    def _find_errors(self, targets: Vector) -> None:
        """Find the errors delta times the learning rate, which the errors of both layers are proportional to."""
        errors, slopes = self._output_errors, self._output_slopes
        np.subtract(targets, self._outputs, errors)
        np.multiply(errors, self._rate, errors)
        np.subtract(_ONE, self._outputs, slopes)
        np.multiply(slopes, self._outputs, slopes)
        np.multiply(errors, slopes, errors)
        # The bias "neuron" is always 1, so that its slope and error come out as 0.
        hidden_errors, slopes = self._biased_hidden_errors, self._hidden_slopes
        errors.dot(self.output_weights, hidden_errors)
        np.subtract(_ONE, self._biased_hidden, slopes)
        np.multiply(slopes, self._biased_hidden, slopes)
        np.multiply(hidden_errors, slopes, hidden_errors)

    def _change_weights(self) -> None:
        self._hidden_error_column.dot(self._input_row, self._hidden_gradient)
        self._output_error_column.dot(self._hidden_row, self._output_gradient)
        np.multiply(self._changes, self._momentum, self._changes)
        np.add(self._changes, self._gradient, self._changes)
        np.add(self._weights, self._changes, self._weights)

    def __getstate__(self) -> dict[str, Any]:
        """Return what a copy needs. The buffers are views of one another, which plain copying would tear apart."""
        return {
            "sizes": self.sizes,
            "learning_rate": self.learning_rate,
            "momentum": self.momentum,
            "weights": self._weights.copy(),
            "changes": self._changes.copy(),
        }

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.sizes, self.learning_rate, self.momentum = state["sizes"], state["learning_rate"], state["momentum"]
        self._allocate()
        np.copyto(self._weights, state["weights"])
        np.copyto(self._changes, state["changes"])


def _split_matrices(flat: Vector, split: int, hidden: int, outputs: int) -> tuple[Matrix, Matrix]:
    return flat[:split].reshape(hidden, -1), flat[split:].reshape(outputs, -1)


def _apply_logistic(net: Vector) -> None:
    """Turn net inputs into outputs in place. 1 / (1 + exp(-x)) = (1 + tanh(x / 2)) / 2, and tanh cannot overflow."""
    np.multiply(net, _HALF, net)
    np.tanh(net, net)
    np.multiply(net, _HALF, net)
    np.add(net, _HALF, net)
