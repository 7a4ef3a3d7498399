"""Controllers in C, in POSIX shell and in a Python of their own drive worlds, as their README says."""

from __future__ import annotations

import importlib
import math
import shutil
import subprocess
import sys
import venv
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.rundir import run_pipeline
from tutorstudent.core.roles.binding import Binding
from tutorstudent.plugins.process import ProcessTutor
from tutorstudent.sims.gym import GymState
from tutorstudent.sims.pioneer.types import PioneerState

pytestmark = pytest.mark.process

HERE = Path(__file__).parents[1] / "examples" / "process"
COMPILER = shutil.which("cc")
SHELL = shutil.which("sh")
PATIENT_S = 20.0


def tutor_of(pipeline: str, **changes: Any) -> ProcessTutor:
    """Return the bound tutor of an example."""
    values = dict(Pipeline.read(HERE / pipeline).document.data["tutor"]) | changes
    if "action_of" in values:
        values["action_of"] = Pipeline.read(HERE / pipeline).registry.get("world", values["action_of"])()
    made = ProcessTutor(**{key: value for key, value in values.items() if key != "use"} | {"deadline_s": PATIENT_S})
    made.bind(Binding(7, "tutor", made.action))
    return made


def summary_of(pipeline: str, decisions: int, **changes: Any) -> dict[str, float]:
    """Return what a run of an example comes to."""
    values = {f"tutor.{key}": value for key, value in changes.items()} | {"tutor.deadline_s": PATIENT_S}
    finished = run_pipeline(Pipeline.read(HERE / pipeline).replaced({"decisions": decisions} | values))
    return dict(finished.summary)


@pytest.fixture(scope="module")
def compiled(tmp_path_factory: pytest.TempPathFactory) -> str:
    if COMPILER is None:
        pytest.skip("there is no C compiler")
    program = tmp_path_factory.mktemp("c") / "pendulum"
    flags = ["-O2", "-Wall", "-Wextra", "-Werror", "-std=c11"]
    subprocess.run([COMPILER, *flags, "-o", str(program), str(HERE / "pendulum.c"), "-lm"], check=True)
    return str(program)


def law(angle: float, speed: float) -> float:
    """The controller's law, written down a second time."""
    energy = speed**2 / 6 + 5 * math.cos(angle)
    wanted = -12 * angle - 2.5 * speed if abs(angle) < 0.4 else (5 - energy) * (-1 if speed < 0 else 1)
    return min(max(wanted, -2.0), 2.0)


def test_the_controller_in_c_follows_its_law(compiled: str) -> None:
    part = tutor_of("pendulum.yaml", program=[compiled])
    for angle in (-3.0, -0.5, -0.1, 0.0, 0.1, 0.39, 0.41, 3.1):
        for speed in (-6.0, -0.2, 0.0, 0.2, 6.0):
            state = GymState(np.array([math.cos(angle), math.sin(angle), speed]), -1.0, info={"number": 3})
            assert law(angle, speed) == pytest.approx(part.act(state).torque, abs=1e-5)
            assert ("catching" if abs(angle) < 0.4 else "swinging") == part.situation
    part.close()


def test_the_controller_in_c_swings_the_pendulum_up(compiled: str) -> None:
    summary = summary_of("pendulum.yaml", 200, program=[compiled])
    assert 0 == summary["incidents"]
    assert 0.5 < summary["share:catching"]


@pytest.mark.skipif(SHELL is None, reason="there is no shell")
def test_the_controller_in_shell_backs_off_and_turns_after_a_stall() -> None:
    part = tutor_of("bumper.yaml", program=[str(HERE / "bumper.sh")])
    sonar = np.full(16, 5.0)
    states = [PioneerState(sonar, (), stalled) for stalled in (False, True, *[False] * 9)]
    found = []
    for state in states:
        part.act(state)
        found.append(part.situation)
    assert ["driving", *["backing"] * 4, *["turning"] * 5, "driving"] == found
    part.act(PioneerState(sonar, (), True))
    part.reset()
    part.act(PioneerState(sonar, (), False))
    assert "driving" == part.situation
    part.close()


@pytest.mark.skipif(SHELL is None, reason="there is no shell")
def test_the_controller_in_shell_drives_the_pioneer() -> None:
    summary = summary_of("bumper.yaml", 60, program=[str(HERE / "bumper.sh")])
    assert 0 == summary["incidents"]
    assert 0 < summary["distance_m"]


def install_gains(version: str, folder: Path) -> None:
    """Put the example's package into a folder as an installer would: its module and its metadata."""
    about = folder / f"gains-{version}.dist-info"
    about.mkdir(parents=True)
    (about / "METADATA").write_text(f"Metadata-Version: 2.1\nName: gains\nVersion: {version}\n", encoding="utf-8")
    shutil.copy(HERE / "own-environment" / "gains" / "gains.py", folder)


def test_a_controller_keeps_its_own_version_of_a_package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # Ours is version 2.0, beside tutorstudent; the controller's is 1.0, in an environment of its own.
    theirs = tmp_path / "old"
    venv.create(theirs, symlinks=True)
    install_gains("1.0", theirs / "lib" / f"python{sys.version_info.major}.{sys.version_info.minor}" / "site-packages")
    install_gains("2.0", tmp_path / "ours")
    monkeypatch.syspath_prepend(str(tmp_path / "ours"))
    importlib.invalidate_caches()
    controller = str(HERE / "own-environment" / "controller.py")
    part = tutor_of("own-environment/damping.yaml", program=[str(theirs / "bin" / "python"), controller])
    action = part.act(GymState(np.array([1.0, 0.0, 2.0])))
    part.close()
    assert (-0.8, "gains 1.0") == (pytest.approx(action.torque), part.situation)
    assert "2.0" == metadata.version("gains")
