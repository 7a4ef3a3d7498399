"""The tables of paired differences, and of the verdicts about harm."""

from __future__ import annotations

from tutorstudent.study.numbers.comparisons import Comparison, Family, make_families
from tutorstudent.study.numbers.quantities import DECISIONS
from tutorstudent.study.numbers.significance import LEVEL, count_fewest_pairs
from tutorstudent.study.numbers.verdicts import MARGIN, Judgement, judge_variants, make_harm_rate
from tutorstudent.study.plans.plan import Environment
from tutorstudent.study.runs.results import Study
from tutorstudent.study.tables.cells import correlation, difference, improvement, number, probability
from tutorstudent.study.tables.table import Row, Table

HEADER = ("against", "measure", "pairs", "difference", "r", "better in", "p", "p, Holm")
ABOUT_VERDICTS = (
    "Run by run on the same seed. Not worse: the one-sided 95 % BCa bound of the difference lies below the margin of "
    f"{MARGIN:g} in {DECISIONS.words} decisions. Worse: the other bound lies above it. Undecided: neither, fewer than "
    "three pairs, or too few decisions to see such a rate. The verdicts are not corrected for their number."
)


def make_difference_tables(study: Study, environment: Environment) -> list[Table]:
    """Return the differences to the tutor alone and to the controls in one environment."""
    made = []
    for family in make_families(study):
        rows = tuple(_make_row(item) for item in family.comparisons if item.environment == environment.name)
        if rows:
            made.append(Table(family.title, HEADER, rows, _describe_family(family)))
    return made


def make_verdict_tables(study: Study, environment: Environment) -> list[Table]:
    """Return the verdicts about harm; no table without a tutor alone to hold it against."""
    found = judge_variants(study, environment)
    rate = make_harm_rate(study, environment)
    title = "Does it harm more than the tutor alone?"
    header = (rate.title, "difference [one-sided 95 % bounds]", "margin", "verdict")
    return [Table(title, header, tuple(map(_make_verdict_row, found)), ABOUT_VERDICTS)] if found else []


def _make_row(item: Comparison) -> Row:
    cells = (
        item.against,
        item.quantity.title,
        str(item.difference.pairs),
        difference(item.difference),
        correlation(item.correlation),
        improvement(item.improvement),
        probability(item.p),
        probability(item.p_holm),
    )
    return Row(item.variant.name, item.variant.control, cells)


def _describe_family(family: Family) -> str:
    tests, pairs = family.tests, max(item.difference.pairs for item in family.comparisons)
    text = "r: correlation of the two over seeds. Better in: share of pairs, ties half, with Wilson's 95 % interval. "
    if tests:
        text += (
            "p: two-sided sign-flip permutation test of the mean difference. p, Holm: corrected for the "
            f"{tests} tests of this table in all environments."
        )
    elif any(item.quantity.better and not item.variant.control for item in family.comparisons):
        text += "p: none, with so few pairs."
    if any(item.variant.control for item in family.comparisons):
        text += " Nothing is claimed of controls, so they are not tested."
    if not all(item.quantity.better for item in family.comparisons):
        text += " Nor is tested what is neither better nor worse."
    if tests and pairs < count_fewest_pairs(tests):
        text += f" No p can get below {LEVEL} after Holm with {pairs} pairs; it takes {count_fewest_pairs(tests)}."
    return text


def _make_verdict_row(item: Judgement) -> Row:
    cells = (number(item.harm), difference(item.difference), f"+{MARGIN:g}", str(item.verdict))
    return Row(item.variant, item.control, cells)
