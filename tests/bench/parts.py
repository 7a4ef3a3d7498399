"""What the engine and the learners cost without a world."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np

import tutorstudent as ts
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.plugins.backprop.network import Network
from tutorstudent.sims.pioneer.types import Blob, DriveAction, PioneerState

DECISIONS = 2000
SILENT = "student: silent\nselector: modifier\namplifier: never\nconditions: [bumped]\non_incident: raise\n"
FULL = (
    "tutor: prototype2\nstudent: {use: backprop, encoder: prototype2-bits}\nconditions: [bumped]\non_incident: raise\n"
)
Work = dict[str, tuple[Callable[[], object], int]]


class Fixed(ts.Tutor[Any, DriveAction]):
    """Always the same action, at no cost."""

    name = "fixed"
    action = DriveAction

    def setup(self) -> None:
        self._forward = DriveAction(kind="forward", translation=0.2)

    def act(self, state: Any) -> DriveAction:
        return self._forward


def engine(text: str, **given: Any) -> Engine[Any, Any, Any]:
    """Return the engine of a pipeline text."""
    return Pipeline(parse_yaml(text, "bench"), Registry.discover()).engine(**given)


def states(count: int) -> list[PioneerState]:
    """Return made-up sensor states, as varied as a drive through a cave."""
    rng = np.random.default_rng(1)
    found = []
    for i in range(count):
        blobs = (Blob("red", rng.uniform(-1, 1), rng.uniform(0.5, 5), 0.1),) if i % 3 == 0 else ()
        found.append(PioneerState(rng.uniform(0.2, 5.0, 16), blobs, bool(i % 97 == 0)))
    return found


def loop(step: Callable[[Any], object], inputs: list[Any]) -> Callable[[], object]:
    """Return a call that steps through all inputs."""

    def call() -> None:
        for item in inputs:
            step(item)

    return call


def parts_work() -> Work:
    """Return the timed work without a world."""
    inputs = states(DECISIONS)
    rng = np.random.default_rng(2)
    network = Network(14, 30, 7, learning_rate=0.3, momentum=0.9)
    network.randomize(rng, 0.1)
    x, target = rng.integers(0, 2, 14).astype(float), rng.integers(0, 2, 7).astype(float)
    tutor = Pipeline(parse_yaml(FULL, "bench")).engine().tutor
    silent = ts.wrap(_half, action=ts.scalar(-1, 1), student="silent", amplifier="never")
    readme = ts.wrap(_half, action=ts.scalar(-1, 1), condition=lambda y: y > 80)
    fixed = engine(SILENT, tutor=Fixed())
    return {
        "one validated action": (loop(lambda _: DriveAction(kind="forward", translation=0.2), inputs), DECISIONS),
        "engine, silent student": (loop(fixed.step, inputs), DECISIONS),
        "the controller that is wrapped, alone": (loop(_half, [0.3] * DECISIONS), DECISIONS),
        "wrap, silent student": (loop(silent.step, [0.3] * DECISIONS), DECISIONS),
        "wrap as in the README (default student, one condition)": (loop(readme.step, [0.3] * DECISIONS), DECISIONS),
        "prototype 2, acting": (loop(tutor.act, inputs), DECISIONS),
        "whole cycle without world, 14-30-7, teaching rate 3": (loop(engine(FULL).step, inputs), DECISIONS),
        "network, forward": (loop(lambda _: network.forward(x), inputs), DECISIONS),
        "network, teaching x3": (loop(lambda _: network.teach(x, target, 3), inputs), DECISIONS),
        "MLPRegressor.partial_fit x3": (_sklearn(x, target), 100),
    }


def _half(_: float) -> float:
    return 0.5


def _sklearn(x: Any, target: Any) -> Callable[[], object]:
    from sklearn.neural_network import MLPRegressor

    rows, targets = x.reshape(1, -1), target.reshape(1, -1)
    estimator = MLPRegressor(hidden_layer_sizes=(30,), activation="logistic", solver="sgd", momentum=0.9)

    def call() -> None:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for _ in range(300):
                estimator.partial_fit(rows, targets)

    return call
