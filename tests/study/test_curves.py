"""Curves against the observers that count while a pipeline runs, and against loops."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.rundir import run_pipeline
from tutorstudent.core.running.arrays import Arrays
from tutorstudent.study.numbers.curves import (
    count_by_decision,
    find_entries,
    find_harm,
    find_matches,
    read_event,
    read_level,
    read_points,
    sum_up,
    thin_out,
)
from tutorstudent.study.plans.requests import read_pipelines


@pytest.mark.parametrize("name", ["full", "streamlined", "alone"])
def test_curves_end_where_the_observers_do(name: str, files: dict[str, Path], registry: Registry) -> None:
    pipeline = read_pipelines([files[name]], registry)[name].replaced({"decisions": 230, "world.trial": 13})
    finished = run_pipeline(pipeline)
    turns = sum_up(find_entries(finished.decisions, "Returning"))
    assert finished.summary["turns"] == turns[-1]
    assert finished.summary["turns"] > 10
    assert finished.summary["collided"] == find_harm(finished.decisions).sum()
    assert finished.summary["mean_level"] == pytest.approx(read_level(finished.decisions).mean())
    assert np.all(np.diff(turns) >= 0)


def test_matches_are_those_that_the_observer_counts(files: dict[str, Path], registry: Registry) -> None:
    pipelines = read_pipelines([files["full"], files["streamlined"]], registry)
    named = run_pipeline(pipelines["full"])
    found = find_matches(named.decisions)
    assert found is not None
    assert named.summary["match_rate"] == pytest.approx(found.mean())
    assert 0 < found.sum() < len(found)
    assert find_matches(run_pipeline(pipelines["streamlined"]).decisions) is None


def recorded(**columns: object) -> Arrays:
    return {name: np.asarray(values) for name, values in columns.items()}


def test_a_stay_is_one_entry_and_a_trials_end_interrupts_it() -> None:
    arrays = recorded(
        situation=[0, 1, 1, 0, 1, 1, 1, 2],
        situation_names=["", "Prey Spin", "Avoid"],
        trial_ended=[0, 0, 0, 0, 0, 1, 0, 0],
    )
    assert [0, 1, 1, 1, 2, 2, 3, 3] == sum_up(find_entries(arrays, "Prey Spin")).tolist()
    assert [0] * 8 == sum_up(find_entries(arrays, "never was in it")).tolist()
    assert [1, 1, 1, 2, 2, 2, 2, 2] == sum_up(find_entries(arrays, "")).tolist()


def test_what_the_world_counts_adds_up_as_what_observers_do() -> None:
    arrays = recorded(
        events=[[0.0, -1.0], [2.0, 3.0], [1.0, 0.0]],
        event_names=["prey", "reward"],
        situation=[0, 1, 1],
        situation_names=["", "Prey Spin"],
        trial_ended=[0, 0, 0],
    )
    prey, entries = count_by_decision(arrays, "prey", ""), count_by_decision(arrays, "attractors", "Prey Spin")
    assert prey is not None
    assert entries is not None
    assert [0.0, 2.0, 3.0] == sum_up(prey).tolist()
    assert [0.0, 1.0, 1.0] == sum_up(entries).tolist()
    assert count_by_decision(arrays, "reward", "") is None  # its total would fall
    assert count_by_decision(arrays, "falls", "") is None


def test_harm_is_violations_where_the_world_knows_no_collisions() -> None:
    violated = [[False, False], [True, True], [False, True]]
    arrays = recorded(violated=violated, events=np.zeros((3, 0)), event_names=np.zeros(0, dtype="<U1"))
    assert [False, True, True] == find_harm(arrays).tolist()
    assert read_event(arrays, "collided") is None


def test_a_place_needs_both_coordinates() -> None:
    events = np.arange(6.0).reshape(2, 3)
    both = read_points(recorded(events=events, event_names=["y_m", "collided", "x_m"]))
    assert both is not None
    assert [[2.0, 0.0], [5.0, 3.0]] == both.tolist()
    assert read_points(recorded(events=events, event_names=["y_m", "collided", "z_m"])) is None


def test_a_student_that_names_no_kind_now_and_then_does_not_match_then() -> None:
    found = find_matches(recorded(kind=[0, 1, 2], proposed_kind=[0, -1, 1]))
    assert found is not None
    assert [1.0, 0.0, 0.0] == found.tolist()


@pytest.mark.parametrize("length", [1, 2, 159, 160, 161, 10_000])
def test_thinning_keeps_the_first_and_the_last(length: int) -> None:
    at = thin_out(length)
    assert (0, length - 1) == (at[0], at[-1])
    assert min(length, 160) == len(at)
