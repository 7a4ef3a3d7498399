"""The whole way of a third party, without a network: wheels, a fresh environment, and the tutorial line by line."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path

import pytest

pytestmark = pytest.mark.process

ROOT = Path(__file__).parents[2]
TUTORIAL = ROOT / "docs" / "guide" / "tutorial.md"
NAME = "acme-walls"
NAME_IN_TUTORIAL = "my-tutor"
PROGRAMS = {"python": [], "pip": ["-m", "pip"]}
"""What an environment's interpreter is called with to be this program."""
SMALLER = {"run": ["--decisions", "60"], "compare": ["--runs", "1", "--decisions", "60", "--search-runs", "0"]}
"""Added to the tutorial's own words: of an option that is given twice, the later one holds."""


class Environment:
    """A fresh virtual environment, with the dependencies (not the packages under test) of the present one."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        venv.create(folder, with_pip=False)
        self.python = folder / "bin" / "python"

    def install(self, wheel: Path) -> None:
        call(sys.executable, "-m", "pip", "--python", self.python, "install", *QUIETLY, "--no-deps", wheel)

    def lend_dependencies(self) -> None:
        # After the installation, so that pip does not take the present environment's packages for its own. A .pth in
        # a directory that a .pth names is not read: what is installed there as editable cannot be imported.
        site = Path(str(call(self.python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))")).strip())
        (site / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n")

    def tutorstudent(self, *words: str | Path, cwd: Path) -> str:
        return call(self.folder / "bin" / "tutorstudent", *words, cwd=cwd)

    def typed(self, words: list[str], cwd: Path) -> str:
        """Do what somebody does who has activated this environment."""
        program, *rest = words
        if program == "tutorstudent":
            return self.tutorstudent(*rest, *SMALLER.get(rest[0], []), cwd=cwd)
        return call(self.python, *PROGRAMS[program], *rest, cwd=cwd)


QUIETLY = ("--quiet", "--no-index", "--disable-pip-version-check")
OFFLINE = {"PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}


def call(*words: str | Path, cwd: Path | None = None) -> str:
    kept = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "PIP_"))}
    env = kept | {"TUTORSTUDENT_LOAD_PLUGINS": f"{NAME},{NAME_IN_TUTORIAL}", "COLUMNS": "200", **OFFLINE}
    done = subprocess.run([str(word) for word in words], cwd=cwd, env=env, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def wheel_of(project: Path, out: Path) -> Path:
    call(sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", out, cwd=project)
    (wheel,) = out.glob("*.whl")
    return wheel


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> Environment:
    """Return an environment in which the wheel of this tree is installed."""
    fresh = Environment(tmp_path_factory.mktemp("venv"))
    fresh.install(wheel_of(ROOT, tmp_path_factory.mktemp("wheels")))
    fresh.lend_dependencies()
    return fresh


def test_a_third_partys_wheel_is_found_checked_and_run_from_yaml(environment: Environment, tmp_path: Path) -> None:
    imported = call(environment.python, "-c", "import tutorstudent; print(tutorstudent.__file__)", cwd=tmp_path)
    assert imported.startswith(str(environment.folder))

    environment.tutorstudent("plugins", "new", "tutor", NAME, cwd=tmp_path)
    project = tmp_path / NAME
    environment.install(wheel_of(project, tmp_path / "wheels"))

    listed = json.loads(environment.tutorstudent("plugins", "list", "--json", cwd=tmp_path))
    (found,) = [item for item in listed["parts"] if item["name"] == NAME]
    assert ("tutor", NAME, f"{NAME} 0.1.0") == (found["role"], found["plugin"], found["distribution"])

    told = json.loads(environment.tutorstudent("plugins", "check", NAME, "--json", cwd=tmp_path))
    assert 0 == told["failed"]
    passed = {result["check"] for result in told["results"] if result["status"] == "passed"}
    assert {"works", "answers_are_sound", "same_answers_in_another_process"} <= passed

    words = ("run", project / "pipeline.yaml", "--decisions", "60", "--strict", "--out", tmp_path / "run")
    assert f"written to {tmp_path / 'run'}" in environment.tutorstudent(*words, cwd=tmp_path)
    assert f"use: {NAME}" in (tmp_path / "run" / "pipeline.yaml").read_text()


def tutorial() -> list[list[str]]:
    """Return the words of each line of shell in the tutorial, from where its environment has been set up."""
    blocks = re.findall(r"^```(sh|console)\n(.*?)^```", TUTORIAL.read_text("utf-8"), flags=re.DOTALL | re.MULTILINE)
    lines = [line.removeprefix("$ ") for _, block in blocks[1:] for line in block.splitlines()]
    assert "venv" in blocks[0][1]
    return [shlex.split(line) for line in lines]


def test_the_tutorial_can_be_typed_line_by_line(environment: Environment, tmp_path: Path) -> None:
    folder = tmp_path
    said: dict[str, str] = {}
    for words in tutorial():
        if words[0] == "cd":
            folder /= words[1]
        else:
            said[" ".join(words)] = environment.typed(words, folder)

    assert "passed" in said["python -m pytest"]
    assert NAME_IN_TUTORIAL in said["tutorstudent plugins list"]
    assert 1 == len(list(folder.glob("runs/*/decisions.npz")))
    assert (folder / "studies" / "first" / "report.html").is_file()
    (compared,) = [text for line, text in said.items() if line.startswith("tutorstudent compare ")]
    assert {"tutor-alone", "blind", "ramp", "random"} <= set(re.findall(r"[a-z-]+", compared))
