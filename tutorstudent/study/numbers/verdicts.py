"""Whether a variant does more harm than the tutor alone: a test of non-inferiority with a stated margin."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from typing import NamedTuple

from tutorstudent.study.numbers.declared import choose_harm, find_measures
from tutorstudent.study.numbers.intervals import Interval
from tutorstudent.study.numbers.pairs import Difference, make_pairs
from tutorstudent.study.numbers.quantities import DECISIONS, Quantity
from tutorstudent.study.plans.plan import Environment, Variant
from tutorstudent.study.runs.results import Run, Study

MARGIN = 10.0
"""Harmed decisions in 10,000: the 0.1 % below which the thesis finds collisions (4.4). Choice: see docs/fidelity.md."""
ONE_SIDED = 0.90
"""Confidence of an interval whose bounds are one-sided ones for 95 %."""
RULE_OF_THREE = 3.0
"""A rate above 3 / n is unlikely (5 %) where n decisions saw nothing; so n must be at least 3 / margin."""


class Verdict(StrEnum):
    """What a test of non-inferiority says."""

    NOT_WORSE = "not worse"
    """By more than the margin, that is; the upper bound lies below it."""
    WORSE = "worse"
    """By more than the margin: the lower bound lies above it."""
    UNDECIDED = "undecided"


class Judgement(NamedTuple):
    """One variant against the tutor alone."""

    variant: str
    control: bool
    harm: float
    """Mean of all its runs, harmed decisions in 10,000."""
    difference: Difference | None
    """Without a pair there is none. Its interval has one-sided bounds for 95 %."""
    verdict: Verdict


def make_harm_rate(study: Study, environment: Environment) -> Quantity:
    """Return what is judged."""
    return Quantity(choose_harm(find_measures(environment, study.runs)), DECISIONS)


def judge_variants(study: Study, environment: Environment, margin: float = MARGIN) -> list[Judgement]:
    """Return whether each variant that has runs does more harm than the tutor alone; none without a tutor alone.

    Args:
        study: Its runs are paired by seed.
        environment: Of the study.
        margin: How much more does not matter, harmed decisions in 10,000.
    """
    if not environment.reference:
        return []
    measure = make_harm_rate(study, environment)
    alone = study.of(environment.name, environment.reference)
    others = [variant for variant in environment.variants if variant.name != environment.reference]
    made = [_judge(variant, study.of(environment.name, variant.name), alone, measure, margin) for variant in others]
    return [item for item in made if item is not None]


def _judge(
    variant: Variant, runs: Sequence[Run], alone: Sequence[Run], measure: Quantity, margin: float
) -> Judgement | None:
    ours = measure.read_by_seed(runs)
    if not ours:
        return None
    mean, pairs = sum(ours.values()) / len(ours), make_pairs(ours, measure.read_by_seed(alone))
    if pairs is None:
        return Judgement(variant.name, variant.control, mean, None, Verdict.UNDECIDED)
    difference = pairs.difference(ONE_SIDED)
    decisions = sum(run.summary[DECISIONS.key] for run in runs if run.seed in pairs.seeds)
    return Judgement(
        variant.name, variant.control, mean, difference, reach_verdict(difference.interval, decisions, margin)
    )


def reach_verdict(interval: Interval | None, decisions: float, margin: float = MARGIN) -> Verdict:
    """Return what an interval says about a margin.

    Args:
        interval: Of the difference, with one-sided bounds; None if there is none.
        decisions: How many were seen; with too few to see a rate of the margin at all nothing is decided.
        margin: In the unit of the interval, harmed decisions in 10,000.

    >>> str(reach_verdict(Interval(-2.0, 4.0), 30_000)), str(reach_verdict(Interval(8.0, 12.0), 30_000))
    ('not worse', 'undecided')
    """
    if interval is None or decisions * margin < RULE_OF_THREE * DECISIONS.amount:
        return Verdict.UNDECIDED
    if interval.high < margin:
        return Verdict.NOT_WORSE
    return Verdict.WORSE if interval.low > margin else Verdict.UNDECIDED
