"""The studies of docs/student.md: what is registered runs, and a verdict is what the numbers say."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import tutorstudent as ts
from tutorstudent.study import Run
from tutorstudent_controllers.regimes.__main__ import SHEET, main
from tutorstudent_controllers.regimes.registered import Cell, Registered, change, read
from tutorstudent_controllers.regimes.running import list_jobs, list_students, run
from tutorstudent_controllers.regimes.sheet import write_sheet
from tutorstudent_controllers.regimes.verdicts import judge

CELL = Cell("toy", "found", {"tutor": "none"}, (1, 2))
TOY = Registered((CELL,), (0, 1, 2), 1000, budget=0.01, within=1.5, share=0.95, blind_share=0.9)


def runs(**numbers: tuple[float, float]) -> list[Run]:
    """Return three runs a variant, of a gain and of violated decisions, that differ a little."""
    return [
        Run("toy", name.replace("_", "-"), seed, {"found": gain + seed, "violated": violated}, Path())
        for name, (gain, violated) in numbers.items()
        for seed in (0, 1, 2)
    ]


FOUND = {
    "tutor_alone": (100.0, 5.0),
    "level_1": (150.0, 14.0),
    "level_2": (300.0, 90.0),
    "budgeted": (180.0, 12.0),
    "blind": (299.0, 89.0),
    "ramp": (170.0, 20.0),
}


def test_the_best_fixed_level_is_the_one_with_the_most_gain_within_the_budget() -> None:
    [verdict] = judge(TOY, runs(**FOUND))
    assert (1, 3, 10.0) == (verdict.best, verdict.runs, verdict.allowed)
    assert pytest.approx(181 / 151) == verdict.share_of_best


def test_violations_are_counted_beyond_the_tutors_own() -> None:
    [verdict] = judge(TOY, runs(**FOUND))
    assert 7.0 == verdict.own
    assert pytest.approx(0.7) == verdict.keeps_budget
    assert pytest.approx(84 / 7) == verdict.times_fewer
    assert pytest.approx(181 / 300) == verdict.share_of_blind


def test_where_no_level_keeps_the_budget_the_tutor_alone_is_the_best() -> None:
    [verdict] = judge(TOY, runs(**FOUND | {"level_1": (150.0, 16.0)}))
    assert 0 == verdict.best


def test_where_the_blind_twin_has_no_violations_of_its_own_there_is_no_ratio() -> None:
    [verdict] = judge(TOY, runs(**FOUND | {"blind": (299.0, 5.0)}))
    assert verdict.times_fewer is None


def test_the_sheet_marks_what_misses_and_counts_what_holds() -> None:
    text = write_sheet(TOY, judge(TOY, runs(**FOUND)))
    assert (
        "| toy | 101 / 5 | 181 / 12 | 300 / 89 | 171 / 20 | 1: 151 / 14 | 7 / 10 | 1.20 | 0.60 (!) | 12.0 | 3 |" in text
    )
    assert "| own violations within 1.5 x the budget in 90 % of the cells | 1 of 1 |" in text
    assert "| 12.0 x over 1 cells |" in text
    assert "| gain at least 0.9 of the blind twin's | 0 of 1 cells |" in text
    assert "| 0 | 1 | 1 | 0 | 0 | 1 |\n| 1 | 1 | 0 | 1 | 0 | 1 |\n| 2 | 1 | 1 | 0 | 0 | 1 |" in text


def test_a_level_that_is_better_on_one_and_worse_on_none_is_a_loss() -> None:
    text = write_sheet(TOY, judge(TOY, runs(**FOUND | {"level_1": (190.0, 12.0)})))
    assert "| 1 | 0 | 1 | 0 | 1 | 1 |" in text


def test_a_cell_without_whole_pairs_is_left_out() -> None:
    assert [] == judge(TOY, [run for run in runs(**FOUND) if run.variant != "blind"])


def test_a_blind_twin_keeps_its_margins_and_loses_its_violations_only() -> None:
    blind = list_students(CELL, 0.01)["blind"]
    assert {"use": "blind", "evaluator": "conditions", "margins": True} == blind["evaluator"]
    assert list_students(CELL, 0.01)["budgeted"]["student"] == blind["student"]


def test_every_seed_of_a_cell_has_every_variant() -> None:
    registered = read("controllers")
    jobs = list_jobs(registered)
    assert len(jobs) == len({(job.environment, job.variant, job.seed) for job in jobs})
    assert 11 == len(registered.cells)
    assert set(range(3000, 3010)) == {job.seed for job in jobs}
    assert ("walker as-it-is", (1, 2, 3)) in [(cell.name, cell.levels) for cell in registered.cells]


def test_an_unknown_study_is_refused() -> None:
    with pytest.raises(ts.PipelineError, match="there is no study 'boats'. Studies: controllers, pioneer"):
        read("boats")


def test_changing_a_value_leaves_the_original_alone() -> None:
    values = {"world": {"use": "plate"}}
    assert {"world": {"use": "plate", "gain_k": 1.0}} == change(values, {"world.gain_k": 1.0})
    assert {"world": {"use": "plate"}} == values


@pytest.mark.study
def test_a_study_in_small_runs_and_goes_on_where_it_was_stopped(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    whole = read("controllers")
    cells = [cell for cell in whole.cells if cell.name in ("pid dead-8", "pid gain-x0.5-half-way")]
    monkeypatch.setattr(
        "tutorstudent_controllers.regimes.__main__.read", lambda study: whole._replace(cells=tuple(cells))
    )
    arguments = ["controllers", "--out", str(tmp_path), "--runs", "1", "--decisions", "60"]
    assert 0 == main(arguments)
    first = (tmp_path / SHEET).read_text()
    assert "24 runs, 0 failed" in capsys.readouterr().out
    assert 0 == main(arguments)
    assert first == (tmp_path / SHEET).read_text()


def test_a_level_beyond_a_cells_limits_is_its_highest_one() -> None:
    wide = Cell("wide", "found", {}, (1, 2, 3))
    others = [run._replace(environment="wide") for run in runs(**FOUND, level_3=(400.0, 5.0))]
    text = write_sheet(
        TOY._replace(cells=(CELL, wide)), judge(TOY._replace(cells=(CELL, wide)), runs(**FOUND) + others)
    )
    assert "| 3 | 1 | 2 | 0 | 1 | 2 |" in text


def test_a_gain_that_is_not_positive_has_no_ratio_and_misses() -> None:
    [verdict] = judge(TOY, runs(**{name: (gain - 400, violated) for name, (gain, violated) in FOUND.items()}))
    assert math.isnan(verdict.share_of_best)
    assert "nan (!)" in write_sheet(TOY, [verdict])


@pytest.mark.study
def test_a_folder_with_other_numbers_is_refused_and_more_seeds_go_on(tmp_path: Path) -> None:
    whole = read("controllers")
    cells = tuple(cell for cell in whole.cells if cell.name == "pid dead-8")
    short = whole._replace(cells=cells, seeds=(3000, 3001), decisions=20)
    assert 12 == len(run(short, tmp_path, 1, 1)[0])
    assert 24 == len(run(short, tmp_path, 1)[0])
    with pytest.raises(ts.PipelineError, match="holds a study with other pipelines, settings or numbers"):
        run(short._replace(budget=0.01), tmp_path, 1)
