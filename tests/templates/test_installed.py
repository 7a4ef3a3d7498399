"""The whole way of a third party, without a network: wheels, a fresh environment, and the commands of its README."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
NAME = "acme-walls"


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


QUIETLY = ("--quiet", "--no-index", "--disable-pip-version-check")


def call(*words: str | Path, cwd: Path | None = None) -> str:
    kept = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "PIP_"))}
    env = kept | {"TUTORSTUDENT_LOAD_PLUGINS": NAME, "COLUMNS": "200"}
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
    (found,) = [item for item in listed["components"] if item["name"] == NAME]
    assert ("tutor", NAME, f"{NAME} 0.1.0") == (found["role"], found["plugin"], found["distribution"])

    told = json.loads(environment.tutorstudent("plugins", "check", NAME, "--json", cwd=tmp_path))
    assert 0 == told["failed"]
    passed = {result["check"] for result in told["results"] if result["status"] == "passed"}
    assert {"works", "answers_are_sound", "same_answers_in_another_process"} <= passed

    words = ("run", project / "pipeline.yaml", "--decisions", "60", "--strict", "--out", tmp_path / "run")
    assert f"written to {tmp_path / 'run'}" in environment.tutorstudent(*words, cwd=tmp_path)
    assert f"use: {NAME}" in (tmp_path / "run" / "pipeline.yaml").read_text()
