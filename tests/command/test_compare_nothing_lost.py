"""A comparison whose worlds break down goes on, says what failed, and leaves no process behind."""

from __future__ import annotations

import json
import os
import re
import signal
import time
from pathlib import Path

import pytest

from tests.command.test_nothing_lost import PIPELINE, begin, place

__all__ = ["place"]

pytestmark = [pytest.mark.process, pytest.mark.study]

WORDS = ["compare", "p.yaml", "--no-controls", "--runs", "2", "--decisions", "1500", "--out", "out"]


def set_up(place: Path, world: str) -> None:
    (place / "p.yaml").write_text(PIPELINE.replace("world: broken", f"world: {{use: broken, {world}}}"))


def compare(place: Path, *words: str) -> tuple[int, str]:
    process = begin(place, *WORDS, *words)
    _, said = process.communicate(timeout=60)
    return process.returncode, " ".join(said.split())


def records(folder: Path) -> list[tuple[bool, int]]:
    found = [json.loads(path.read_text()) for path in sorted(folder.rglob("run.json"))]
    return [(record["complete"], record.get("decided", record["decisions"])) for record in found]


def test_a_world_that_ends_the_program_is_a_failed_run_and_no_success(place: Path) -> None:
    set_up(place, "how: leave, at: 1234")
    status, said = compare(place)
    assert 1 == status, said
    assert 2 == said.count("decision 1234: world 'broken': step() raised SystemExit: 0.")
    assert [(False, 1234)] * 2 == records(place / "out")
    assert (place / "out" / "report.html").exists()


@pytest.mark.parametrize("how", ["exit", "crash"])
def test_a_world_that_ends_its_process_fails_by_itself(place: Path, how: str) -> None:
    set_up(place, f"how: {how}, at: 1234, deadly_from: 0.5")
    status, said = compare(place, "--workers", "2")
    assert 1 == status, said
    assert "a worker process died, and its run with it" in said
    assert sorted(records(place / "out"))[0] == (False, 1000)
    assert (place / "out" / "report.html").exists()


def test_a_world_that_ends_the_only_process_is_told(place: Path) -> None:
    set_up(place, "how: exit, at: 1234")
    status, said = compare(place)
    assert 1 == status
    assert "decision 1234: the process ended at once, with exit status 0, in world 'broken': step()." in said
    assert [(False, 1000)] == records(place / "out")


def test_a_world_that_cannot_be_closed_does_not_end_a_study(place: Path) -> None:
    set_up(place, "how: close")
    status, said = compare(place)
    assert 0 == status, said
    assert 2 == said.count("a part could not be closed: RuntimeError: the door is stuck.")


def workers_of(place: Path) -> set[int]:
    """Return the processes that work in a folder."""
    found = set()
    for path in Path("/proc").glob("[0-9]*"):
        try:
            if (path / "cwd").resolve() == place and not re.search(r"\) Z ", (path / "stat").read_text()):
                found.add(int(path.name))
        except OSError:
            continue
    return found


@pytest.mark.skipif(not Path("/proc/self/cwd").exists(), reason="needs a list of processes")
@pytest.mark.parametrize("by", [signal.SIGTERM, signal.SIGKILL])
def test_no_process_outlives_a_study(place: Path, by: int) -> None:
    set_up(place, "how: stall, at: 5")
    process = begin(place, *WORDS, "--workers", "2")
    assert process.stderr is not None
    stalled = 0
    while stalled < 2:
        line = process.stderr.readline()
        assert line, "the study ended before both workers stalled"
        stalled += line.count("stalled")  # two workers may write into one line
    assert len(workers_of(place)) >= 3
    os.kill(process.pid, by)
    process.communicate(timeout=60)
    assert process.returncode == {signal.SIGTERM: 143, signal.SIGKILL: -9}[by]
    until_s = time.monotonic() + 20
    while workers_of(place) and time.monotonic() < until_s:
        time.sleep(0.1)
    assert set() == workers_of(place)
