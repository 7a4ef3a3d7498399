"""`tutorstudent compare`, as a person calls it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import typer
from typer.testing import CliRunner

from tutorstudent.command.compare import compare
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.words.errors import PipelineError, TutorStudentError
from tutorstudent.study.runs import backends

app = typer.Typer(pretty_exceptions_enable=False)
app.command()(compare)


def call(*arguments: object) -> Any:
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


@pytest.mark.study
@pytest.mark.usefixtures("registry")
def test_a_comparison_ends_with_tables_and_a_page(files: dict[str, Path], tmp_path: Path) -> None:
    out = tmp_path / "out"
    result = call(
        files["full"], files["alone"], "--runs", 2, "--decisions", 30, "--out", out, "--set", "world.trial=10"
    )
    assert 0 == result.exit_code, result.output
    names = {
        "plan.json",
        "sketches",
        "search",
        "runs",
        "sittings.json",
        "results.csv",
        "differences.csv",
        "table.md",
        "tables.tex",
        "report.html",
    }
    assert names == {path.name for path in out.iterdir()}
    assert "2 runs each, mean ± standard deviation" in result.output
    assert "The page: " in result.output
    assert "12 runs, 0 failed." in result.output
    assert 12 == len(list(out.glob("runs/short/*/*/decisions.npz")))


@pytest.mark.study
@pytest.mark.usefixtures("registry")
def test_a_comparison_in_which_nothing_is_counted_says_so(files: dict[str, Path], tmp_path: Path) -> None:
    result = call(files["alone"], "--runs", 1, "--decisions", 5, "--out", tmp_path / "out", "--set", "observers=[]")
    assert 0 == result.exit_code, result.output
    told = (
        "Nothing counts what the tutors achieve; name what does with --goal (there are: collided, contacts, distance_m"
    )
    assert told in result.output
    assert "The goal" not in result.output


@pytest.mark.study
@pytest.mark.usefixtures("registry")
def test_a_run_that_fails_is_named_and_the_exit_code_is_1(files: dict[str, Path], tmp_path: Path) -> None:
    setting = "world.fails_with_seed=5"
    result = call(files["full"], "--runs", 2, "--seed", 4, "--out", tmp_path / "out", "--set", setting, "--no-controls")
    assert 1 == result.exit_code
    told = " ".join(result.output.split())
    assert (
        "failed: short, full, seed 5: decision 0: world 'corridor': reset() raised RuntimeError: the wall fell down."
        in told
    )
    assert "1 runs, 1 failed." in told
    assert "What failed is run again by: tutorstudent compare --resume --out " in told


@pytest.mark.usefixtures("registry")
@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--vary", "world.scen=long"], "did you mean 'scene'"),
        (["--vary", "scene"], "--vary scene: write key=value"),
        (["--set", "decisions=none"], "full.yaml (with decisions=none): decisions: "),
        (["--set", "student.encoder=inch"], "no encoder named 'inch'"),
    ],
)
def test_a_mistake_is_an_error_of_ours_before_anything_is_written(
    files: dict[str, Path], tmp_path: Path, arguments: list[str], message: str
) -> None:
    result = call(files["full"], "--out", tmp_path / "out", *arguments)
    assert isinstance(result.exception, TutorStudentError)
    assert message in str(result.exception)
    assert not (tmp_path / "out").exists()


@pytest.mark.usefixtures("registry")
def test_a_folder_with_something_in_it_is_left_alone(files: dict[str, Path], tmp_path: Path) -> None:
    (tmp_path / "precious.txt").write_text("x")
    result = call(files["full"], "--out", tmp_path)
    assert isinstance(result.exception, PipelineError)
    assert "the folder is not empty; give a new one" in str(result.exception)
    result = call(files["full"], "--out", tmp_path / "precious.txt")
    assert "there is a file of that name; give a folder" in str(result.exception)


@pytest.mark.usefixtures("registry")
@pytest.mark.parametrize("inner", ["file/out", "x" * 300])
def test_a_folder_that_cannot_be_made_is_an_error_of_ours(files: dict[str, Path], tmp_path: Path, inner: str) -> None:
    (tmp_path / "file").write_text("x")
    result = call(files["full"], "--runs", 1, "--out", tmp_path / inner)
    assert isinstance(result.exception, PipelineError)
    assert f"{inner}: cannot be written: " in str(result.exception)


@pytest.mark.study
@pytest.mark.usefixtures("registry")
def test_what_could_not_be_saved_is_told_and_is_no_failure(
    files: dict[str, Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def forget(_: object) -> None:
        raise RuntimeError("it slipped my mind")

    monkeypatch.setattr("tutorstudent.core.files.rundir.flatten", forget)
    result = call(files["alone"], "--runs", 1, "--decisions", 5, "--out", tmp_path / "out")
    assert 0 == result.exit_code, result.output
    told = " ".join(result.output.split())
    assert "note: short, alone, seed 0: " in told
    assert "RuntimeError: it slipped my mind." in told


def test_no_pipeline_is_an_error_of_ours() -> None:
    assert "there is no pipeline; give at least one YAML file" in str(call().exception)


@pytest.mark.parametrize("option", ["--runs", "--workers", "--decisions"])
def test_nothing_can_be_done_zero_times(option: str, files: dict[str, Path]) -> None:
    assert 2 == call(files["full"], option, 0).exit_code


def test_every_option_has_a_help_text() -> None:
    command = typer.main.get_command(app)
    assert [] == [parameter.name for parameter in command.params if not getattr(parameter, "help", "")]


def test_a_missing_extra_is_named_with_its_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backends, "find_spec", lambda module: None if module == "joblib" else object())
    with pytest.raises(PipelineError, match=r"needs joblib; install it with: pip install 'tutorstudent\[study\]'"):
        backends.check_extras()
    backends.check_extras(("matplotlib",))


@pytest.mark.process
def test_the_command_can_be_imported_without_the_extras() -> None:
    import subprocess
    import sys

    program = (
        "import sys; import tutorstudent.command.compare; "
        "print([m for m in ('matplotlib', 'joblib', 'scipy', 'pybullet', 'sklearn') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert "[]" == done.stdout.strip()


def test_registry_fixture_really_finds_the_corridor(registry: Registry) -> None:
    assert "corridor" in [installed.cls.name for installed in registry.of("world")]
