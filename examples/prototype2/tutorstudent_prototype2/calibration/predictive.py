"""Prototype 2A under every setting that agrees with prototype 2: what the thesis's rows let us predict about it.

Twenty-nine free numbers cannot be pinned by eight targets, so one frozen setting is one prediction among many. Here
prototype 2A runs once in each environment under each setting that a walk stood on; for each cell of the thesis this
gives an interval that holds 90 % of the predictions, weighted by how long the walks stood on the setting. A prediction
is one run, a cell of the thesis the mean of ten, so the intervals hold the noise of a run too.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from joblib import Parallel, delayed

from tutorstudent_prototype2.calibration.agreement import ENVIRONMENTS
from tutorstudent_prototype2.calibration.trials import Counts, run_under
from tutorstudent_prototype2.calibration.walks import Look

COVERAGE = 0.9
LEARNERS = ("prototype2a", "prototype2a-5000", "prototype2a-7500")


class Prediction(NamedTuple):
    """One run of prototype 2A under one setting."""

    walk: int
    round: int
    scene: str
    learner: str
    counts: Counts


class Interval(NamedTuple):
    """What the predictions say about a cell."""

    low: float
    median: float
    high: float

    @property
    def width(self) -> float:
        """How little is known."""
        return self.high - self.low


def predict(folder: Path, looks: Sequence[Look], learners: Sequence[str], workers: int) -> Iterator[Prediction]:
    """Run the learners under every setting in every environment and yield each run as it ends.

    What the folder holds already is not run again. Walks take turns, so that a part of the runs is about all of them.
    """
    folder.mkdir(parents=True, exist_ok=True)
    in_turn = sorted(looks, key=lambda look: (look.round, look.walk))
    jobs = [(look, scene, learner) for learner in learners for look in in_turn for scene in ENVIRONMENTS]
    parallel = Parallel(n_jobs=workers, return_as="generator_unordered", batch_size=1)
    yield from parallel(delayed(_predict)(folder, *job) for job in jobs)


def keep_predictions(folder: Path, predictions: Sequence[Prediction]) -> None:
    """Put predictions of earlier days where `predict` finds them."""
    folder.mkdir(parents=True, exist_ok=True)
    for item in predictions:
        _file(folder, item.learner, item.scene, item).write_text(_text(item), encoding="utf-8")


def interval(values: Sequence[float], weights: Sequence[float]) -> Interval:
    """Return the middle `COVERAGE` of weighted values.

    >>> interval([1.0, 2.0, 3.0], [1.0, 8.0, 1.0])
    Interval(low=1.0, median=2.0, high=3.0)
    """
    order = np.argsort(values)
    reached = np.cumsum(np.asarray(weights, dtype=np.float64)[order])
    tail = (1 - COVERAGE) / 2
    places = np.searchsorted(reached, np.array([tail, 0.5, 1 - tail]) * reached[-1])
    low, median, high = np.asarray(values, dtype=np.float64)[order][places]
    return Interval(float(low), float(median), float(high))


def save_predictions(path: Path, predictions: Sequence[Prediction]) -> None:
    """Write one line of JSON for each."""
    path.write_text("".join(_text(prediction) for prediction in sorted(predictions)), encoding="utf-8")


def load_predictions(path: Path) -> list[Prediction]:
    """Read what `save_predictions` wrote."""
    return [_from_text(line) for line in path.read_text(encoding="utf-8").splitlines()]


def cells(
    predictions: Sequence[Prediction], stays: Mapping[tuple[int, int], int], measure: str
) -> dict[tuple[str, str], Interval]:
    """Return the interval of every environment and learner.

    Args:
        predictions: The runs.
        stays: For how many rounds a walk stood on a setting, by walk and round.
        measure: A field of `Counts`, such as ``attractors``.
    """
    found = {}
    for scene, learner in sorted({(item.scene, item.learner) for item in predictions}):
        there = [item for item in predictions if (item.scene, item.learner) == (scene, learner)]
        values = [float(getattr(item.counts, measure)) for item in there]
        found[scene, learner] = interval(values, [float(stays[item.walk, item.round]) for item in there])
    return found


def _predict(folder: Path, look: Look, scene: str, learner: str) -> Prediction:
    path = _file(folder, learner, scene, look)
    if path.exists():
        return _from_text(path.read_text(encoding="utf-8"))
    counts = run_under(look.setting(), scene, look.seed, pipeline=learner)
    prediction = Prediction(look.walk, look.round, scene, learner, counts)
    partial = path.with_suffix(f".{os.getpid()}")
    partial.write_text(_text(prediction), encoding="utf-8")
    partial.replace(path)
    return prediction


def _file(folder: Path, learner: str, scene: str, look: Look | Prediction) -> Path:
    return folder / f"{learner}-{scene}-round-{look.round:04}-walk-{look.walk:02}.json"


def _text(prediction: Prediction) -> str:
    return json.dumps(prediction._asdict() | {"counts": prediction.counts._asdict()}) + "\n"


def _from_text(text: str) -> Prediction:
    data = json.loads(text)
    return Prediction(**data | {"counts": Counts(**data["counts"])})
