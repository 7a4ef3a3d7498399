"""Curves against the observers that count while a pipeline runs, and against loops."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tutorstudent.core.recording import Arrays
from tutorstudent.core.registry import Registry
from tutorstudent.core.rundir import run_pipeline
from tutorstudent.study.curves import entries, event, harm, level, thinned
from tutorstudent.study.requests import read_pipelines


@pytest.mark.parametrize("name", ["full", "streamlined", "alone"])
def test_curves_end_where_the_observers_do(name: str, files: dict[str, Path], registry: Registry) -> None:
    pipeline = read_pipelines([files[name]], registry)[name].replaced({"decisions": 230, "world.trial": 13})
    finished = run_pipeline(pipeline)
    turns = entries(finished.decisions, "Returning")
    assert finished.summary["turns"] == turns[-1]
    assert finished.summary["turns"] > 10
    assert finished.summary["collided"] == harm(finished.decisions)[-1]
    assert finished.summary["mean_level"] == pytest.approx(level(finished.decisions, 230)[-1])
    assert np.all(np.diff(turns) >= 0)


def recorded(**columns: object) -> Arrays:
    return {name: np.asarray(values) for name, values in columns.items()}


def test_a_stay_is_one_entry_and_a_trials_end_interrupts_it() -> None:
    arrays = recorded(
        situation=[0, 1, 1, 0, 1, 1, 1, 2],
        situation_names=["", "Prey Spin", "Avoid"],
        trial_ended=[0, 0, 0, 0, 0, 1, 0, 0],
    )
    assert [0, 1, 1, 1, 2, 2, 3, 3] == entries(arrays, "Prey Spin").tolist()
    assert [0] * 8 == entries(arrays, "never was in it").tolist()
    assert [1, 1, 1, 2, 2, 2, 2, 2] == entries(arrays, "").tolist()


def test_harm_is_violations_where_the_world_knows_no_collisions() -> None:
    violated = [[False, False], [True, True], [False, True]]
    arrays = recorded(violated=violated, events=np.zeros((3, 0)), event_names=np.zeros(0, dtype="<U1"))
    assert [0, 1, 2] == harm(arrays).tolist()
    assert event(arrays, "collided") is None


@pytest.mark.parametrize("window", [1, 2, 5, 100])
def test_the_level_is_a_mean_over_the_last_decisions(window: int) -> None:
    levels = np.random.default_rng(1).integers(0, 9, 30)
    expected = [levels[max(0, i + 1 - window) : i + 1].mean() for i in range(30)]
    np.testing.assert_allclose(expected, level(recorded(resulting_level=levels), window))


@pytest.mark.parametrize("length", [1, 2, 159, 160, 161, 10_000])
def test_thinning_keeps_the_first_and_the_last(length: int) -> None:
    at = thinned(length)
    assert (0, length - 1) == (at[0], at[-1])
    assert min(length, 160) == len(at)
