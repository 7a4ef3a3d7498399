"""Which variant is held against which, and what comes out: paired differences in families of tests."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from tutorstudent.study.numbers.declared import choose_harm, find_measures
from tutorstudent.study.numbers.pairs import Difference, Improvement, make_pairs
from tutorstudent.study.numbers.quantities import WAY, Quantity
from tutorstudent.study.numbers.significance import holm, sign_flip
from tutorstudent.study.plans.plan import Environment, Variant
from tutorstudent.study.runs.results import Run, Study


class Comparison(NamedTuple):
    """One variant against another, in one number."""

    environment: str
    variant: Variant
    against: str
    quantity: Quantity
    difference: Difference
    correlation: float | None
    improvement: Improvement | None
    """None where neither more nor less is better."""
    p: float | None
    """None where nothing is tested: nothing is claimed of controls or where nothing is better, and one pair says
    nothing."""
    p_holm: float | None
    """Corrected for all tests of its family."""


class Family(NamedTuple):
    """All comparisons of one kind over all environments; their p values are corrected together."""

    title: str
    comparisons: tuple[Comparison, ...]

    @property
    def tests(self) -> int:
        """How many of the comparisons are tested."""
        return sum(item.p is not None for item in self.comparisons)


class Contest(NamedTuple):
    """One variant against another, in one environment."""

    environment: str
    variant: Variant
    against: str


def make_families(study: Study) -> list[Family]:
    """Return what can be compared to the tutor alone and to the controls.

    What was found and what it cost are families of their own, so that no other measure changes their p values.
    """
    rivals = {"Differences to the tutor alone": pair_with_tutor, "Differences to the controls": pair_with_controls}
    made: dict[str, list[Comparison]] = {}
    for title, contests in rivals.items():
        for environment in study.plan.environments:
            runs = [run for run in study.runs if run.environment == environment.name]
            for about, quantities in list_measures(environment, runs).items():
                judged = [item for item in quantities if item.better or contests is pair_with_tutor]
                held = _compare_all(study, contests(environment), judged)
                made.setdefault(f"{title}: {about}", []).extend(held)
    return [Family(title, correct(found)) for title, found in made.items() if found]


def list_measures(environment: Environment, runs: Sequence[Run]) -> dict[str, list[Quantity]]:
    """Return what is compared: counts, and the same by the way travelled, which driving faster does not raise."""
    measures = find_measures(environment, runs)
    counted, harm = [item for item in measures if item.name in environment.counters()], choose_harm(measures)
    quantities = {
        "what was found": [
            *map(Quantity, counted),
            *(Quantity(item, WAY) for item in counted if item.name != WAY.key),
        ],
        "what it cost": [Quantity(harm), Quantity(harm, WAY)],
        "what else was measured": [Quantity(item) for item in measures if item not in (*counted, harm)],
    }
    return {about: [item for item in found if item.is_known(runs)] for about, found in quantities.items()}


def pair_with_tutor(environment: Environment) -> list[Contest]:
    """Return every variant and control against the tutor alone; none where that does not run."""
    reference = environment.reference
    others = [variant for variant in environment.variants if variant.name != reference]
    return [Contest(environment.name, variant, reference) for variant in others if reference]


def pair_with_controls(environment: Environment) -> list[Contest]:
    """Return every variant that is no control against every control; the tutor alone is neither."""
    there = [variant for variant in environment.variants if variant.name != environment.reference]
    controls = [variant.name for variant in there if variant.control]
    return [Contest(environment.name, item, name) for item in there if not item.control for name in controls]


def correct(comparisons: Sequence[Comparison]) -> tuple[Comparison, ...]:
    """Return the comparisons as one family of tests."""
    ps = iter(holm([item.p for item in comparisons if item.p is not None]))
    return tuple(item if item.p is None else item._replace(p_holm=next(ps)) for item in comparisons)


def _compare_all(study: Study, contests: Sequence[Contest], quantities: Sequence[Quantity]) -> list[Comparison]:
    found = [_compare(study, contest, quantity) for quantity in quantities for contest in contests]
    return [item for item in found if item is not None]


def _compare(study: Study, contest: Contest, quantity: Quantity) -> Comparison | None:
    ours = quantity.read_by_seed(study.of(contest.environment, contest.variant.name))
    pairs = make_pairs(ours, quantity.read_by_seed(study.of(contest.environment, contest.against)))
    if pairs is None:
        return None
    is_tested = quantity.better and not contest.variant.control
    return Comparison(
        *contest,
        quantity,
        pairs.difference(),
        pairs.correlation(),
        pairs.improvement(quantity.better) if quantity.better else None,
        p=sign_flip(pairs.differences) if is_tested else None,
        p_holm=None,
    )


HEADER = (
    "environment",
    "variant",
    "against",
    "measure",
    "pairs",
    "mean",
    "low",
    "high",
    "r",
    "p_improve",
    "p_improve_low",
    "p_improve_high",
    "p",
    "p_holm",
)


def write_differences(path: Path, families: Sequence[Family]) -> None:
    """Write all comparisons as CSV; what does not exist is empty.

    ``low`` and ``high`` are the 95 % BCa interval of the mean difference, ``p_improve`` is the share of pairs in which
    the variant was better, ``p_holm`` is corrected within the family, see `tutorstudent.study.numbers.comparisons`.
    """
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        writer.writerows(_make_row(item) for family in families for item in family.comparisons)


def _make_row(item: Comparison) -> list[str | float | None]:
    return [
        item.environment,
        item.variant.name,
        item.against,
        item.quantity.title,
        item.difference.pairs,
        item.difference.mean,
        *(item.difference.interval or ("", "")),
        item.correlation,
        *((item.improvement.share, *item.improvement.interval) if item.improvement else ("", "", "")),
        item.p,
        item.p_holm,
    ]
