"""Prototype 2A under every setting that agrees with prototype 2: what the thesis's rows let us predict about it.

Twenty-nine free numbers cannot be pinned by eight targets, so one frozen setting is one prediction among many. Here
prototype 2A runs once in each environment under each setting that a walk stood on; for each cell of the thesis this
gives an interval that holds 90 % of the predictions, weighted by how long the walks stood on the setting. A prediction
is one run, a cell of the thesis the mean of ten, so the intervals hold the noise of a run too.

A learning phase overrules ampbits of 0 and does nothing else (Thesis 3.3.4). So a longer phase is run by itself only
where the shortest one's run shows an ampbit of 0 in a decision that the longer phase would have overruled; without one
the two runs are the same, decision for decision.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from joblib import Parallel, delayed

import tutorstudent as ts
from tutorstudent_prototype2.calibration.agreement import ENVIRONMENTS
from tutorstudent_prototype2.calibration.trials import Counts, run_under
from tutorstudent_prototype2.calibration.walks import Look
from tutorstudent_prototype2.thesis import PIPELINES

COVERAGE = 0.9
PHASES = tuple(sorted(phase for phase in PIPELINES if phase is not None))


class Prediction(NamedTuple):
    """Prototype 2A in one environment under one setting."""

    walk: int
    round: int
    scene: str
    counts: dict[int, Counts]
    """By learning phase."""
    run: list[int]
    """Learning phases that were run; the others' runs are the same as the shortest one's."""


class Doubts(ts.Observer):
    """Collects the decisions that a longer learning phase would have overruled."""

    name = "doubts"

    def __init__(self, phase: int) -> None:
        super().__init__()
        self._phase = phase
        self.numbers: list[int] = []

    def observe(self, turn: ts.Turn[Any, Any], step: ts.Step[Any]) -> None:
        """Note a decision after the learning phase with an ampbit of 0."""
        number = turn.decision.moment.number
        if number >= self._phase and not turn.decision.selected.ampbit:
            self.numbers.append(number)

    def before(self, phase: int) -> bool:
        """Whether a phase of this length would have made a difference."""
        return bool(self.numbers) and self.numbers[0] < phase


class Interval(NamedTuple):
    """What the predictions say about a cell."""

    low: float
    median: float
    high: float

    @property
    def width(self) -> float:
        """How little is known."""
        return self.high - self.low


def predict(folder: Path, looks: Sequence[Look], workers: int) -> Iterator[Prediction]:
    """Run prototype 2A under every setting in every environment and yield each prediction as it is there.

    What the folder holds already is not run again. Walks take turns, so that a part of the runs is about all of them.
    """
    folder.mkdir(parents=True, exist_ok=True)
    in_turn = sorted(looks, key=lambda look: (look.round, look.walk))
    jobs = [(look, scene) for look in in_turn for scene in ENVIRONMENTS]
    parallel = Parallel(n_jobs=workers, return_as="generator_unordered", batch_size=1)
    yield from parallel(delayed(_keep)(folder, *job) for job in jobs)


def run_look(look: Look, scene: str) -> Prediction:
    """Run prototype 2A with the shortest learning phase, and with the longer ones where they differ."""
    doubts = Doubts(PHASES[0])
    counts = {PHASES[0]: run_under(look.setting(), scene, look.seed, PIPELINES[PHASES[0]], observers=[doubts])}
    longer = [phase for phase in PHASES[1:] if doubts.before(phase)]
    for phase in PHASES[1:]:
        counts[phase] = (
            run_under(look.setting(), scene, look.seed, PIPELINES[phase]) if phase in longer else counts[PHASES[0]]
        )
    return Prediction(look.walk, look.round, scene, counts, [PHASES[0], *longer])


def keep_predictions(folder: Path, predictions: Sequence[Prediction]) -> None:
    """Put predictions of earlier days where `predict` finds them."""
    folder.mkdir(parents=True, exist_ok=True)
    for item in predictions:
        _file(folder, item.scene, item).write_text(_text(item), encoding="utf-8")


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
) -> dict[tuple[str, int], Interval]:
    """Return the interval of every environment and learning phase.

    Args:
        predictions: The runs.
        stays: For how many rounds a walk stood on a setting, by walk and round.
        measure: A field of `Counts`, such as ``attractors``.
    """
    found = {}
    for scene in sorted({item.scene for item in predictions}):
        there = [item for item in predictions if item.scene == scene]
        weights = [float(stays[item.walk, item.round]) for item in there]
        for phase in PHASES:
            values = [float(getattr(item.counts[phase], measure)) for item in there]
            found[scene, phase] = interval(values, weights)
    return found


def _keep(folder: Path, look: Look, scene: str) -> Prediction:
    path = _file(folder, scene, look)
    if path.exists():
        return _from_text(path.read_text(encoding="utf-8"))
    prediction = run_look(look, scene)
    partial = path.with_suffix(f".{os.getpid()}")
    partial.write_text(_text(prediction), encoding="utf-8")
    partial.replace(path)
    return prediction


def _file(folder: Path, scene: str, look: Look | Prediction) -> Path:
    return folder / f"{scene}-round-{look.round:04}-walk-{look.walk:02}.json"


def _text(prediction: Prediction) -> str:
    counts = {phase: counts._asdict() for phase, counts in prediction.counts.items()}
    return json.dumps(prediction._asdict() | {"counts": counts}) + "\n"


def _from_text(text: str) -> Prediction:
    data = json.loads(text)
    counts = {int(phase): Counts(**counts) for phase, counts in data["counts"].items()}
    return Prediction(**data | {"counts": counts})
