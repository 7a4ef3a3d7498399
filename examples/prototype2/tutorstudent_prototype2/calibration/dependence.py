"""How what a controller does depends on the free choices: rank correlations over the settings that agree.

A correlation says which choice matters, not how much; choices that agree with prototype 2 only together share theirs.
Settings of one walk are neighbours, so that there are fewer independent ones than settings.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from scipy import stats

from tutorstudent_prototype2.calibration.choices import CHOICES
from tutorstudent_prototype2.calibration.predictive import PHASES, Prediction
from tutorstudent_prototype2.calibration.trials import Counts
from tutorstudent_prototype2.calibration.walks import Look


class Case(NamedTuple):
    """What one controller did under one setting."""

    choices: Mapping[str, float]
    counts: Counts


def correlations(cases: Sequence[Case], measure: str) -> dict[str, float]:
    """Return Spearman's rank correlation of every choice with a field of `Counts`; NaN where either never varies."""
    values = [float(getattr(case.counts, measure)) for case in cases]
    return {name: _spearman([case.choices[name] for case in cases], values) for name in CHOICES}


def tutor_cases(looks: Sequence[Look], scene: str) -> list[Case]:
    """Return prototype 2's runs under the settings that agree."""
    return [Case(look.choices, look.counts[scene]) for look in looks if look.agrees]


def learner_cases(looks: Sequence[Look], predictions: Sequence[Prediction], scene: str) -> list[Case]:
    """Return prototype 2A's runs with the shortest learning phase."""
    choices = {(look.walk, look.round): look.choices for look in looks}
    there = [item for item in predictions if item.scene == scene]
    return [Case(choices[item.walk, item.round], item.counts[PHASES[0]]) for item in there]


def _spearman(choices: Sequence[float], values: Sequence[float]) -> float:
    if len(set(choices)) < 2 or len(set(values)) < 2:
        return math.nan
    return float(stats.spearmanr(choices, values).statistic)
