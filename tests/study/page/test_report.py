"""The files of a report: what is in them, and that they can be made again."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import pytest

from tests.study.made import made
from tests.study.tables.test_latex import body, check
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.running.observers import TALLIED
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.study.numbers.comparisons import HEADER, make_families, write_differences
from tutorstudent.study.page.report import write_report
from tutorstudent.study.plans.planning import make_plan
from tutorstudent.study.plans.requests import Request, read_pipelines
from tutorstudent.study.runs.backends import check_extras
from tutorstudent.study.runs.jobs import run_jobs
from tutorstudent.study.studies import begin

FILES = {"results.csv", "differences.csv", "table.md", "tables.tex"}


@pytest.fixture(autouse=True)
def no_page(monkeypatch: pytest.MonkeyPatch) -> None:
    """The page has tests of its own, and its pictures take their time."""
    monkeypatch.setattr("tutorstudent.study.page.report.make_page", lambda study: "")


@pytest.fixture
def folder(files: dict[str, Path], registry: Registry, tmp_path: Path) -> Path:
    """A study of three paired runs, of which nothing is written yet but the runs."""
    given = read_pipelines([files["full"], files["streamlined"], files["alone"]], registry)
    plan = make_plan(Request(given, 3, decisions=20, search_runs=0), registry)
    begin(plan, tmp_path / "study")
    list(run_jobs(plan.jobs(), tmp_path / "study", 1))
    return tmp_path / "study"


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


@pytest.mark.study
def test_a_report_can_be_made_again_to_the_last_byte_and_compares_everything(folder: Path) -> None:
    study = write_report(folder)
    before = {name: (folder / name).read_bytes() for name in FILES}
    write_report(folder)
    assert before == {name: (folder / name).read_bytes() for name in FILES}
    for text in before.values():
        assert b"nan" not in text.lower()
    check(body(before["tables.tex"].decode()))
    found = rows(folder / "differences.csv")
    learners = [variant for variant in study.plan.environments[0].variants if not variant.control]
    controls = [variant for variant in study.plan.environments[0].variants if variant.control]
    against = {(row["variant"], row["against"]) for row in found}
    assert {(item.name, "alone") for item in [*learners, *controls] if item.name != "alone"} | {
        (item.name, control.name) for item in learners if item.name != "alone" for control in controls
    } == against
    every_run = [measure for measure in TALLIED if measure.name != "match_rate"]  # only of students that name kinds
    tested = {"turns", "turns per 100 m", "collided decisions", "collided decisions per 100 m", "contacts"}
    tested |= {measure.heading for measure in every_run if measure.better}
    neither = {"distance, m", "simulated time, s"} | {measure.heading for measure in every_run if not measure.better}
    assert tested | neither == {row["measure"] for row in found}
    assert not [row for row in found if row["measure"] in neither and (row["p"] or row["p_improve"])]


def test_differences_are_tidy(tmp_path: Path) -> None:
    study = made(
        {
            "alone": {"attractors": [8.0, 10.0, 12.0]},
            "2A": {"attractors": [20.0, 30.0, 25.0]},
            "ramp": {"attractors": [20.0, None, None]},
        }
    )
    write_differences(tmp_path / "d.csv", make_families(study))
    learner, control, *others = rows(tmp_path / "d.csv")
    assert list(HEADER) == list(learner)
    assert ("cave", "2A", "alone", "attractors", "3", "15.0") == tuple(learner.values())[:6]
    assert 12.0 <= float(learner["low"]) < 15.0 < float(learner["high"]) <= 20.0
    assert (0.5, 1.0, 1.0, 0.25, 0.25) == pytest.approx(
        tuple(float(learner[key]) for key in ("r", "p_improve", "p_improve_high", "p", "p_holm"))
    )
    assert ("1", "12.0", "", "", "", "1.0", "", "") == tuple(
        control[key] for key in ("pairs", "mean", "low", "high", "r", "p_improve", "p", "p_holm")
    )
    assert [("2A", "ramp", "1", "")] == [(row["variant"], row["against"], row["pairs"], row["p"]) for row in others]
    assert all(math.isfinite(float(value)) for row in (learner, control) for value in row.values() if _number(value))


def _number(text: str) -> bool:
    return text.lower() == "nan" or text.replace(".", "").replace("-", "").isdigit()


def test_names_with_commas_and_quotes_are_one_field(tmp_path: Path) -> None:
    name = 'a, "b"\nc'
    study = made({"alone": {"attractors": [1.0]}, name: {"attractors": [2.0]}})
    write_differences(tmp_path / "d.csv", make_families(study))
    assert [name] == [row["variant"] for row in rows(tmp_path / "d.csv")]


def test_a_study_without_runs_has_a_header_only(tmp_path: Path) -> None:
    write_differences(tmp_path / "d.csv", [])
    assert ",".join(HEADER) + "\n" == (tmp_path / "d.csv").read_text(encoding="utf-8")


def test_a_report_without_scipy_is_refused_with_the_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        "tutorstudent.study.runs.backends.find_spec", lambda name: None if name == "scipy" else object()
    )
    with pytest.raises(PipelineError, match=r"needs scipy; install it with: pip install 'tutorstudent\[study\]'"):
        check_extras()
