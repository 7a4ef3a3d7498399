"""The thesis's numbers, against a second transcription."""

from __future__ import annotations

import math

import pytest

from tutorstudent_prototype2.pipelines import ENVIRONMENTS, NAMES
from tutorstudent_prototype2.remarks import from_means, remarks
from tutorstudent_prototype2.thesis import improvements, percent_more, prototype2, prototype2a, rows

TABLES = {
    2: "31.2 57.62 84.6 18.11 | 20.6 6.82 130.1 12.93 | 19.4 5.85 125.4 16.59 | 31.5 17.10 125.5 18.42",
    4: "0.0 0.0 8.1 2.02 | 4.4 4.14 41.6 4.22 | 7.1 9.80 39.1 7.20 | 2.0 3.37 40.9 5.86",
    6: "1.6 1.84 29.2 22.00 | 7.2 4.21 68.8 29.94 | 9.1 4.82 42.1 12.42 | 5.7 4.85 49.7 15.09",
    8: "0.3 0.67 30.3 15.60 | 9.2 5.47 85.1 18.13 | 8.5 4.57 76.2 13.69 | 4.4 1.78 78.5 9.50",
}
PERCENTAGES = {
    3: [(34.0, 53.8), (37.8, 48.2), (-0.96, 48.3)],
    5: [(None, 413.6), (None, 382.7), (None, 404.9)],
    7: [(None, 135.6), (None, 44.2), (None, 70.2)],
    9: [(None, 180.9), (None, 151.5), (None, 159.1)],
}


@pytest.mark.parametrize("table", TABLES)
def test_the_tables_are_as_printed(table: int) -> None:
    printed = [tuple(map(float, row.split())) for row in TABLES[table].split("|")]
    assert printed == [tuple(row[3:]) for row in rows() if row.table == table]


@pytest.mark.parametrize("table", PERCENTAGES)
def test_the_percentages_are_as_printed(table: int) -> None:
    assert PERCENTAGES[table] == [tuple(item[3:]) for item in improvements() if item.table == table]


def test_every_environment_has_its_two_tables_and_four_controllers() -> None:
    for i, environment in enumerate(ENVIRONMENTS):
        mine = [row for row in rows() if row.environment == environment]
        assert [None, 2500, 5000, 7500] == [row.learning_phase for row in mine]
        assert {2 + 2 * i} == {row.table for row in mine}
        assert [3 + 2 * i] * 3 == [item.table for item in improvements() if item.environment == environment]


def test_every_row_has_its_pipeline() -> None:
    assert list(NAMES[:4]) * 4 == [row.pipeline for row in rows()]
    assert 12 == len(prototype2a())
    assert (8.1, 2.02) == prototype2("cave-box")[5:]


def test_all_printed_percentages_follow_from_the_printed_means() -> None:
    for item in improvements():
        fewer, more = from_means(item)
        assert item.attractors_percent == pytest.approx(more, abs=0.05)
        if item.collisions_percent is not None:
            assert item.collisions_percent == pytest.approx(fewer, abs=0.05)
    assert math.isnan(percent_more(0.0, 4.4))


def test_three_sentences_of_chapter_4_do_not_follow_from_its_tables() -> None:
    share, least, best = remarks()
    assert "0.21 % (chase-avoid, 2500), 0.19 % (chase-avoid, 5000), 0.32 % (chase-avoid, 7500)" == share.tables
    expected = "53.8 % (chase-avoid), 48.2 % (chase-avoid), 48.3 % (chase-avoid), 44.2 % (cave-predator-prey), 70.2 % ("
    assert least.tables.startswith(expected)
    assert "most attractors in 4 of 4 environments, fewest collisions in 0" == best.tables
