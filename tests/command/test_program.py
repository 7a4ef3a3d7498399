"""The command line: what it prints, what it writes, and how it says no."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import pytest
from typer.testing import CliRunner

from tests.distributions import install
from tutorstudent.command.program import app, main
from tutorstudent.core.running.arrays import load_arrays

EXAMPLES = Path(__file__).parents[2] / "examples" / "prototype2" / "tutorstudent_prototype2" / "pipelines"
FULL = EXAMPLES / "prototype2a.yaml"


def tutorstudent(*words: str, **env: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "tutorstudent", *words]
    return subprocess.run(command, capture_output=True, text=True, env=os.environ | env, check=False)


def said(words: list[str], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> tuple[int, str]:
    """Return exit code and standard error of the command line, run in this process."""
    monkeypatch.setattr(sys, "argv", ["tutorstudent", *words])
    with pytest.raises(SystemExit) as caught:
        main()
    return int(caught.value.code or 0), capsys.readouterr().err


@pytest.mark.process
def test_run_writes_a_directory_and_prints_its_summary(tmp_path: Path) -> None:
    out = tmp_path / "run"
    done = tutorstudent("run", str(FULL), "--decisions", "60", "--seed", "5", "--out", str(out), "--strict")
    assert 0 == done.returncode
    assert "attractors" in done.stdout
    assert f"written to {out}" in done.stdout
    assert {"pipeline.yaml", "run.json", "decisions.npz", "learned.npz"} == {path.name for path in out.iterdir()}
    record = json.loads((out / "run.json").read_text())
    assert (5, 60) == (record["seed"], record["decisions"])
    columns = load_arrays(out / "decisions.npz")
    assert 60 == len(columns["kind"])
    assert {"collided", "distance_m", "x_m", "y_m", "heading_rad"} <= set(columns["event_names"].tolist())


@pytest.mark.process
def test_a_run_repeats_from_its_own_pipeline(tmp_path: Path) -> None:
    one, other = tmp_path / "one", tmp_path / "other"
    assert 0 == tutorstudent("run", str(FULL), "--decisions", "80", "--out", str(one)).returncode
    assert 0 == tutorstudent("run", str(one / "pipeline.yaml"), "--out", str(other)).returncode
    first, second = load_arrays(one / "decisions.npz"), load_arrays(other / "decisions.npz")
    assert {name: array.tobytes() for name, array in first.items()} == {
        name: array.tobytes() for name, array in second.items()
    }


@pytest.mark.process
def test_settings_take_the_place_of_the_files_values(tmp_path: Path) -> None:
    words = ["run", str(FULL), "--decisions", "5", "--set", "student.hidden=3", "--set", "world.scene=cave-box"]
    assert 0 == tutorstudent(*words, "--out", str(tmp_path / "run")).returncode
    text = (tmp_path / "run" / "pipeline.yaml").read_text()
    assert "hidden: 3" in text
    assert "scene: cave-box" in text


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["run", "absent.yaml"], "tutorstudent: absent.yaml: there is no such file. Give the path of a YAML file."),
        (["run", str(FULL), "--set", "student.hiden=3"], "unknown option 'hiden' (did you mean 'hidden'?). Options:"),
        (["run", str(FULL), "--set", "tutor=protoype2"], "no tutor named 'protoype2' (did you mean 'prototype2'?)"),
        (["run", str(FULL), "--set", "selector=modifier"], "selector 'modifier' needs LevelProposal but student"),
        (["run", str(FULL), "--set", "world.scene=cave-bx"], "cave-bx"),
        (["run", str(FULL), "--set", "nonsense"], "--set nonsense: write key=value, as in --set world.scene=cave-box."),
        (["run", str(FULL), "--set", "decisions.x=3"], "decisions.x: 'decisions' is 10000, not a mapping; set"),
        (["run", str(FULL), "--set", "conditions.0=near"], "conditions.0: 'conditions' is ['bumped'], not a mapping"),
        (["report", "absent"], "absent"),
        (["run", str(FULL), "--out", __file__], "is a file; name a directory for the run."),
    ],
)
def test_a_mistake_is_one_sentence_and_exit_code_2(
    words: list[str], message: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.chdir(tmp_path)
    code, errors = said(words, capsys, monkeypatch)
    assert 2 == code
    assert errors.startswith("tutorstudent: ")
    assert message in errors
    assert 1 == errors.count("\n")


@pytest.mark.process
def test_no_mistake_shows_a_traceback(tmp_path: Path) -> None:
    (tmp_path / "p.yaml").write_text("tutor: [\n")
    done = tutorstudent("run", str(tmp_path / "p.yaml"))
    assert 2 == done.returncode
    assert "Traceback" not in done.stderr
    assert f"{tmp_path / 'p.yaml'}:2:1: not valid YAML" in done.stderr


@pytest.mark.process
def test_a_missing_pybullet_is_a_sentence_with_the_remedy(tmp_path: Path) -> None:
    (tmp_path / "pybullet.py").write_text("raise ImportError('no pybullet here')\n")
    done = tutorstudent("run", str(FULL), "--out", str(tmp_path / "run"), PYTHONPATH=str(tmp_path))
    assert 2 == done.returncode
    assert "needs pybullet; install it with: pip install 'tutorstudent[bullet]'" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.process
def test_a_broken_third_party_is_listed_with_reason_and_remedy_and_stops_nothing(tmp_path: Path) -> None:
    install(
        tmp_path,
        "acme-robots",
        "import shapely_that_is_not_there\n",
        version="2.1",
        point="acme-nav",
        module="acme_nav",
    )
    listed = tutorstudent("plugins", "list", PYTHONPATH=str(tmp_path))
    assert 0 == listed.returncode
    assert "not loaded: 'acme-nav' (acme-robots 2.1): No module named 'shapely_that_is_not_there'." in listed.stdout
    assert "Install 'shapely_that_is_not_there'" in listed.stdout
    words = ("run", str(FULL), "--set", "tutor=acme-nav", "--out", str(tmp_path / "run"))
    named = tutorstudent(*words, PYTHONPATH=str(tmp_path))
    assert 2 == named.returncode
    assert "the plugin 'acme-nav' (acme-robots 2.1) could not be loaded" in named.stderr
    assert "Traceback" not in named.stderr


@pytest.mark.process
def test_strict_exits_with_1_if_a_part_broke_its_contract(tmp_path: Path) -> None:
    install(
        tmp_path,
        "acme",
        "import tutorstudent as ts\n"
        "class Bad(ts.Student):\n"
        "    name = 'bad'\n"
        "    proposal = ts.LevelProposal\n"
        "    def propose(self, moment): raise RuntimeError('tired')\n"
        "    def teach(self, lesson): pass\n"
        "@ts.hookimpl\n"
        "def tutorstudent_components(): return [Bad]\n",
    )
    words = ["run", str(FULL), "--decisions", "7", "--set", "student=bad", "--set", "selector=modifier"]
    lenient = tutorstudent(*words, "--out", str(tmp_path / "a"), PYTHONPATH=str(tmp_path))
    assert 0 == lenient.returncode
    assert "incidents: student: raised: 7; the newest: RuntimeError: tired" in lenient.stdout
    assert 1 == tutorstudent(*words, "--out", str(tmp_path / "b"), "--strict", PYTHONPATH=str(tmp_path)).returncode


@pytest.mark.process
def test_a_run_is_not_lost_to_a_student_that_cannot_be_stored(tmp_path: Path) -> None:
    install(
        tmp_path,
        "acme",
        "import tutorstudent as ts\n"
        "class Bad(ts.Student):\n"
        "    name = 'bad'\n"
        "    proposal = ts.LevelProposal\n"
        "    def propose(self, moment): return ts.LevelProposal(level=1, ampbit=True)\n"
        "    def teach(self, lesson): pass\n"
        "    def state_dict(self): return {'mind': object()}\n"
        "@ts.hookimpl\n"
        "def tutorstudent_components(): return [Bad]\n",
    )
    words = ["run", str(FULL), "--decisions", "7", "--set", "student=bad", "--set", "selector=modifier"]
    done = tutorstudent(*words, "--out", str(tmp_path / "run"), PYTHONPATH=str(tmp_path))
    assert 0 == done.returncode
    assert "Traceback" not in done.stderr
    assert "learned" in done.stderr
    assert "attractors" in done.stdout
    assert {"pipeline.yaml", "run.json", "decisions.npz"} == {path.name for path in (tmp_path / "run").iterdir()}


@pytest.mark.process
def test_what_plugins_say_is_text_and_no_markup(tmp_path: Path) -> None:
    install(
        tmp_path,
        "acme",
        "import tutorstudent as ts\n"
        "@ts.condition('lost')\n"
        "def Lost(state):\n"
        "    'Subscribes to [/cmd_vel].'\n"
        "    return False\n"
        "@ts.hookimpl\n"
        "def tutorstudent_components(): return [Lost]\n",
    )
    listed = tutorstudent("plugins", "list", PYTHONPATH=str(tmp_path), COLUMNS="160")
    assert (0, "") == (listed.returncode, listed.stderr)
    assert "Subscribes to [/cmd_vel]." in listed.stdout


def test_the_installed_command_is_this_one() -> None:
    (script,) = metadata.entry_points(group="console_scripts", name="tutorstudent")
    assert main is script.load()


def test_plugins_list_prints_json() -> None:
    result = CliRunner().invoke(app, ["plugins", "list", "--json"])
    listed = json.loads(result.stdout)
    assert [] == listed["broken"]
    assert {"role", "name", "plugin", "distribution", "description"} == set(listed["parts"][0])
    assert all(part["description"] for part in listed["parts"])


def test_schema_prints_a_schema() -> None:
    result = CliRunner().invoke(app, ["schema"])
    assert "tutorstudent pipeline" == json.loads(result.stdout)["title"]


@pytest.mark.parametrize("words", [[], ["run"], ["compare"], ["report"], ["plugins", "list"], ["schema"]])
def test_every_command_has_help(words: list[str]) -> None:
    result = CliRunner().invoke(app, [*words, "--help"])
    assert 0 == result.exit_code
    assert "Usage:" in result.stdout


@pytest.mark.parametrize("earlier", [False, True])
def test_a_run_that_is_interrupted_before_it_begins_says_so_and_leaves_no_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, earlier: bool
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    out = tmp_path / "run"
    words = ["run", str(FULL), "--decisions", "5", "--out", str(out)]
    if earlier:
        assert 0 == CliRunner().invoke(app, words).exit_code
    kept = sorted(path.name for path in tmp_path.rglob("*"))
    monkeypatch.setattr("tutorstudent.core.files.keeping.try_pipeline", interrupted)
    result = CliRunner().invoke(app, words)
    assert 130 == result.exit_code
    assert "interrupted before the first decision; nothing was written." in result.stderr
    assert kept == sorted(path.name for path in tmp_path.rglob("*"))


def test_it_says_its_version() -> None:
    result = CliRunner().invoke(app, ["--version"])
    assert (0, f"tutorstudent {metadata.version('tutorstudent')}\n") == (result.exit_code, result.stdout)
