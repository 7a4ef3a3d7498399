"""Not worse, worse, or undecided: at the margin, and where there is too little to say anything."""

from __future__ import annotations

import pytest

from tests.study.made import made
from tutorstudent.study.numbers.intervals import Interval, bca
from tutorstudent.study.numbers.verdicts import MARGIN, Verdict, judge_variants, reach_verdict
from tutorstudent.study.runs.results import Study

ENOUGH = 100_000


def study(collided: dict[str, list[float]], decisions: float = 10_000.0, key: str = "collided") -> Study:
    return made({name: {key: values, "decisions": [decisions] * len(values)} for name, values in collided.items()})


def of(found: Study, **options: float) -> dict[str, Verdict]:
    return {item.variant: item.verdict for item in judge_variants(found, found.plan.environments[0], **options)}


def test_the_margin_is_the_thesis_s_tenth_of_a_percent() -> None:
    assert 0.001 == MARGIN / 10_000


@pytest.mark.parametrize(
    ("low", "high", "expected"),
    [
        (-5.0, -1.0, Verdict.NOT_WORSE),
        (1.0, 9.9, Verdict.NOT_WORSE),  # more harm for certain, but less than the margin
        (1.0, 10.0, Verdict.UNDECIDED),
        (-50.0, 50.0, Verdict.UNDECIDED),
        (10.0, 12.0, Verdict.UNDECIDED),
        (10.1, 12.0, Verdict.WORSE),
    ],
)
def test_a_verdict_is_where_the_interval_lies(low: float, high: float, expected: Verdict) -> None:
    assert expected is reach_verdict(Interval(low, high), ENOUGH)


def test_without_an_interval_nothing_is_decided() -> None:
    assert Verdict.UNDECIDED is reach_verdict(None, ENOUGH)


def test_decisions_too_few_to_see_the_margin_decide_nothing() -> None:
    nothing_seen = Interval(0.0, 0.0)
    assert Verdict.UNDECIDED is reach_verdict(nothing_seen, 2999)  # 3 / 2999 is more than 0.1 %
    assert Verdict.NOT_WORSE is reach_verdict(nothing_seen, 3000)
    assert Verdict.UNDECIDED is reach_verdict(nothing_seen, 3000, margin=1.0)


def test_variants_are_judged_against_the_tutor_alone() -> None:
    found = study(
        {
            "alone": [0.0, 1.0, 0.0, 2.0, 1.0],
            "careful": [1.0, 0.0, 0.0, 1.0, 3.0],
            "reckless": [90.0, 70.0, 120.0, 60.0, 80.0],
            "unsteady": [0.0, 0.0, 60.0, 0.0, 1.0],
        }
    )
    assert {
        "careful": Verdict.NOT_WORSE,
        "reckless": Verdict.WORSE,
        "unsteady": Verdict.UNDECIDED,
    } == of(found)


def test_the_bounds_are_one_sided_ones() -> None:
    ours, theirs = [5.0, 9.0, 4.0, 20.0, 7.0], [1.0, 0.0, 2.0, 3.0, 0.0]
    found = study({"alone": theirs, "2A": ours})
    (item,) = judge_variants(found, found.plan.environments[0])
    assert item.difference is not None
    assert 9.0 == item.harm
    assert 7.8 == pytest.approx(item.difference.mean)
    differences = tuple(our - their for our, their in zip(ours, theirs, strict=True))
    assert bca(differences, 0.90) == item.difference.interval
    both_sides = bca(differences, 0.95)
    assert both_sides is not None
    assert item.difference.interval.high < both_sides.high


def test_harm_is_counted_for_ten_thousand_decisions() -> None:
    found = study({"alone": [0.0] * 4, "2A": [2.0, 3.0, 2.0, 3.0]}, decisions=2000.0)
    (item,) = judge_variants(found, found.plan.environments[0])
    assert 12.5 == item.harm
    assert {"2A": Verdict.UNDECIDED} == of(found)
    assert {"2A": Verdict.NOT_WORSE} == of(found, margin=20.0)
    assert {"2A": Verdict.WORSE} == of(found, margin=5.0)


def test_a_world_without_collisions_is_judged_by_violations() -> None:
    found = study({"alone": [0.0] * 4, "2A": [200.0, 180.0, 190.0, 170.0]}, key="violated")
    assert {"2A": Verdict.WORSE} == of(found)


@pytest.mark.parametrize("runs", [1, 2])
def test_fewer_than_three_pairs_decide_nothing(runs: int) -> None:
    assert {"2A": Verdict.UNDECIDED} == of(study({"alone": [0.0] * runs, "2A": [500.0] * runs}))


def test_runs_without_a_partner_decide_nothing() -> None:
    found = study({"alone": [0.0] * 4, "2A": [500.0] * 4})
    apart = found._replace(
        runs=tuple(run._replace(seed=run.seed + 10) if run.variant == "2A" else run for run in found.runs)
    )
    (item,) = judge_variants(apart, apart.plan.environments[0])
    assert (500.0, None, Verdict.UNDECIDED) == (item.harm, item.difference, item.verdict)


def test_only_what_ran_beside_a_tutor_alone_is_judged() -> None:
    found = study({"alone": [0.0] * 4, "2A": [1.0] * 4})
    environment = found.plan.environments[0]
    assert [] == judge_variants(found, environment._replace(reference=""))
    assert [] == judge_variants(found._replace(runs=()), environment)
