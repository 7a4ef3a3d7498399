"""What a study cost is known over all its sittings, and no result depends on it."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path

import pytest

from tutorstudent.study import Finished, Job, Plan, read_study, run_plan
from tutorstudent.study.runs.progress import show_progress
from tutorstudent.study.runs.timing import Spent, load_timing, save_timing


def test_a_study_took_what_its_runs_and_sittings_took(planned: Callable[..., Plan], folder: Path) -> None:
    plan = planned("alone")
    run_plan(plan, folder)
    for seed, cpu_s in ((0, 1.5), (1, 2.0)):
        save_timing(folder / "runs" / "short" / "alone" / str(seed), Spent(9.0, cpu_s))
    sittings = [{"workers": 2, "runs": 1, "wall_s": 10.0}, {"workers": 1, "runs": 1, "wall_s": 5.5}]
    (folder / "sittings.json").write_text(json.dumps(sittings))
    study = read_study(folder, plan)
    assert Spent(15.5, 3.5) == study.spent()
    assert 2 == study.sittings()
    assert [1.5, 2.0] == [run.spent().cpu_s for run in study.runs]


def test_every_sitting_in_which_something_ran_is_noted(planned: Callable[..., Plan], folder: Path) -> None:
    plan = planned("alone")
    run_plan(plan, folder)
    (folder / "runs" / "short" / "alone" / "1" / "run.json").unlink()
    study = run_plan(plan, folder)
    assert [2, 1] == [entry["runs"] for entry in json.loads((folder / "sittings.json").read_text())]
    assert 2 == study.sittings()
    assert 0.0 < study.runs[0].spent().cpu_s <= study.spent().cpu_s
    run_plan(plan, folder)
    assert 2 == study.sittings()


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"wall_s": "x", "cpu_s": 1}', "[3]"])
def test_a_timing_that_is_damaged_is_unknown_and_disturbs_nothing(
    planned: Callable[..., Plan], folder: Path, text: str
) -> None:
    plan = planned("alone", runs=1)
    run_plan(plan, folder)
    place = folder / plan.jobs()[0].folder
    (place / "timing.json").write_text(text)
    (folder / "sittings.json").write_text(text)
    study = read_study(folder, plan)
    assert math.isnan(load_timing(place).cpu_s)
    assert Spent(0.0, 0.0) == study.spent()
    assert () == study.failures
    assert 0 == study.sittings()


def test_progress_tells_failures_and_notes_and_hands_everything_on(capsys: pytest.CaptureFixture[str]) -> None:
    jobs = [Job("[red]cave", "2A", seed, 5, {}) for seed in range(3)]
    results = [Finished(jobs[0], ""), Finished(jobs[1], "it broke"), Finished(jobs[2], "", "not saved")]
    assert results == list(show_progress(results, "runs", 5, done=2))
    said = capsys.readouterr().err
    assert "failed: [red]cave, 2A, seed 1: it broke" in said
    assert "note: [red]cave, 2A, seed 2: not saved" in said
    assert "5/5 1 failed, time left:" in said
