"""What the calibration found, as Markdown."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np

from tutorstudent_prototype2.calibration.agreement import ENVIRONMENTS
from tutorstudent_prototype2.calibration.choices import CHOICES
from tutorstudent_prototype2.calibration.dependence import correlations, learner_cases, tutor_cases
from tutorstudent_prototype2.calibration.freezing import Candidate, load_candidates
from tutorstudent_prototype2.calibration.predictive import (
    COVERAGE,
    PHASES,
    Prediction,
    cells,
    interval,
    load_predictions,
)
from tutorstudent_prototype2.calibration.walks import Look, load_looks, stays
from tutorstudent_prototype2.thesis import rows

MEASURES = {"attractors": "attractors", "collided": "collisions"}
"""Names of `Counts` and of the thesis's rows."""


def describe(looks: Path, candidates: Path, predictions: Path) -> Iterator[str]:
    """Yield lines about the files that exist."""
    seen = load_looks(looks)
    tried = load_candidates(candidates) if candidates.exists() else []
    yield from _walks(seen, tried[0].look.choices if tried else {})
    if tried:
        yield from _candidates(tried)
    if predictions.exists():
        told = load_predictions(predictions)
        yield from _predictive(seen, told)
        yield from _gains(seen, told)
        yield from _dependence(seen, told)


def _walks(looks: Sequence[Look], frozen: Mapping[str, float]) -> Iterator[str]:
    stood = stays(looks)
    ended = Counter(list(look.counts)[-1] for look in looks if not look.agrees)
    against = ", ".join(f"{scene} {count}" for scene, count in ended.most_common())
    yield f"{len(looks)} settings looked at, {len(stood)} agree with prototype 2's rows. Spoken against by: {against}."
    yield ""
    yield "| free choice | bounds | frozen | middle 90 % of the settings that agree (median) |"
    yield "|---|---|---:|---|"
    for name, choice in CHOICES.items():
        found = interval([look.choices[name] for look, _ in stood], [rounds for _, rounds in stood])
        agreeing = f"{found.low:.3g} to {found.high:.3g} ({found.median:.3g})"
        yield f"| {name} | {choice.low:g} to {choice.high:g} | {frozen.get(name, math.nan):.3g} | {agreeing} |"
    yield ""


def _candidates(candidates: Sequence[Candidate]) -> Iterator[str]:
    yield "| candidate | misfit | " + " | ".join(f"{scene}: attractors, collisions" for scene in ENVIRONMENTS) + " |"
    yield "|---|---:|" + "---:|" * len(ENVIRONMENTS)
    for candidate in candidates:
        means = [_means(candidate, scene) for scene in ENVIRONMENTS]
        name = f"walk {candidate.look.walk}, round {candidate.look.round}"
        yield f"| {name} | {candidate.misfit:.2f} | " + " | ".join(f"{a:.1f}, {c:.1f}" for a, c in means) + " |"
    yield ""


def _means(candidate: Candidate, scene: str) -> tuple[float, float]:
    runs = candidate.runs[scene]
    return float(np.mean([run.attractors for run in runs])), float(np.mean([run.collided for run in runs]))


def _predictive(looks: Sequence[Look], predictions: Sequence[Prediction]) -> Iterator[str]:
    weights = {(look.walk, look.round): rounds for look, rounds in stays(looks)}
    longer = (len(PHASES) - 1) * len(predictions)
    own = sum(len(item.run) - 1 for item in predictions)
    yield (
        f"Prototype 2A under each of {len({item[:2] for item in predictions})} settings that agree, one run in each "
        f"environment. Of the {longer} with a longer learning phase {own} differ from the shortest one's in any "
        "decision and were run by themselves."
    )
    for measure, word in MEASURES.items():
        found = cells(predictions, weights, measure)
        yield ""
        yield f"| {word} | learning phase | thesis | {100 * COVERAGE:.0f} % of predictions | width | median | inside |"
        yield "|---|---:|---:|---:|---:|---:|---|"
        for row in rows():
            if row.learning_phase is not None and (row.environment, row.learning_phase) in found:
                between, mean = found[row.environment, row.learning_phase], float(getattr(row, word))
                inside = "yes" if between.low <= mean <= between.high else "no"
                yield (
                    f"| {row.environment} | {row.learning_phase} | {mean:g} | {between.low:g} to {between.high:g} | "
                    f"{between.width:g} | {between.median:g} | {inside} |"
                )
    yield ""


def _gains(looks: Sequence[Look], predictions: Sequence[Prediction]) -> Iterator[str]:
    stood = {(look.walk, look.round): (look, rounds) for look, rounds in stays(looks)}
    yield "Where prototype 2A finds more attractors than prototype 2 did under the same setting and seed:"
    yield ""
    yield "| environment | share of the settings, % |"
    yield "|---|---:|"
    for scene in ENVIRONMENTS:
        there = [(item, *stood[item.walk, item.round]) for item in predictions if item.scene == scene]
        more = [item.counts[PHASES[0]].attractors > look.counts[scene].attractors for item, look, _ in there]
        yield f"| {scene} | {100 * np.average(more, weights=[rounds for *_, rounds in there]):.0f} |"
    yield ""


def _dependence(looks: Sequence[Look], predictions: Sequence[Prediction]) -> Iterator[str]:
    for measure, word in MEASURES.items():
        pairs = [
            (
                correlations(tutor_cases(looks, scene), measure),
                correlations(learner_cases(looks, predictions, scene), measure),
            )
            for scene in ENVIRONMENTS
        ]
        yield f"Rank correlations with {word}: prototype 2 / prototype 2A (learning phase {PHASES[0]})."
        yield ""
        yield "| free choice | " + " | ".join(ENVIRONMENTS) + " |"
        yield "|---|" + "---:|" * len(ENVIRONMENTS)
        for name in CHOICES:
            shown = (f"{_add_sign(tutor[name])} / {_add_sign(learner[name])}" for tutor, learner in pairs)
            yield f"| {name} | " + " | ".join(shown) + " |"
        yield ""


def _add_sign(value: float) -> str:
    return "-" if math.isnan(value) else f"{value:+.2f}"
