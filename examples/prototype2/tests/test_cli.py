"""Every command at a tiny size, and mistakes in sentences."""

from __future__ import annotations

import csv
import shutil
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

from tutorstudent.study import load_plan, read_study
from tutorstudent_prototype2.cli import app, main

COMMANDS = ("reproduce", "intervals", "transplant", "heldout")


@pytest.fixture
def plain_report(monkeypatch: pytest.MonkeyPatch) -> None:
    """The page with its pictures costs more than all runs together, and has tests of its own."""
    monkeypatch.setattr(
        "tutorstudent.study.page.report.write_report", lambda folder: read_study(folder, load_plan(folder))
    )


@pytest.fixture
def command(tmp_path: Path) -> Callable[..., Result]:
    def call(name: str, *more: str) -> Result:
        size = ["--runs", "1", "--decisions", "20", "--out", str(tmp_path / name)]
        result = CliRunner().invoke(app, [name, *size, *more], env={"COLUMNS": "120"})
        assert (0, None) == (result.exit_code, result.exception), result.output
        return result

    return call


@pytest.mark.slow
def test_reproduce_leaves_the_studys_own_report_beside_its_tables(command: Any, tmp_path: Path) -> None:
    command("reproduce", "--scenes", "cave-box")
    assert (tmp_path / "reproduce" / "report.html").exists()
    assert (tmp_path / "reproduce" / "reproduction.md").exists()


@pytest.mark.study
@pytest.mark.usefixtures("plain_report")
def test_reproduce_prints_its_tables_and_writes_them(command: Any, tmp_path: Path) -> None:
    result = command("reproduce", "--scenes", "cave-box")
    for words in ("Table 4: cave-box", "Table 5: cave-box", "How many means", "cave-box: with controls", "CPU time, s"):
        assert words in result.stdout
    folder = tmp_path / "reproduce"
    page = (folder / "reproduction.md").read_text(encoding="utf-8")
    assert page.startswith("# Chapter 4, the thesis's numbers beside ours\n\n## Table 4: cave-box\n")
    assert "Controls: blind (" in page
    with (folder / "reproduction.csv").open(newline="") as file:
        assert 4 * 3 == len(list(csv.DictReader(file)))


@pytest.mark.study
@pytest.mark.usefixtures("plain_report")
def test_heldout(command: Any, tmp_path: Path) -> None:
    assert "cave-12m: with controls" in command("heldout").stdout
    page = (tmp_path / "heldout" / "heldout.md").read_text(encoding="utf-8")
    assert [True] * 4 == [f"| {name} |" in page for name in ("prototype2", "prototype2a", "streamlined", "ramp")]


@pytest.mark.study
@pytest.mark.usefixtures("plain_report")
def test_intervals_go_on_where_they_stood(command: Any, tmp_path: Path) -> None:
    result = command("intervals")
    for words in ("taught-never", "taught-0-2 ", "taught-0-5 ", "taught-15-20", "taught-whole"):
        assert words in result.stdout
    before = _times(tmp_path / "intervals")
    first = next(iter(before))
    shutil.rmtree(first.parent)
    command("intervals")
    after = _times(tmp_path / "intervals")
    assert before.keys() == after.keys()
    assert {first} == {path for path in before if before[path] != after[path]}
    assert "## cave-box" in (tmp_path / "intervals" / "intervals.md").read_text(encoding="utf-8")


def _times(folder: Path) -> dict[Path, int]:
    return {path: path.stat().st_mtime_ns for path in sorted((folder / "runs").rglob("run.json"))}


@pytest.mark.study
def test_transplant(command: Any, tmp_path: Path) -> None:
    result = command("transplant")
    assert "cave-box -> cave-predator-prey-box" in result.stdout
    assert "attractors, first 2 decisions" in result.stdout
    assert (tmp_path / "transplant" / "transplant.md").exists()


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_has_help(name: str) -> None:
    result = CliRunner().invoke(app, [name, "--help"], env={"COLUMNS": "80"})
    assert 0 == result.exit_code
    assert all(option in result.stdout for option in ("--runs", "--decisions", "--workers", "--out"))


def test_ctrl_c_says_how_to_go_on(monkeypatch: pytest.MonkeyPatch) -> None:
    def stopped(*_: Any) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("tutorstudent_prototype2.cli.transplant", stopped)
    result = CliRunner().invoke(app, ["transplant"])
    assert (130, "interrupted; the same command goes on where it stood.\n") == (result.exit_code, result.stderr)


def test_runs_that_failed_are_told_with_exit_code_1(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tutorstudent_prototype2.cli.transplant", lambda *_: (["one", "two"], []))
    result = CliRunner().invoke(app, ["transplant"])
    assert 1 == result.exit_code
    assert "2 runs failed; give the command again to run them again." in result.stdout


def mistake(arguments: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> str:
    monkeypatch.setattr(sys, "argv", ["tutorstudent-prototype2", *arguments])
    with pytest.raises(SystemExit) as ended:
        main()
    assert 2 == ended.value.code
    return capsys.readouterr().err


def test_a_mistake_is_a_sentence_and_exit_code_2(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    said = mistake(["intervals", "--scenes", "cave-bx"], monkeypatch, capsys)
    assert "tutorstudent-prototype2: --scenes cave-bx: there is no environment 'cave-bx'." in said
    (tmp_path / "file").write_text("something")
    said = mistake(["heldout", "--runs", "1", "--decisions", "10", "--out", str(tmp_path)], monkeypatch, capsys)
    assert "tutorstudent-prototype2: " in said
    assert str(tmp_path) in said
    assert "Traceback" not in said
