"""Tables as Markdown, for the terminal and as CSV."""

from __future__ import annotations

import io
import math
from pathlib import Path

from rich.console import Console

from tutorstudent_prototype2.sheets import Section, Sheet, difference, markdown, show, write_csv
from tutorstudent_prototype2.summaries import Summary

SECTION = Section(
    Sheet("A [bold]title", ("", "a|b"), (("row [red]", "1 | 2"), ("other", "-"))), ("It says something.",)
)


def test_markdown_escapes_what_would_divide_a_cell() -> None:
    assert (
        "# Heading\n\n## A [bold]title\n\n|  | a\\|b |\n| --- | ---: |\n| row [red] | 1 \\| 2 |\n| other | - |\n\n"
        "It says something.\n"
    ) == markdown([SECTION], "Heading")


def test_the_terminal_shows_brackets_as_they_are() -> None:
    stream = io.StringIO()
    show([SECTION], Console(file=stream, width=60))
    lines = [line.rstrip() for line in stream.getvalue().splitlines()]
    assert "A [bold]title" in lines
    assert any("row [red]" in line and "1 | 2" in line for line in lines)
    assert "It says something." in lines


def test_csv_has_a_row_for_each_mapping(tmp_path: Path) -> None:
    write_csv(tmp_path / "x.csv", [{"a": 1, "b": True}, {"a": 2.5, "b": "x,y"}])
    assert 'a,b\n1,True\n2.5,"x,y"\n' == (tmp_path / "x.csv").read_text()
    write_csv(tmp_path / "none.csv", [])
    assert "" == (tmp_path / "none.csv").read_text().strip()


def test_a_difference_without_pairs_or_with_one_is_told_as_such() -> None:
    assert "-" == difference(None)
    assert "+3.0 -" == difference(Summary(1, 3.0, math.nan, 3.0, math.nan, math.nan))
    assert "-1.5 [-3.0, 0.0]" == difference(Summary(4, -1.5, 1.0, -1.0, -3.0, 0.0))
