"""A study that is killed or interrupted at a random moment goes on where it stopped, and ends as an undisturbed one."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.study.conftest import results
from tutorstudent.study import Plan, run_plan

pytestmark = [pytest.mark.process, pytest.mark.study]


def finished(folder: Path) -> dict[Path, tuple[int, int]]:
    """Return inode and time of change of every complete run."""
    found = {}
    for parent, folders, files in os.walk(folder):  # unlike a glob it passes over folders that go meanwhile
        folders[:] = [below for below in folders if not below.startswith(".")]
        if "run.json" in files:
            state = (path := Path(parent, "run.json")).stat()
            found[path] = state.st_ino, state.st_mtime_ns
    return found


def _heed_ctrl_c() -> None:
    """What is started in the background ignores it, and so do its children."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


class Group:
    """A study as a process group of its own."""

    def __init__(self, site: Path, *arguments: object) -> None:
        environment = os.environ | {"PYTHONPATH": str(site)}
        self._process = subprocess.Popen(
            [sys.executable, *map(str, arguments)],
            env=environment,
            start_new_session=True,
            preexec_fn=_heed_ctrl_c,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.pid = self._process.pid

    def end(self, by: int = 0) -> tuple[int, str]:
        """Wait for the end, after a signal to the whole group where one is given."""
        if by:
            os.killpg(self.pid, by)
        _, said = self._process.communicate(timeout=600)
        return self._process.returncode, said

    def is_running(self) -> bool:
        return self._process.poll() is None


def kill_at_random(begin: Callable[[], Group], out: Path, moments: int) -> int:
    """Begin a study and go on with it, killed each time at a random moment; return how often that came in time."""
    rng, kills = random.Random(20), 0
    for _ in range(moments):
        there = finished(out)
        group = begin()
        while group.is_running() and len(finished(out)) <= len(there):
            time.sleep(0.02)
        time.sleep(rng.uniform(0, 0.4))
        kills += group.is_running()
        group.end(signal.SIGKILL if group.is_running() else 0)
        now = finished(out)
        assert there == {path: now[path] for path in there}
    return kills


def check_killed(begin: Callable[[], Group], undisturbed: Path, out: Path, moments: int) -> None:
    assert moments == kill_at_random(begin, out, moments)
    there = finished(out)
    status, said = begin().end()
    assert 0 == status, said
    now = finished(out)
    assert there == {path: now[path] for path in there}
    assert results(undisturbed) == results(out)
    assert not list(out.rglob(".*"))


PROGRAM = """\
import sys
from pathlib import Path
from tutorstudent.study import load_plan, run_plan
run_plan(load_plan(Path(sys.argv[1])), Path(sys.argv[2]), workers=2)
"""


def test_a_study_that_is_killed_ends_as_an_undisturbed_one(
    planned: Callable[..., Plan], corridor_distribution: Path, tmp_path: Path
) -> None:
    undisturbed, out = tmp_path / "undisturbed", tmp_path / "out"
    run_plan(planned(), undisturbed)

    def begin() -> Group:
        return Group(corridor_distribution, "-c", PROGRAM, undisturbed, out)

    check_killed(begin, undisturbed, out, 1)


def check_command_killed(site: Path, pipeline: Path, options: list[object], moments: int) -> None:
    undisturbed, out = pipeline.with_name("undisturbed"), pipeline.with_name("out")
    compare = ["-m", "tutorstudent", "compare", pipeline, *options, "--out"]
    assert 0 == Group(site, *compare, undisturbed).end()[0]
    check_killed(lambda: Group(site, *compare, out, "--resume", "--workers", 2), undisturbed, out, moments)


@pytest.mark.slow
def test_a_study_that_is_killed_ten_times_ends_as_an_undisturbed_one(
    files: dict[str, Path], corridor_distribution: Path
) -> None:
    check_command_killed(corridor_distribution, files["full"], ["--runs", 6, "--decisions", 2000], 10)


PIONEER = """\
world: {use: pioneer, scene: cave-box}
tutor: prototype2
student: {use: backprop, encoder: prototype2-bits}
conditions: [bumped]
observers: [attractors]
"""


@pytest.mark.slow
def test_a_study_of_the_pioneer_that_is_killed_ends_as_an_undisturbed_one(tmp_path: Path) -> None:
    pytest.importorskip("pybullet")
    path = tmp_path / "pioneer.yaml"
    path.write_text(PIONEER)
    check_command_killed(tmp_path, path, ["--runs", 3, "--decisions", 300, "--search-runs", 1], 3)


def test_ctrl_c_says_how_to_go_on_and_leaves_nobody_behind(
    files: dict[str, Path], corridor_distribution: Path, tmp_path: Path
) -> None:
    out = tmp_path / "my study"
    options = ["--runs", 20, "--decisions", 2000, "--workers", 2, "--out", out]
    group = Group(corridor_distribution, "-m", "tutorstudent", "compare", files["full"], *options)
    while group.is_running() and len(finished(out)) < 8:  # by then both workers have begun
        time.sleep(0.02)
    status, said = group.end(signal.SIGINT)
    assert 130 == status
    assert f"interrupted; go on with: tutorstudent compare --resume --out '{out}'" in said
    assert "Traceback" not in said
    assert is_over(group.pid)


def is_over(group: int) -> bool:
    """Return whether everybody in a process group has gone; joblib's caretaker goes a moment after the others."""
    for _ in range(200):
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.05)
    return False
