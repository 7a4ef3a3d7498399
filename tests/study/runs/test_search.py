"""The best constant level: the most of the goal within the budget of harm, from runs that are not reported."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.study.conftest import results
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.study import Plan, Search, Setting, read_study, run_plan
from tutorstudent.study.plans.constant_level import BEST, Level, Searched, find_best, save_searched, settle
from tutorstudent.study.runs.searching import find_levels

Planned = Callable[..., Plan]

LEVELS = range(1, 5)
"""What the pipelines' cap allows, where a level is worth 0.2."""


def level(number: int, goal: float | None, violated: float | None, runs: int = 2) -> Level:
    return Level("short", number, runs, goal, violated)


# The plan of a search


@pytest.mark.parametrize("first_seed", [0, 999_998, 999_999, 1_000_000, 1_000_001, 7_000_000])
def test_the_seeds_of_a_search_are_nobody_elses(planned: Planned, first_seed: int) -> None:
    plan = planned(runs=3, first_seed=first_seed, search_runs=2)
    assert plan.search is not None
    assert 2 == len(plan.search.plan.seeds)
    assert not set(plan.seeds) & set(plan.search.plan.seeds)


def test_more_runs_leave_the_search_as_it_is(planned: Planned) -> None:
    assert planned(runs=3).search == planned(runs=30).search


def test_the_tutor_alone_and_every_level_are_tried_in_every_environment(planned: Planned) -> None:
    scenes = [Setting("world.scene", scene) for scene in ("short", "long")]
    search = planned(variations=scenes).search
    assert search is not None
    for environment, scene in zip(search.plan.environments, ("short", "long"), strict=True):
        students = {variant.name: variant.pipeline["student"] for variant in environment.variants}
        constants = {f"level-{number}": {"use": "constant", "level": number} for number in LEVELS}
        assert {"tutor-alone": {"use": "silent"}} | constants == students
        assert {scene} == {variant.pipeline["world"]["scene"] for variant in environment.variants}


def test_the_goal_is_what_is_counted_first_unless_it_is_given(planned: Planned) -> None:
    assert "turns" == search_of(planned()).goal
    assert "distance_m" == search_of(planned(goal="distance_m")).goal
    assert "violated:at-wall" == search_of(planned(goal="violated:at-wall")).goal


def search_of(plan: Plan) -> Search:
    assert plan.search is not None
    return plan.search


def test_a_goal_that_nothing_counts_is_refused_before_anything_runs(planned: Planned) -> None:
    with pytest.raises(PipelineError, match=r"--goal turn: no run counts it \(did you mean 'turns'\?\). What is count"):
        planned(goal="turn")


@pytest.mark.parametrize("request_", [{"search_runs": 0}, {"controls": False}])
def test_without_a_search_the_level_is_4_and_says_so(planned: Planned, request_: dict[str, Any]) -> None:
    plan = planned(**request_)
    assert plan.search is None
    about = [variant.about for variant in plan.variants() if variant.name == "constant-4"]
    expected = ["No learning: level 4 in every decision; no other level was tried. A control of full."]
    assert about == (expected if "search_runs" in request_ else [])


def test_where_nothing_is_counted_there_is_no_search(planned: Planned, files: dict[str, Path]) -> None:
    files["full"].write_text(files["full"].read_text().replace("[turns]", "[]"))
    assert planned().search is None
    assert "constant-4" in [variant.name for variant in planned().variants()]
    assert "distance_m" == search_of(planned(goal="distance_m")).goal


def test_where_no_observer_counts_the_goal_is_what_the_world_says(
    planned: Planned, files: dict[str, Path], monkeypatch: pytest.MonkeyPatch, registry: Registry
) -> None:
    monkeypatch.setattr(world_of(registry, "corridor"), "goal_event", "distance_m")
    assert "turns" == search_of(planned()).goal
    files["full"].write_text(files["full"].read_text().replace("[turns]", "[]"))
    plan = planned()
    assert "distance_m" == plan.goal == search_of(plan).goal
    assert {"distance_m": ""} == plan.environments[0].counters()
    assert "constant-4" not in [variant.name for variant in plan.variants()]


def world_of(registry: Registry, name: str) -> Any:
    return next(installed.cls for installed in registry.of("world") if installed.cls.name == name)


@pytest.mark.parametrize("request_", [{}, {"search_runs": 0}, {"controls": False}])
def test_a_goal_that_is_named_is_counted_first_with_a_search_and_without(
    planned: Planned, request_: dict[str, Any]
) -> None:
    plan = planned("full", "alone", goal="distance_m", **request_)
    assert "distance_m" == plan.goal
    assert ["distance_m", "turns"] == list(plan.environments[0].counters())
    assert {"distance_m": "", "turns": "Returning"} == plan.environments[0].counters()
    with pytest.raises(PipelineError, match=r"--goal turn: no run counts it \(did you mean 'turns'"):
        planned(goal="turn", **request_)


def test_tutors_alone_need_no_search(planned: Planned) -> None:
    assert planned("alone").search is None


def test_a_pipeline_with_the_controls_name_is_refused(planned: Planned, files: dict[str, Path]) -> None:
    files[BEST] = files["full"].rename(files["full"].with_name(f"{BEST}.yaml"))
    with pytest.raises(PipelineError, match="'best-constant' is the name of a control; rename the file, or --no-contr"):
        planned(BEST)


# The choice


@pytest.mark.parametrize(
    ("found", "expected"),
    [
        ([level(1, 5, 0.0), level(2, 9, 0.0), level(3, 7, 0.0)], 2),
        ([level(1, 5, 0.0), level(2, 9, 0.02), level(3, 7, 0.01)], 3),
        ([level(1, 5, 0.0), level(2, 9, 0.01), level(3, 9, 0.0)], 3),
        ([level(1, 9, 0.0), level(2, 9, 0.0)], 1),
        ([level(1, 5, 0.03), level(2, 9, 0.02), level(3, 7, 0.02)], 2),
        ([level(0, 99, 0.0), level(1, 5, 0.0)], 1),
        ([level(1, 9, 0.0, runs=1), level(2, 5, 0.0)], 2),
        ([level(1, None, None, runs=0), level(2, 5, 0.9)], 2),
        ([level(0, 5, 0.0), level(1, None, None, runs=0)], None),
        ([], None),
    ],
)
def test_the_best_has_most_within_the_limit_or_violates_least(found: list[Level], expected: int | None) -> None:
    chosen = find_best(found, limit=0.01, runs=2)
    assert expected == (chosen and chosen.level)


@pytest.mark.parametrize("seed", range(5))
def test_no_level_within_the_limit_has_more_than_the_best(seed: int) -> None:
    rng = np.random.default_rng(seed)
    found = [level(i, float(rng.integers(5)), float(rng.integers(5)) / 100) for i in range(9)]
    chosen = find_best(found, limit=0.02, runs=2)
    assert chosen is not None
    within = [item for item in found[1:] if item.violated <= 0.02]  # type: ignore[operator]
    if within:
        assert chosen in within
        assert all(item.goal <= chosen.goal for item in within)  # type: ignore[operator]
    else:
        assert chosen.violated == min(item.violated for item in found[1:])  # type: ignore[type-var]


@pytest.mark.parametrize(("own", "limit"), [(0.0, 0.01), (0.03, 0.03), (None, 0.01)])
def test_the_limit_is_the_budget_or_the_tutors_own_rate(own: float | None, limit: float) -> None:
    searched = Searched("turns", 0.01, (7,), (level(0, 1.0, own), level(1, 1.0, 0.5)))
    assert limit == searched.limit("short")
    assert 0.01 == searched.limit("elsewhere")


def test_levels_that_all_came_to_the_same_are_said_to(planned: Planned) -> None:
    same = Searched("turns", 0.01, (7,), tuple(level(i, 2.0 if i else 5.0, 0.0, runs=1) for i in range(9)))
    assert same.is_indifferent("short")
    assert not same.is_indifferent("elsewhere")
    assert not same._replace(levels=(*same.levels[:8], level(8, 3.0, 0.0))).is_indifferent("short")
    chosen = same._replace(levels=tuple(item._replace(chosen=item.level == 1) for item in same.levels))
    [control] = [item for item in settle(planned(), chosen).variants() if item.name == BEST]
    assert (
        "the one that violates least, or the lowest of those, since all came to the same mean 'turns'" in control.about
    )


# What it makes of a study


@pytest.mark.study
def test_the_table_is_what_the_runs_say(planned: Planned, folder: Path) -> None:
    plan = planned(search_runs=2, decisions=50)
    study = run_plan(plan, folder)
    assert study.search is not None
    for item in study.search.levels:
        name = f"level-{item.level}" if item.level else "tutor-alone"
        places = [folder / "search" / "runs" / "short" / name / str(seed) for seed in (1_000_000, 1_000_001)]
        records = [json.loads((place / "run.json").read_text())["summary"] for place in places]
        assert 2 == item.runs
        assert np.mean([record["turns"] for record in records]) == pytest.approx(item.goal)
        assert np.mean([record["violated"] / 50 for record in records]) == pytest.approx(item.violated)
    assert study.search == find_levels(search_of(plan), folder)
    chosen = study.search.chosen("short")
    assert chosen is not None
    [control] = [variant for variant in study.plan.environments[0].variants if variant.name == BEST]
    assert {"use": "constant", "level": chosen.level} == control.pipeline["student"]
    assert 2 == len(study.of("short", BEST))


def test_environments_may_get_different_levels_and_the_sentence_tells_them_apart(planned: Planned) -> None:
    plan = planned(variations=[Setting("world.scene", scene) for scene in ("short", "long")])
    levels = (
        *(Level("short", i, 1, float(i == 3), 0.0, chosen=i == 3) for i in range(5)),
        *(Level("long", i, 1, float(i), 0.5 - i / 100, chosen=i == 4) for i in range(5)),
    )
    searched = Searched("turns", 0.001, (1_000_000,), levels)
    made = settle(plan, searched)
    found = [item.pipeline["student"]["level"] for place in made.environments for item in place.variants[-1:]]
    assert [3, 4] == found
    [control] = [variant for variant in made.variants() if variant.name == BEST]
    one, other = control.about.split(" In long: ")
    assert one == (
        "In short: No learning: level 3 in every decision. A control of full. Of levels 1 to 4 it is the one with the "
        "highest mean 'turns' among those with at most 0.10% of decisions violated, in runs of their own "
        "(seed 1000000)."
    )
    assert other.startswith("No learning: level 4 in every decision. A control of full. Of levels ")
    assert "among those with at most 50.00% of decisions violated, in runs of their own (seed 1000000)." in other
    assert made == settle(made, searched)


def test_an_older_search_that_chose_a_level_beyond_the_limits_means_the_highest_within(planned: Planned) -> None:
    levels = tuple(Level("short", i, 1, float(i), 0.0, chosen=i == 8) for i in range(9))
    made = settle(planned(), Searched("turns", 0.001, (1_000_000,), levels))
    [control] = [variant for variant in made.variants() if variant.name == BEST]
    assert 4 == control.pipeline["student"]["level"]


def test_a_level_that_breaks_the_budget_for_want_of_others_says_so(planned: Planned) -> None:
    levels = tuple(Level("short", i, 1, 1.0, i / 100, chosen=i == 1) for i in range(9))
    made = settle(planned(), Searched("turns", 0.001, (1_000_000,), levels))
    [control] = [variant for variant in made.variants() if variant.name == BEST]
    assert "it is the one that violates least, since none keeps to 0.10% of decisions, in runs" in control.about


def test_a_search_that_has_not_ended_leaves_runs_that_wait(planned: Planned, folder: Path) -> None:
    study = read_study(folder, planned())
    assert study.search is None
    assert () == study.failures
    assert {BEST, "search: level-4"} < {item.variant for item in study.waiting}
    assert BEST not in [variant.name for variant in study.plan.variants()]


@pytest.mark.study
def test_a_search_in_which_every_level_fails_leaves_the_others_alone(
    planned: Planned, files: dict[str, Path], folder: Path
) -> None:
    files["full"].write_text(files["full"].read_text().replace("short}", "short, fails_with_seed: 1000000}"))
    study = run_plan(planned(), folder)
    assert 2 * 5 == len(study.runs)
    assert {"search: tutor-alone", *(f"search: level-{i}" for i in LEVELS)} == {
        failure.variant for failure in study.failures
    }
    assert {BEST} == {item.variant for item in study.waiting}


@pytest.mark.study
def test_a_goal_that_no_run_counted_is_told_after_the_search(planned: Planned, folder: Path) -> None:
    plan = planned("full", goal="violated:nothing")
    with pytest.raises(PipelineError, match=r"--goal violated:nothing: no run counts it.* What is counted: .*turns"):
        run_plan(plan, folder)


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"levels": [{"level": 3}]}', '{"levels": 3}'])
def test_a_table_that_is_damaged_is_told_with_the_remedy(planned: Planned, folder: Path, text: str) -> None:
    (folder / "search").mkdir()
    (folder / "search" / "table.json").write_text(text)
    with pytest.raises(PipelineError, match=r"table.json: damaged \(.*Remove it and go on with 'compare --resume'"):
        read_study(folder, planned())


@pytest.mark.study
def test_a_table_that_was_removed_is_made_again(planned: Planned, folder: Path) -> None:
    run_plan(planned(), folder)
    before = results(folder)
    (folder / "search" / "table.json").unlink()
    run_plan(planned(), folder)
    assert before == results(folder)


def test_a_table_can_be_read_again(folder: Path) -> None:
    from tutorstudent.study.plans.constant_level import load_searched

    (folder / "search").mkdir()
    searched = Searched("turns", 0.01, (7, 8), (level(0, None, None, runs=0), level(1, 2.5, 0.125)))
    save_searched(searched, folder)
    assert searched == load_searched(folder)
