"""Jobs give the same results whoever runs them, and a backend that is not there is told in a sentence."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from tests.command.test_compare import app
from tests.study.conftest import results
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.study import Backend, Job, Plan, run_jobs, run_plan
from tutorstudent.study.runs import backends as backends_module
from tutorstudent.study.runs.backends import check_backend


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None, protocol="inproc"
    ) as running:
        yield running


@pytest.mark.study
def test_a_cluster_of_dasks_leaves_the_same_bytes(planned: Callable[..., Plan], tmp_path: Path, cluster: Any) -> None:
    plan = planned(runs=1, search_runs=0)
    run_plan(plan, tmp_path / "here")
    run_plan(plan, tmp_path / "there", backend=Backend("dask", cluster.scheduler_address))
    assert results(tmp_path / "here") == results(tmp_path / "there")


@pytest.mark.study
def test_a_job_that_fails_on_a_cluster_does_not_take_the_others_along(
    planned: Callable[..., Plan], tmp_path: Path, cluster: Any
) -> None:
    jobs = planned("alone").jobs()
    broken = jobs[0]._replace(pipeline=jobs[0].pipeline | {"world": "nowhere"})
    finished = list(run_jobs([broken, jobs[1]], tmp_path, backend=Backend("dask", cluster.scheduler_address)))
    problems = {item.job.seed: item.problem for item in finished}
    assert "" == problems[1]
    assert "no world named 'nowhere'" in problems[0]


@pytest.mark.parametrize(
    ("backend", "missing", "message"),
    [
        (Backend("dsak"), "", r"--backend dsak: unknown \(did you mean 'dask'\?\). Backends: dask, loky, ray"),
        (Backend("dask"), "distributed", r"--backend dask needs distributed; .*pip install 'tutorstudent\[dask\]'"),
        (Backend("ray"), "ray", r"--backend ray needs ray; install it with: pip install 'tutorstudent\[ray\]'"),
        (Backend("loky"), "joblib", r"--backend loky needs joblib; .*pip install 'tutorstudent\[study\]'"),
        (Backend("loky", "a:1"), "", r"--address a:1: loky runs on this machine only; add --backend dask or ray"),
    ],
)
def test_a_backend_that_is_not_there_is_told_with_the_remedy(
    backend: Backend, missing: str, message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(backends_module, "find_spec", lambda module: None if module == missing else object())
    with pytest.raises(PipelineError, match=message):
        check_backend(backend)


def test_a_cluster_that_does_not_answer_is_told(planned: Callable[..., Plan], tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    import dask

    assert distributed
    jobs: list[Job] = planned("alone").jobs()
    with (
        dask.config.set({"distributed.comm.timeouts.connect": "100ms"}),
        pytest.raises(PipelineError, match=r"dask: no cluster at 127.0.0.1:1, is its scheduler running\? \w+: "),
    ):
        list(run_jobs(jobs, tmp_path, 1, Backend("dask", "127.0.0.1:1")))


def test_the_command_refuses_a_backend_before_anything_is_written(tmp_path: Path) -> None:
    result = CliRunner().invoke(app, ["--backend", "slurm", "--out", str(tmp_path / "out")])
    assert "--backend slurm: unknown. Backends: dask, loky, ray." in str(result.exception)
    assert not (tmp_path / "out").exists()
