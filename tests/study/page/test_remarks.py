"""What has to be said of a study before anybody reads its numbers."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.study.made import made
from tutorstudent.core.deciding.watching import Notice
from tutorstudent.study.page.head import make_head
from tutorstudent.study.page.remarks import OWN_OBSERVER, describe_goal, make_remarks
from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.plans.constant_level import Level, Searched
from tutorstudent.study.plans.controls import CONSTANT
from tutorstudent.study.runs.results import Failure, Study


def counting(*attractors: float) -> Study:
    return made({"alone": {"attractors": list(attractors)}, "2A": {"attractors": list(attractors)}})


def uncounted(study: Study) -> Study:
    (environment,) = study.plan.environments
    variants = tuple(variant._replace(counters={}) for variant in environment.variants)
    return study._replace(plan=study.plan._replace(environments=(environment._replace(variants=variants),)))


def searched(goals: Sequence[float]) -> Searched:
    levels = [Level("cave", i, 1, goal, 0.0, chosen=i == 1) for i, goal in enumerate(goals)]
    return Searched("attractors", 0.001, (9,), tuple(levels))


def test_there_is_nothing_to_say_of_a_study_where_all_is_well() -> None:
    study = counting(3.0, 4.0)._replace(search=searched([1.0, 2.0, 3.0]))
    assert [] == make_remarks(study)
    assert "The goal, of which more is better: attractors (--goal names another)." == describe_goal(study)
    assert 'class="remark"' not in make_head(study, "x", Palette(study.plan.variants()))


@pytest.mark.parametrize(("count", "words"), [(1, "1 run was"), (34, "34 runs were")])
def test_runs_that_wait_are_no_failures_and_it_is_said_how_to_go_on(count: int, words: str) -> None:
    waiting = tuple(Failure("cave", "2A", seed, "") for seed in range(count))
    study = counting(3.0, 4.0)._replace(waiting=waiting, folder=Path("my study"))
    assert [f"{words} not run yet; go on with: tutorstudent compare --resume --out 'my study'"] == make_remarks(study)
    shown = make_head(study, "x", Palette(study.plan.variants()))
    assert "tutorstudent compare --resume --out &#x27;my study&#x27;" in shown
    assert "failed" not in shown


def test_without_a_goal_the_numbers_that_are_there_are_named() -> None:
    study = uncounted(made({"2A": {"boiled": [1.0], "energy": [2.0], "violated": [0.0], "share:Warm": [0.5]}}))
    assert "" == describe_goal(study)
    assert [
        (
            "Nothing counts what the tutors achieve; name what does with --goal (there are: boiled, energy), or "
            "count it with an observer of your own (ts.Entries, docs/guide/write-an-observer.md)."
        )
    ] == make_remarks(study)


def test_without_a_goal_and_without_numbers_an_observer_is_what_is_left() -> None:
    assert [f"Nothing counts what the tutors achieve; {OWN_OBSERVER}."] == make_remarks(
        uncounted(counting(1.0)._replace(runs=()))
    )


def test_a_level_that_nobody_searched_for_is_said_to_stand_in() -> None:
    numbers = {"alone": {"attractors": [1.0, 2.0]}, CONSTANT: {"attractors": [1.0, 3.0]}}
    study = made(numbers, controls=(CONSTANT,))
    assert [
        "No constant level was searched for, as was asked for: constant-4 stands where best-constant would."
    ] == make_remarks(study)
    assert (
        "No constant level was searched for, since nothing is counted that could be most: constant-4 stands where "
        "best-constant would."
    ) in make_remarks(uncounted(study))


def test_a_goal_that_is_the_same_in_every_run_tells_nobody_apart() -> None:
    assert [
        (
            "In cave attractors is 0 in every run, so that it tells nobody apart. It counts how often the tutor enters "
            f"the situation 'Prey Spin'. Take more decisions, name another goal with --goal, or {OWN_OBSERVER}."
        )
    ] == make_remarks(counting(0.0, 0.0))


def test_one_run_alone_is_not_said_to_be_the_same() -> None:
    assert [] == make_remarks(made({"alone": {"attractors": [0.0]}}))


def test_a_search_in_which_all_levels_came_to_the_same_found_nothing() -> None:
    study = counting(3.0, 4.0)._replace(search=searched([5.0, 2.0, 2.0, 2.0]))
    assert [
        (
            "In the search for the best constant level in cave every level came to the same attractors, 2: level 1 is "
            "the one that violates least, or the lowest of those, and best at nothing."
        )
    ] == make_remarks(study)


def test_a_learner_that_did_nothing_is_a_remark_once_for_each_pipeline_and_kind_of_fault() -> None:
    study = made({name: {"attractors": [3.0, 4.0, 5.0]} for name in ("alone", "2A", "ramp")})
    dead = (Notice("student fails", "student failed in 98 of 100 decisions."),)
    runs = tuple(run._replace(notices=dead if run.seed < 2 and run.variant != "alone" else ()) for run in study.runs)
    assert ["2A in cave, 2 of 3 runs: student failed in 98 of 100 decisions."] == make_remarks(
        study._replace(runs=runs)
    )
