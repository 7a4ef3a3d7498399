"""Jobs run in one process or several with the same results, and one that fails leaves the others alone."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import pytest

from tutorstudent.core.files.registry import Registry
from tutorstudent.core.running.arrays import load_arrays
from tutorstudent.study.plans.plan import Plan
from tutorstudent.study.plans.planning import make_plan
from tutorstudent.study.plans.requests import Request, read_pipelines
from tutorstudent.study.runs.jobs import Finished, run_job, run_jobs
from tutorstudent.study.runs.results import read_study, write_csv

pytestmark = pytest.mark.study

PIONEER = """\
decisions: 40
world: {use: pioneer, scene: cave-predator-prey-box}
tutor: prototype2
student: {use: backprop, encoder: prototype2-bits}
conditions: [bumped]
observers: [attractors]
"""


def plan_of(path: Path, registry: Registry, runs: int = 2) -> Plan:
    return make_plan(Request(read_pipelines([path], registry), runs, search_runs=0), registry)


def outputs(plan: Plan, folder: Path, workers: int) -> dict[Path, bytes]:
    assert [] == [finished.problem for finished in run_jobs(plan.jobs(), folder, workers) if finished.problem]
    return {
        job.folder / name: (folder / job.folder / name).read_bytes()
        for job in plan.jobs()
        for name in ("decisions.npz", "learned.npz", "run.json", "pipeline.yaml")
    }


@pytest.mark.process
@pytest.mark.usefixtures("fresh_workers")
def test_one_two_and_three_workers_leave_the_same_bytes(
    files: dict[str, Path], registry: Registry, tmp_path: Path
) -> None:
    plan = plan_of(files["full"], registry, runs=1)
    alone = outputs(plan, tmp_path / "1", 1)
    assert 4 * 6 == len(alone)
    for workers in (2, 3):
        assert alone == outputs(plan, tmp_path / str(workers), workers)


@pytest.mark.process
def test_the_pioneer_world_does_the_same_in_two_workers(tmp_path: Path) -> None:
    pytest.importorskip("pybullet")
    path = tmp_path / "pioneer.yaml"
    path.write_text(PIONEER)
    registry = Registry.discover()
    plan = make_plan(Request(read_pipelines([path], registry), 2, controls=False), registry)
    assert outputs(plan, tmp_path / "1", 1) == outputs(plan, tmp_path / "2", 2)


def test_a_run_stands_in_its_own_folder_and_is_about_its_own_seed(
    files: dict[str, Path], registry: Registry, tmp_path: Path
) -> None:
    job = plan_of(files["full"], registry).jobs()[-1]
    assert Finished(job, "") == run_job(job, tmp_path)
    record = json.loads((tmp_path / "runs" / "short" / job.variant / "1" / "run.json").read_text())
    assert (1, 60) == (record["seed"], record["decisions"])


def test_paired_runs_begin_in_the_same_place_and_seeds_differ(
    files: dict[str, Path], registry: Registry, tmp_path: Path
) -> None:
    plan = plan_of(files["full"], registry)
    list(run_jobs(plan.jobs(), tmp_path, 1))
    first = {(job.variant, job.seed): load_arrays(tmp_path / job.folder / "decisions.npz") for job in plan.jobs()}
    silent = [first["tutor-alone", seed]["events"] for seed in (0, 1)]
    assert not np.array_equal(*silent)
    # In the first decision the tutor alone and the others stand in the same place; what differs is the level.
    kinds = [first[variant, 0]["kind"][0] for variant in ("tutor-alone", "full", "blind", "ramp", "random")]
    assert 1 == len(set(kinds))


def test_a_job_that_fails_is_told_and_the_others_go_on(
    files: dict[str, Path], registry: Registry, tmp_path: Path
) -> None:
    files["full"].write_text(files["full"].read_text().replace("scene: short", "scene: short, fails_with_seed: 1"))
    plan = plan_of(files["full"], registry)
    finished = list(run_jobs(plan.jobs(), tmp_path, 1))
    failed = [item for item in finished if item.problem]
    assert {1} == {item.job.seed for item in failed}
    assert {"decision 0: world 'corridor': reset() raised RuntimeError: the wall fell down."} == {
        item.problem for item in failed
    }
    study = read_study(tmp_path, plan)
    assert (6, 6) == (len(study.runs), len(study.failures))
    assert {"decision 0: world 'corridor': reset() raised RuntimeError: the wall fell down."} == {
        failure.problem for failure in study.failures
    }
    assert "Traceback" in (tmp_path / failed[0].job.folder / "error.txt").read_text()


def forget(_: object) -> None:
    raise RuntimeError("it slipped my mind")


def test_a_job_that_cannot_save_what_it_learned_has_not_failed_and_says_so(
    files: dict[str, Path], registry: Registry, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tutorstudent.core.files.rundir.flatten", forget)
    plan = plan_of(files["full"], registry, runs=1)
    (first, *_) = finished = list(run_jobs(plan.jobs(), tmp_path, 1))
    assert {""} == {item.problem for item in finished}
    assert "what was learned could not be saved: RuntimeError: it slipped my mind. The other" in first.note
    study = read_study(tmp_path, plan)
    assert (6, 0) == (len(study.runs), len(study.failures))


def test_a_number_that_a_run_does_not_have_is_empty_in_the_results(
    files: dict[str, Path], registry: Registry, tmp_path: Path
) -> None:
    plan = plan_of(files["alone"], registry)
    list(run_jobs(plan.jobs(), tmp_path, 1))
    record = tmp_path / plan.jobs()[0].folder / "run.json"
    data = json.loads(record.read_text())
    data["summary"]["turns"] = None
    record.write_text(json.dumps(data))
    study = read_study(tmp_path, plan)
    assert [False, True] == ["turns" in run.summary for run in study.runs]
    write_csv(tmp_path / "results.csv", study.runs)
    header, first, _ = (line.split(",") for line in (tmp_path / "results.csv").read_text().splitlines())
    assert "" == first[header.index("turns")]


@pytest.mark.process
@pytest.mark.usefixtures("fresh_workers")
def test_a_worker_that_dies_leaves_failures_and_no_traceback(
    files: dict[str, Path], registry: Registry, tmp_path: Path
) -> None:
    jobs = plan_of(files["full"], registry).jobs()[:2]
    deadly = jobs[0]._replace(pipeline=Deadly(jobs[0].pipeline))
    finished = list(run_jobs([deadly, jobs[1]], tmp_path, 2))
    assert {job.folder for job in jobs} == {item.job.folder for item in finished}
    assert any("a worker process died" in item.problem for item in finished)


class Deadly(dict):  # type: ignore[type-arg]
    """Ends the process that unpacks it."""

    def __reduce__(self) -> tuple[object, ...]:
        return os._exit, (3,)


def test_what_was_not_run_yet_waits_and_is_no_failure(
    files: dict[str, Path], registry: Registry, tmp_path: Path
) -> None:
    plan = plan_of(files["full"], registry, runs=1)
    run_job(plan.jobs()[0], tmp_path)
    study = read_study(tmp_path, plan)
    assert (1, 0, 5) == (len(study.runs), len(study.failures), len(study.waiting))
    (tmp_path / plan.jobs()[1].folder).mkdir(parents=True)
    (tmp_path / plan.jobs()[1].folder / "error.txt").write_text("")
    study = read_study(tmp_path, plan)
    assert (1, 1, 4) == (len(study.runs), len(study.failures), len(study.waiting))
    assert study.failures[0].problem.endswith("error.txt is empty; go on with 'compare --resume' to run it again.")


def test_results_have_a_row_for_each_run_with_every_number(
    files: dict[str, Path], registry: Registry, tmp_path: Path
) -> None:
    plan = plan_of(files["full"], registry)
    list(run_jobs(plan.jobs(), tmp_path, 1))
    study = read_study(tmp_path, plan)
    write_csv(tmp_path / "results.csv", study.runs)
    header, *rows = (line.split(",") for line in (tmp_path / "results.csv").read_text().splitlines())
    assert 2 * 6 == len(rows)
    assert ["environment", "variant", "seed"] == header[:3]
    for run, row in zip(study.runs, rows, strict=True):
        values = dict(zip(header, row, strict=True))
        assert (run.environment, run.variant, str(run.seed)) == tuple(row[:3])
        for key, value in run.summary.items():
            assert value == float(values[key])
