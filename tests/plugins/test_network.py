"""The network does what Thesis Appendix C says, plus momentum (Table 1)."""

from __future__ import annotations

import copy
import math
import tracemalloc

import numpy as np
import pytest

from tutorstudent.plugins.backprop.network import Network

SIZES = [(14, 30, 7), (1, 1, 1), (3, 2, 5), (2, 40, 1)]


class Reference:
    """Appendix C, neuron by neuron and weight by weight, with plain floats. ``w[j][i]`` leads from i to j."""

    def __init__(self, network: Network) -> None:
        self.eta, self.alpha = network.learning_rate, network.momentum
        self.hidden, self.output = network.hidden_weights.tolist(), network.output_weights.tolist()
        self.hidden_last, self.output_last = network.hidden_changes.tolist(), network.output_changes.tolist()

    def forward(self, x: list[float]) -> tuple[list[float], list[float]]:
        o_hidden = [sigmoid(sum(w * x_i for w, x_i in zip(row, [*x, 1.0], strict=True))) for row in self.hidden]
        o = [sigmoid(sum(w * o_h for w, o_h in zip(row, [*o_hidden, 1.0], strict=True))) for row in self.output]
        return o_hidden, o

    def teach(self, x: list[float], t: list[float]) -> None:
        o_hidden, o = self.forward(x)
        delta = [o_k * (1 - o_k) * (t_k - o_k) for o_k, t_k in zip(o, t, strict=True)]
        delta_hidden = [
            o_h * (1 - o_h) * sum(self.output[k][h] * delta[k] for k in range(len(o))) for h, o_h in enumerate(o_hidden)
        ]
        self.change(self.output, self.output_last, delta, [*o_hidden, 1.0])
        self.change(self.hidden, self.hidden_last, delta_hidden, [*x, 1.0])

    def change(
        self, weights: list[list[float]], last: list[list[float]], delta: list[float], inputs: list[float]
    ) -> None:
        for j, delta_j in enumerate(delta):
            for i, x_ji in enumerate(inputs):
                last[j][i] = self.eta * delta_j * x_ji + self.alpha * last[j][i]
                weights[j][i] += last[j][i]


def sigmoid(net: float) -> float:
    return 1.0 / (1.0 + math.exp(-net))


def network_of(sizes: tuple[int, int, int] = (14, 30, 7), momentum: float = 0.9, seed: int = 7) -> Network:
    network = Network(*sizes, learning_rate=0.3, momentum=momentum)
    network.randomize(np.random.default_rng(seed), 0.5)
    return network


def example(rng: np.random.Generator, sizes: tuple[int, int, int]) -> tuple[np.ndarray, np.ndarray]:
    return rng.normal(size=sizes[0]), rng.random(sizes[2])


def assert_equal_weights(expected: Reference, actual: Network) -> None:
    np.testing.assert_allclose(actual.hidden_weights, expected.hidden, rtol=0, atol=1e-12)
    np.testing.assert_allclose(actual.output_weights, expected.output, rtol=0, atol=1e-12)
    np.testing.assert_allclose(actual.hidden_changes, expected.hidden_last, rtol=0, atol=1e-12)
    np.testing.assert_allclose(actual.output_changes, expected.output_last, rtol=0, atol=1e-12)


@pytest.mark.parametrize("momentum", [0.0, 0.9])
@pytest.mark.parametrize("sizes", SIZES)
def test_many_lessons_equal_appendix_c_written_out_weight_by_weight(
    sizes: tuple[int, int, int], momentum: float
) -> None:
    network, rng = network_of(sizes, momentum), np.random.default_rng(1)
    reference = Reference(network)
    for _ in range(150):
        x, t = example(rng, sizes)
        np.testing.assert_allclose(network.forward(x), reference.forward(x.tolist())[1], rtol=0, atol=1e-12)
        network.teach(x, t)
        reference.teach(x.tolist(), t.tolist())
    assert_equal_weights(reference, network)


@pytest.mark.parametrize("sizes", [(3, 2, 5), (4, 6, 3)])
def test_one_step_without_momentum_follows_the_gradient_of_half_the_squared_error(sizes: tuple[int, int, int]) -> None:
    network = network_of(sizes, momentum=0.0)
    x, t = example(np.random.default_rng(3), sizes)
    expected = {name: -0.3 * numeric_gradient(network, name, x, t) for name in ("hidden_weights", "output_weights")}
    before = {name: array.copy() for name, array in network.arrays().items()}
    network.teach(x, t)
    for name, step in expected.items():
        np.testing.assert_allclose(network.arrays()[name] - before[name], step, rtol=0, atol=1e-10)


def numeric_gradient(network: Network, name: str, x: np.ndarray, t: np.ndarray) -> np.ndarray:
    weights, gradient, h = network.arrays()[name], np.empty_like(network.arrays()[name]), 1e-5
    for index in np.ndindex(weights.shape):
        kept = weights[index]
        losses = []
        for weights[index] in (kept + h, kept - h):
            losses.append(0.5 * float(np.sum((t - network.forward(x)) ** 2)))
        weights[index] = kept
        gradient[index] = (losses[0] - losses[1]) / (2 * h)
    return gradient


def test_momentum_is_carried_over_from_one_lesson_to_the_next() -> None:
    network, rng = network_of(), np.random.default_rng(5)
    network.teach(*example(rng, network.sizes))
    carried, forgetful = copy.deepcopy(network), copy.deepcopy(network)
    forgetful.hidden_changes.fill(0.0)
    forgetful.output_changes.fill(0.0)
    last = network.output_changes.copy()
    x, t = example(rng, network.sizes)
    carried.teach(x, t)
    forgetful.teach(x, t)
    np.testing.assert_allclose(carried.output_weights - forgetful.output_weights, 0.9 * last, rtol=0, atol=1e-15)


@pytest.mark.parametrize("times", [1, 2, 3, 10])
def test_teaching_n_times_equals_teaching_once_n_times(times: int) -> None:
    at_once, one_by_one, rng = network_of(), network_of(), np.random.default_rng(9)
    for _ in range(20):
        x, t = example(rng, at_once.sizes)
        at_once.teach(x, t, times)
        for _ in range(times):
            one_by_one.teach(x, t)
    assert one_by_one.hidden_weights.tobytes() == at_once.hidden_weights.tobytes()
    assert one_by_one.output_weights.tobytes() == at_once.output_weights.tobytes()


def test_initial_weights_and_biases_fill_the_interval_and_the_same_seed_repeats_them() -> None:
    network = network_of(seed=3)
    drawn = np.concatenate([network.hidden_weights.ravel(), network.output_weights.ravel()])
    assert drawn.shape == (30 * 15 + 7 * 31,)
    assert 0.49 < np.abs(drawn).max() <= 0.5
    assert abs(drawn.mean()) < 0.05
    assert network_of(seed=3).hidden_weights.tobytes() == network.hidden_weights.tobytes()
    assert network_of(seed=4).hidden_weights.tobytes() != network.hidden_weights.tobytes()


def test_drawing_weights_again_forgets_the_momentum() -> None:
    network = network_of()
    network.teach(np.ones(14), np.zeros(7))
    network.randomize(np.random.default_rng(0), 0.1)
    assert 0.0 == np.abs(network.hidden_changes).max() == np.abs(network.output_changes).max()


@pytest.mark.parametrize("size", [1e3, 1e100, 1e300])
def test_net_inputs_of_any_size_saturate_without_overflow(size: float) -> None:
    network = network_of((2, 3, 2))
    network.hidden_weights[:] = [[1, 0, 0], [-1, 0, 0], [0, 0, 0]]
    network.output_weights[:] = [[0, 0, 0, size], [0, 0, 0, -size]]
    assert network.forward(np.array([size, size])).tolist() == [1.0, 0.0]
    network.teach(np.array([size, size]), np.array([0.0, 1.0]))
    assert np.isfinite(network.hidden_weights).all()


def test_small_outputs_are_those_of_the_logistic_function() -> None:
    network = Network(1, 1, 1, learning_rate=0.3, momentum=0.9)
    for net in np.linspace(-30, 30, 61):
        network.output_weights[:] = [[0.0, net]]
        assert sigmoid(float(net)) == pytest.approx(network.forward(np.zeros(1))[0], abs=1e-15)


def test_xor_is_learned() -> None:
    network, table = network_of((2, 8, 1)), {(0, 0): 0, (0, 1): 1, (1, 0): 1, (1, 1): 0}
    for _ in range(2000):
        for x, t in table.items():
            network.teach(np.array(x, dtype=float), np.array([float(t)]))
    assert table == {x: round(float(network.forward(np.array(x, dtype=float))[0])) for x in table}


def test_fading_changes_never_become_denormal_numbers() -> None:
    network, tiny = network_of((2, 2, 1)), np.finfo(np.float64).tiny
    network.teach(np.array([1.0, 1.0]), np.array([1.0]))
    for _ in range(8000):  # the first input is 0 from now on: its changes fade by 0.9 each time, 0.9**8000 = 1e-366
        network.teach(np.array([0.0, 1.0]), np.array([1.0]))
    changes = np.abs(network.hidden_changes)
    assert changes[:, 0].max() < 1e-300
    assert not ((changes > 0) & (changes < tiny)).any()


def test_a_copy_learns_the_same_and_shares_nothing() -> None:
    network, rng = network_of(), np.random.default_rng(2)
    network.teach(*example(rng, network.sizes))
    twin = copy.deepcopy(network)
    x, t = example(rng, network.sizes)
    network.teach(x, t, 3)
    assert twin.hidden_weights.tobytes() != network.hidden_weights.tobytes()
    twin.teach(x, t, 3)
    assert {k: v.tobytes() for k, v in network.arrays().items()} == {k: v.tobytes() for k, v in twin.arrays().items()}


def test_forward_and_teach_allocate_nothing_that_stays() -> None:
    network, (x, t) = network_of(), example(np.random.default_rng(0), (14, 30, 7))
    network.teach(x, t, 3)
    tracemalloc.start()
    try:
        before = tracemalloc.get_traced_memory()[0]
        tracemalloc.reset_peak()
        for _ in range(100):
            network.forward(x)
            network.teach(x, t, 3)
        now, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert now - before < 1000
    assert peak - before < 30 * 15 * 8  # not even one temporary of the hidden weights' size


def test_inputs_and_targets_are_left_alone() -> None:
    network, (x, t) = network_of(), example(np.random.default_rng(0), (14, 30, 7))
    x.setflags(write=False)
    t.setflags(write=False)
    network.forward(x)
    network.teach(x, t, 3)
