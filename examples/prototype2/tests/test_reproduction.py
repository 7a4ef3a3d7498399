"""The tables of chapter 4 beside runs that nobody made."""

from __future__ import annotations

from pathlib import Path

import pytest

from tutorstudent.study import Run
from tutorstudent_prototype2.calibration.freezing import AFTER_ROUNDS
from tutorstudent_prototype2.calibration.walks import Look, save_looks
from tutorstudent_prototype2.pipelines import FOLDER
from tutorstudent_prototype2.reproduce import settings_tried
from tutorstudent_prototype2.reproduction import lines, sections
from tutorstudent_prototype2.sheets import Section
from tutorstudent_prototype2.thesis import rows


def runs(attractors: float = 0.0, collided: float = 0.0) -> list[Run]:
    """Two runs of each cell: the thesis's means, and so much more."""
    return [
        Run(
            row.environment,
            row.pipeline,
            seed,
            {
                "attractors": row.attractors + attractors + (seed - 0.5),
                "collided": row.collisions + collided,
                "contacts": row.collisions / 2,
            },
            Path("nowhere"),
        )
        for row in rows()
        for seed in range(2)
    ]


@pytest.fixture(scope="module")
def exact() -> dict[str, Section]:
    return {section.sheet.title: section for section in sections(runs())}


def test_there_are_tables_2_to_9(exact: dict[str, Section]) -> None:
    titles = list(exact)
    assert [f"Table {number}" for number in range(2, 10)] == [title.partition(":")[0] for title in titles[:8]]
    assert "Table 4: cave-box" == titles[2]
    assert "Table 5: cave-box, 2A against 2" == titles[3]


def test_a_table_has_the_thesis_as_printed_ours_and_the_verdicts(exact: dict[str, Section]) -> None:
    table = exact["Table 2: chase-avoid"].sheet
    assert ("", "thesis", "ours", "median", "interval", "± 1 sd", "2 SE") == table.header
    assert ("attractors found", "", "", "", "", "", "") == table.rows[0]
    # sd of x - 0.5 and x + 0.5 is 0.7071; half of the interval 12.7062 * 0.7071 / sqrt(2) = 6.3531
    assert ("2A, 2500", "130.1 ± 12.93", "130 ± 0.7", "130", "[124, 136]", "yes", "yes") == table.rows[2]
    assert ("2", "31.2 ± 57.62", "31.2 ± 0.0", "31.2", "[31.2, 31.2]", "yes", "yes") == table.rows[6]
    # 15.6 contacts against 31.2 ± 57.62, whose error is 18.2; 10.3 against 20.6 ± 6.82, whose error is 2.16
    assert [("yes", "yes"), ("no", "no")] == [row[5:] for row in table.rows[11:13]]


def test_cells_that_do_not_match_are_printed_as_they_are() -> None:
    table = sections(runs(attractors=20.0))[2].sheet
    assert "Table 4: cave-box" == table.title
    assert ("2A, 2500", "41.6 ± 4.22", "61.6 ± 0.7", "61.6", "[55.2, 68.0]", "no", "no") == table.rows[2]


def test_improvements_stand_beside_the_printed_percentages(exact: dict[str, Section]) -> None:
    table = exact["Table 3: chase-avoid, 2A against 2"].sheet
    assert ("2A, 2500, attractors found", "+53.8", "+53.8", "0.0", "yes") == table.rows[0]
    assert ("2A, 7500, collided decisions", "-0.96") == table.rows[5][:2]
    assert "yes" == table.rows[5][4]
    assert 9 == len(table.rows)
    assert 3 == len(exact["Table 5: cave-box, 2A against 2"].sheet.rows)


def test_a_sign_that_is_another_is_told() -> None:
    table = sections(runs(attractors=-35.0))[3].sheet  # cave-box: 8.1 -> -26.9, 41.6 -> 6.6
    assert "Table 5" == table.title[:7]
    assert {"no"} == {row[4] for row in table.rows}


def test_what_cannot_be_compared_is_a_dash() -> None:
    only = [run for run in runs() if run.variant != "prototype2"]
    table = next(item.sheet for item in sections(only) if item.sheet.title.startswith("Table 5"))
    assert {("-", "-", "-")} == {row[2:] for row in table.rows}
    single = [run for run in runs() if run.seed == 0]
    assert {"-"} == {row[6] for row in sections(single)[0].sheet.rows if row[1]}


def test_the_score_and_the_yardsticks(exact: dict[str, Section]) -> None:
    score = exact["How many means of prototype 2A are hit"].sheet
    # Half of the thesis's collisions lies more than one sd below in Chase-Avoid (2500, 5000) and in the last cell.
    assert ("ours", "12 of 12", "12 of 12", "9 of 12") == score.rows[0]
    assert ("the thesis's prototype 2 x 3", "2 of 12") == score.rows[1][:2]
    assert ("2A = the thesis's prototype 2", "0 of 12") == score.rows[2][:2]
    assert ("always 6 collisions", "-", "8 of 12", "8 of 12") == score.rows[3]


def test_the_file_has_every_cell() -> None:
    found = lines(runs())
    assert 4 * 4 * 3 == len(found)
    first = found[0]
    assert (2, "chase-avoid", "prototype2", "attractors", 84.6, 18.11) == tuple(first.values())[:6]
    assert (2, True, True) == (first["runs"], first["within_1_sd"], first["within_2_se"])


def test_the_settings_that_were_tried_before_one_was_frozen_are_counted(tmp_path: Path) -> None:
    path = tmp_path / "looks.jsonl"
    assert 0 == settings_tried(path)
    save_looks(
        path, [Look(walk, number, {}, [], {}) for walk in range(2) for number in (1, AFTER_ROUNDS, AFTER_ROUNDS + 1)]
    )
    assert 4 == settings_tried(path)


def test_the_frozen_setting_says_how_many_were_tried() -> None:
    text = (FOLDER.parent / "setting.yaml").read_text(encoding="utf-8")
    assert f"best of {settings_tried()} settings" in text
