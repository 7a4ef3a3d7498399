"""Every pipeline of the package runs, and its tables show every variant."""

from __future__ import annotations

from pathlib import Path

import pytest

import tutorstudent as ts
from tutorstudent.study import Request, make_plan, run_plan
from tutorstudent_controllers.__main__ import main
from tutorstudent_controllers.measures import MEASURES
from tutorstudent_controllers.tables import table

PACKAGE = Path(__file__).parents[1] / "tutorstudent_controllers"
PIPELINES = sorted(PACKAGE.glob("*/*.yaml"))


def test_each_example_has_its_pipeline() -> None:
    assert set(MEASURES) <= {path.stem for path in PIPELINES}


@pytest.mark.parametrize("path", PIPELINES, ids=lambda path: path.stem)
def test_every_pipeline_runs_without_an_incident(path: Path) -> None:
    with ts.Pipeline.read(path).replaced({"on_incident": "raise"}).built() as (engine, world, observers):
        ts.run(engine, world, 40, seed=7, observers=observers)
        assert engine.last is not None
        assert 39 == engine.last.decision.moment.number


@pytest.mark.study
def test_the_table_of_a_study_shows_every_variant_beside_the_tutor(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pipeline = ts.Pipeline.read(PACKAGE / "pid" / "pid.yaml")
    request = Request({"pid": pipeline}, runs=3, decisions=30, search_runs=0)
    run_plan(make_plan(request, ts.Registry.discover()), tmp_path / "pid")
    rows = table(tmp_path / "pid").splitlines()
    assert rows[0].startswith("| | temperatures held (to the tutor alone) |") or rows[0].startswith("|  | temperatures")
    names = [row.split("|")[1].strip() for row in rows[2:]]
    assert ["**pid**", "*tutor-alone*", "*blind*", "*ramp*", "*random*", "*constant-4*"] == names
    main(tmp_path)
    assert "## pid\n" in capsys.readouterr().out


def test_a_folder_of_another_name_or_without_studies_is_told(tmp_path: Path) -> None:
    with pytest.raises(ts.PipelineError, match=r"there is no example 'other'. Examples: pid, tree, planner"):
        table(tmp_path / "other")
    with pytest.raises(SystemExit, match=r"there is no study of pid, .*; run 'make controllers' first"):
        main(tmp_path)
