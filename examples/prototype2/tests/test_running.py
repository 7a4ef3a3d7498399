"""Plans, and jobs that go on where they stood."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import tutorstudent as ts
from tutorstudent.study import Job
from tutorstudent_prototype2.pipelines import ENVIRONMENTS, load, load_all
from tutorstudent_prototype2.running import finish, plan_of, read_scenes

SCENE = "chase-avoid"


def job(seed: int, **changes: Any) -> Job:
    return Job(SCENE, "prototype2", seed, 5, dict(load("prototype2", SCENE).document.data) | changes)


def test_a_plan_pairs_every_controller_by_seed_in_every_environment() -> None:
    pipelines = load_all(("prototype2", "prototype2a"), SCENE)
    plan = plan_of(pipelines, ["cave-box", SCENE], runs=2, decisions=20, controls=False)
    assert ["cave-box", SCENE] == [environment.name for environment in plan.environments]
    assert {0, 1} == set(plan.seeds)
    assert 2 * 2 * 2 == len(plan.jobs())
    assert {20} == {item.decisions for item in plan.jobs()}


def test_all_controllers_begin_in_the_same_world() -> None:
    plan = plan_of(load_all(("prototype2", "prototype2a", "streamlined"), SCENE), [SCENE], 1, 20, controls=True)
    (environment,) = plan.environments
    first = environment.variants[0].pipeline
    for variant in environment.variants:
        assert first["world"] == variant.pipeline["world"]
        assert first["tutor"] == variant.pipeline["tutor"]


def test_scenes_are_the_thesiss() -> None:
    assert list(ENVIRONMENTS) == read_scenes(",".join(ENVIRONMENTS))
    assert ["cave-box"] == read_scenes(" cave-box ,")
    with pytest.raises(ts.PipelineError, match=r"--scenes cave: there is no environment 'cave'. Environments: chase-"):
        read_scenes("cave")
    with pytest.raises(ts.PipelineError, match="no environment is named"):
        read_scenes(" , ")


def test_what_was_run_is_not_run_again(tmp_path: Path) -> None:
    jobs = [job(0), job(1)]
    finish(jobs[:1], tmp_path / "one", 1, "first")
    (tmp_path / "one").rename(tmp_path / "two")
    (tmp_path / "two" / "jobs.json").unlink()
    before = (tmp_path / "two" / jobs[0].folder / "run.json").stat().st_mtime_ns
    runs, failures = finish(jobs, tmp_path / "two", 1, "both")
    assert [] == failures
    assert [0, 1] == [run.seed for run in runs]
    assert before == (tmp_path / "two" / jobs[0].folder / "run.json").stat().st_mtime_ns


def test_a_folder_with_other_jobs_is_refused(tmp_path: Path) -> None:
    finish([job(0)], tmp_path, 1, "first")
    with pytest.raises(ts.PipelineError, match="holds a study with other pipelines, settings or numbers; go on with"):
        finish([job(0, tutor={"use": "prototype2", "front_m": 0.4})], tmp_path, 1, "other")


def test_a_folder_that_cannot_be_used_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("something")
    with pytest.raises(ts.PipelineError, match=r"file/x: cannot be used: Not a directory. Give another --out."):
        finish([job(0)], tmp_path / "file" / "x", 1, "first")


def test_a_run_that_fails_is_told_and_run_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    missing = tmp_path / "later" / "learned.npz"
    jobs = [
        job(0),
        Job(SCENE, "student", 0, 5, dict(load("prototype2a", SCENE).document.data) | {"learned": str(missing)}),
    ]
    runs, failures = finish(jobs, tmp_path, 1, "first")
    assert ["prototype2"] == [run.variant for run in runs]
    assert ["student"] == [failure.variant for failure in failures]
    assert "there is no such file" in failures[0].problem
    assert "failed: runs/chase-avoid/student/0" in capsys.readouterr().err
    donor = Job(SCENE, "donor", 0, 5, dict(load("prototype2a", SCENE).document.data))
    finish([donor], tmp_path / "donor", 1, "donor")
    missing.parent.mkdir()
    (tmp_path / "donor" / donor.folder / "learned.npz").rename(missing)
    assert [] == finish(jobs, tmp_path, 1, "again")[1]
