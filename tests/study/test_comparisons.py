"""Who is held against whom, and how many tests a family has."""

from __future__ import annotations

import pytest

from tests.study.made import made
from tutorstudent.study.numbers.comparisons import Family, make_families, pair_with_controls, pair_with_tutor
from tutorstudent.study.numbers.significance import holm
from tutorstudent.study.runs.results import Study

FOUND = {
    "alone": [8.0, 10.0, 12.0, 9.0],
    "2A": [20.0, 30.0, 25.0, 22.0],
    "ramp": [20.0, 22.0, 18.0, 21.0],
    "blind": [19.0, 31.0, 24.0, 20.0],
}
COLLIDED = {"alone": [0.0, 0.0, 0.0, 1.0], "2A": [4.0, 0.0, 5.0, 2.0], "ramp": [1.0] * 4, "blind": [2.0] * 4}


@pytest.fixture
def study() -> Study:
    return made(
        {
            name: {
                "attractors": FOUND[name],
                "collided": COLLIDED[name],
                "distance_m": [100.0 if name == "alone" else 400.0] * 4,
                "decisions": [1000.0] * 4,
            }
            for name in FOUND
        },
        controls=("ramp", "blind"),
    )


def family(study: Study, title: str) -> Family:
    return next(item for item in make_families(study) if item.title == title)


def test_everything_is_held_against_the_tutor_alone_and_learners_against_controls(study: Study) -> None:
    environment = study.plan.environments[0]
    assert [("2A", "alone"), ("ramp", "alone"), ("blind", "alone")] == [
        (contest.variant.name, contest.against) for contest in pair_with_tutor(environment)
    ]
    assert [("2A", "ramp"), ("2A", "blind")] == [
        (contest.variant.name, contest.against) for contest in pair_with_controls(environment)
    ]


def test_a_tutor_alone_that_is_a_control_is_held_against_once(study: Study) -> None:
    environment = study.plan.environments[0]
    alone, *others = environment.variants
    as_control = environment._replace(variants=(*others, alone._replace(control=True)))
    assert ["ramp", "blind"] == [contest.against for contest in pair_with_controls(as_control)]
    assert 3 == len(pair_with_tutor(as_control))


def test_there_are_families_of_what_was_found_what_it_cost_and_the_rest(study: Study) -> None:
    assert [
        "Differences to the tutor alone: what was found",
        "Differences to the tutor alone: what it cost",
        "Differences to the tutor alone: what else was measured",
        "Differences to the controls: what was found",
        "Differences to the controls: what it cost",
    ] == [item.title for item in make_families(study)]


def test_a_comparison_is_of_counts_and_of_rates_by_way(study: Study) -> None:
    found = family(study, "Differences to the tutor alone: what was found").comparisons
    counted = next(item for item in found if (item.variant.name, item.quantity.title) == ("2A", "attractors"))
    # 12, 20, 13, 13
    assert (4, 14.5) == counted.difference[:2]
    assert 1.0 == counted.improvement.share
    assert 2 / 16 == counted.p
    by_way = next(item for item in found if (item.variant.name, item.quantity.title) == ("2A", "attractors per 100 m"))
    # 5, 7.5, 6.25, 5.5 against 8, 10, 12, 9: it finds more because it drives farther.
    assert -3.6875 == by_way.difference.mean
    assert 0.0 == by_way.improvement.share


def test_less_harm_is_better(study: Study) -> None:
    found = family(study, "Differences to the controls: what it cost").comparisons
    item = next(item for item in found if (item.against, item.quantity.title) == ("ramp", "collided decisions"))
    # 4, 0, 5, 2 against 1: worse, better, worse, worse
    assert 1.75 == item.difference.mean
    assert 0.25 == item.improvement.share


def test_controls_are_not_tested(study: Study) -> None:
    for item in family(study, "Differences to the tutor alone: what was found").comparisons:
        assert (item.variant.control, item.variant.control) == (item.p is None, item.p_holm is None)


def test_a_family_is_corrected_over_all_environments(study: Study) -> None:
    one = study.plan.environments[0]
    other = one._replace(name="other")
    # Half as different: its smallest p is larger, so that the order matters.
    runs = [
        run._replace(environment="other", summary=run.summary | {"attractors": FOUND["alone"][-1 - run.seed]})
        for run in study.runs
    ]
    both = study._replace(plan=study.plan._replace(environments=(one, other)), runs=(*study.runs, *runs))
    found = family(both, "Differences to the tutor alone: what was found")
    assert 4 == found.tests
    tested = [item for item in found.comparisons if item.p is not None]
    assert {"cave", "other"} == {item.environment for item in tested}
    assert holm([item.p for item in tested if item.p is not None]) == [item.p_holm for item in tested]
    assert 4 * 2 / 16 == tested[0].p_holm


def test_without_a_tutor_alone_and_without_controls_nothing_is_compared(study: Study) -> None:
    environment = study.plan.environments[0]
    learners = tuple(variant for variant in environment.variants if not variant.control)
    bare = environment._replace(variants=learners, reference="")
    assert [] == make_families(study._replace(plan=study.plan._replace(environments=(bare,))))


def test_a_world_without_way_is_compared_by_counts_only(study: Study) -> None:
    for run in study.runs:
        del run.summary["distance_m"]
    measures = {item.quantity.title for found in make_families(study) for item in found.comparisons}
    assert {"attractors", "collided decisions"} == measures


def test_runs_of_other_seeds_are_not_compared(study: Study) -> None:
    runs = tuple(run if run.variant == "alone" else run._replace(seed=run.seed + 3) for run in study.runs)
    found = family(study._replace(runs=runs), "Differences to the tutor alone: what was found").comparisons
    assert {1} == {item.difference.pairs for item in found}
    assert {None} == {item.p for item in found}
    elsewhere = tuple(run if run.variant == "alone" else run._replace(seed=run.seed + 9) for run in study.runs)
    assert [] == [f for f in make_families(study._replace(runs=elsewhere)) if "tutor" in f.title]


def test_a_study_of_which_nothing_ran_has_nothing_to_compare(study: Study) -> None:
    assert [] == make_families(study._replace(runs=()))
