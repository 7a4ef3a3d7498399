"""What parts declare: every measure has its column, its curve, its legend line and its test, in a real comparison."""

from __future__ import annotations

import csv
import html
import json
import re
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import tutorstudent as ts
from tests.study.conftest import FULL
from tests.study.made import made
from tutorstudent.command.program import app
from tutorstudent.core.files.registry import Registry
from tutorstudent.study import Job, read_runs
from tutorstudent.study.numbers.declared import choose_harm, find_measures
from tutorstudent.study.page.report import write_report
from tutorstudent.study.runs.results import Study

OWN = (
    FULL.replace("world: {use: corridor, scene: short}", "world: tollway")
    .replace("observers: [turns]", "observers: [turns, effort]")
    .replace("conditions: [at-wall]", "conditions: [at-wall, far-out]")
)


@pytest.fixture(scope="module")
def compared(corridor_distribution: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """The folder of a comparison of a pipeline whose world and observer measure things of their own, and its output."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(corridor_distribution))
        folder = tmp_path_factory.mktemp("own")
        (folder / "own.yaml").write_text(OWN)
        out = folder / "study"
        asked = ["compare", folder / "own.yaml", "--runs", 3, "--decisions", 40, "--search-runs", 0, "--out", out]
        result = CliRunner().invoke(app, list(map(str, asked)))
    assert 0 == result.exit_code, result.output
    return out, result.output


def header_of(text: str, table: str) -> list[str]:
    """Return the columns of a table in Markdown, but for runs and differences."""
    line = next(line for line in text.partition(f"**{table}**")[2].splitlines() if line.startswith("|"))
    return [cell for cell in line.strip("| ").split(" | ") if cell not in ("runs", "difference")]


def test_every_measure_has_a_column_in_the_table_of_what_is_better(compared: tuple[Path, str]) -> None:
    text = (compared[0] / "table.md").read_text(encoding="utf-8")
    cost = header_of(text, "What it cost")
    assert {"toll paid, EUR", "effort, J", "violated at-wall", "violated far-out"} <= set(cost)
    assert {"echoes", "pull, N (max)", "horses"} <= set(header_of(text, "What the parts did"))
    rates = header_of(text, "By way and by time")
    assert {"effort, J per 100 m", "toll paid, EUR per 1,000 s"} <= set(rates)
    assert not {"echoes per 100 m", "pull, N per 100 m"} & set(rates)
    latex = (compared[0] / "tables.tex").read_text(encoding="utf-8")
    assert "effort, J" in latex


def test_a_neutral_sum_stands_beside_no_difference_and_a_good_or_bad_one_does(compared: tuple[Path, str]) -> None:
    text = (compared[0] / "table.md").read_text(encoding="utf-8")
    assert "| effort, J | difference |" in text
    assert "| echoes | difference |" not in text


def test_every_measure_has_a_learning_curve(compared: tuple[Path, str]) -> None:
    page = html.unescape((compared[0] / "report.html").read_text(encoding="utf-8"))
    for title in ("effort, J per 1,000 decisions", "toll paid, EUR per 1,000 decisions", "echoes per 1,000 decisions"):
        assert f'aria-label="{title} over decisions, own. ' in page
    details = page.partition("Learning curves of the details")[2]
    assert 'aria-label="pull, N over decisions, own. ' in details
    assert 'aria-label="violated far-out per 1,000 decisions over decisions, own. ' in page
    assert "horses over decisions" not in page  # a whole run has it, decisions do not


def test_the_legend_explains_the_columns_that_are_there_and_no_others(compared: tuple[Path, str]) -> None:
    folder, output = compared
    told = " ".join(output.split())
    texts = [told, *(_words(folder / name) for name in ("table.md", "report.html"))]
    for text in texts:
        assert "effort: work of the motor." in text
        assert "toll paid: one for every metre begun." in text
        assert "turns: how often the tutor entered the situation 'Returning'." in text
    assert "encounters" not in " ".join(texts)
    assert "named the tutor's kind" not in told  # a detail


def _words(path: Path) -> str:
    return " ".join(html.unescape(path.read_text(encoding="utf-8")).split())


def test_the_terminal_shows_every_event_of_an_own_world_and_every_condition(compared: tuple[Path, str]) -> None:
    head = compared[1].partition("The goal")[0]
    for word in ("toll", "EUR", "echoes", "effort,", "at-wall", "far-out", "horses"):
        assert word in head.split()
    assert max(map(len, head.splitlines())) <= 80


def test_a_measure_with_a_direction_is_tested_and_another_only_compared(compared: tuple[Path, str]) -> None:
    with (compared[0] / "differences.csv").open(newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["variant"] == "own"]
    effort = [row for row in rows if row["measure"] == "effort, J"]
    assert {"tutor-alone", "blind", "ramp", "random", "constant-4"} == {row["against"] for row in effort}
    assert all(row["low"] and row["p"] and row["p_holm"] and row["p_improve"] for row in effort)
    (echoes,) = (row for row in rows if row["measure"] == "echoes")
    assert ("tutor-alone", "", "", "") == tuple(echoes[key] for key in ("against", "p", "p_holm", "p_improve"))
    assert echoes["low"]


def test_what_is_measured_stands_in_the_run_and_adds_up(compared: tuple[Path, str]) -> None:
    (run,) = compared[0].glob("runs/*/own/0")
    record = json.loads((run / "run.json").read_text(encoding="utf-8"))
    declared = {item["name"]: item for item in record["measures"]}
    assert ("less", "sum", "J") == tuple(declared["effort_j"][key] for key in ("better", "summed", "unit"))
    with np.load(run / "decisions.npz") as arrays:
        assert ["turns", "effort_j", "pull_n"] == arrays["measure_names"].tolist()
        turns, effort_j, pull_n = arrays["measures"].T
    assert record["summary"]["effort_j"] == pytest.approx(np.nansum(effort_j))
    assert record["summary"]["pull_n"] == np.nanmax(pull_n)
    assert record["summary"]["turns"] == turns.sum() > 0


def test_the_report_is_made_again_from_the_folder_alone(compared: tuple[Path, str]) -> None:
    names = ("table.md", "report.html", "tables.tex", "differences.csv", "results.csv")
    before = {name: (compared[0] / name).read_bytes() for name in names}
    assert "tollway" not in [installed.cls.name for installed in Registry.discover()]
    write_report(compared[0])
    assert before == {name: (compared[0] / name).read_bytes() for name in names}


def test_what_is_no_word_of_a_measure_is_a_damaged_run(compared: tuple[Path, str], tmp_path: Path) -> None:
    (place,) = compared[0].glob("runs/*/own/0")
    copy = tmp_path / "runs" / place.parts[-3] / "own" / "0"
    copy.mkdir(parents=True)
    for path in place.iterdir():
        (copy / path.name).write_bytes(path.read_bytes())
    text = (copy / "run.json").read_text(encoding="utf-8")
    (copy / "run.json").write_text(re.sub(r'"better": "less"', '"better": "fewer"', text), encoding="utf-8")
    runs, failures = read_runs(tmp_path, [Job(place.parts[-3], "own", 0, 40, {})])
    assert [] == runs
    assert "damaged: ContractError: measure 'collided': better is 'fewer'" in failures[0].problem


def measured(measures: tuple[ts.Measure, ...], **numbers: float) -> Study:
    return made({"alone": {key: [value] for key, value in numbers.items()}}, measures=measures)


def names_of(study: Study) -> list[str]:
    return [measure.name for measure in find_measures(study.plan.environments[0], study.runs)]


def test_the_goal_stands_first_then_harm_then_what_is_no_detail() -> None:
    declared = (ts.Measure("a", detail=True), ts.Measure("b"), ts.Measure("collided"), ts.Measure("c"))
    study = measured(declared, a=1.0, b=1.0, collided=1.0, c=1.0, attractors=1.0)
    assert ["attractors", "collided", "b", "c", "a"] == names_of(study)
    assert "more" == find_measures(study.plan.environments[0], study.runs)[0].better


def test_what_no_run_has_is_no_measure_and_what_nobody_declared_is_a_neutral_one() -> None:
    study = measured((ts.Measure("never"),), horses=2.0)
    assert ["horses"] == names_of(study)
    assert find_measures(study.plan.environments[0], study.runs)[0].better is None


def test_what_others_are_made_from_and_what_only_some_runs_have_is_no_measure() -> None:
    known = {"decisions": 9.0, "amplified": 1.0, "x_m": 1.0, "share:Warm": 0.5, "violated:hot": 1.0}
    assert [] == names_of(measured((), **known))
    declared = measured((ts.Measure("violated:hot"),), **known)
    assert ["violated:hot"] == names_of(declared)


def test_harm_is_collisions_and_violations_where_the_world_knows_none() -> None:
    assert "collided" == choose_harm([ts.Measure("violated"), ts.Measure("collided")]).name
    assert "violated" == choose_harm([ts.Measure("violated")]).name
    assert "violated" == choose_harm([]).name
