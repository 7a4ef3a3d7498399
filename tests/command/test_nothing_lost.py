"""Whatever ends a run, what was decided before is kept in whole files, and a sentence says who, when and where."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from tests.distributions import install
from tutorstudent.core.running.arrays import Arrays, load_arrays

pytestmark = pytest.mark.process

PIPELINE = """\
seed: 3
decisions: 2500
world: broken
tutor: steady
student: {use: table, encoder: {use: ranges, ranges: []}, codec: kind-level-ampbit}
conditions: [hot]
"""


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """A folder with the plugin and a pipeline, in which the program works."""
    source = Path(__file__).with_name("broken_worlds.py").read_text(encoding="utf-8")
    install(tmp_path, "broken-worlds", source, point="broken")
    (tmp_path / "p.yaml").write_text(PIPELINE)
    return tmp_path


def begin(place: Path, *words: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", "tutorstudent", *words],
        cwd=place,
        env=os.environ | {"PYTHONPATH": str(place)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        preexec_fn=_heed_ctrl_c,
    )


def _heed_ctrl_c() -> None:
    """What is started in the background ignores it, and so do its children."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def run(place: Path, *settings: str, out: str = "out") -> tuple[int, str]:
    """Return exit code and standard error."""
    words = [word for setting in settings for word in ("--set", setting)]
    process = begin(place, "run", "p.yaml", "--out", out, *words)
    _, said = process.communicate(timeout=120)
    return process.returncode, leave_out_progress(said)


def leave_out_progress(said: str) -> str:
    return "".join(line for line in said.splitlines(keepends=True) if not line.startswith("p, seed 3"))


def kept(folder: Path) -> tuple[dict[str, object], Arrays]:
    """Return record and decisions of a run; nothing is left beside it."""
    assert [] == [path.name for path in [*folder.parent.iterdir(), *folder.iterdir()] if ".partial" in path.name]
    return json.loads((folder / "run.json").read_text()), load_arrays(folder / "decisions.npz")


@pytest.fixture
def whole(place: Path) -> Arrays:
    """The decisions of a run that nothing disturbs."""
    assert (0, "") == run(place, out="whole")
    record, decisions = kept(place / "whole")
    assert record["complete"] is True
    return decisions


def check_same(count: int, decisions: Arrays, whole: Arrays) -> None:
    assert count == len(decisions["kind"])
    assert whole.keys() == decisions.keys()
    for name in [name for name in whole if not name.endswith("_names")]:
        np.testing.assert_array_equal(whole[name][:count], decisions[name], err_msg=name)


@pytest.mark.parametrize(
    ("how", "code", "words"),
    [
        ("raise", 1, "world 'broken': step() raised IndexError: list index out of range."),
        ("leave", 1, "world 'broken': step() raised SystemExit: 0."),
        ("tuple", 2, "world 'broken': step(): returned a tuple of 5; that is what a Gymnasium environment returns;"),
        ("word", 2, "world 'broken': step(): the event 'heat' is None; return a number, or leave the event out."),
        ("none", 2, "world 'broken': step(): returned None; return a step, as in ts.Step(state,"),
        ("term", 143, "ended from outside"),
    ],
)
def test_a_run_that_fails_keeps_every_decision_before(
    place: Path, whole: Arrays, how: str, code: int, words: str
) -> None:
    status, said = run(place, f"world.how={how}", "world.at=1234")
    assert (code, 1) == (status, said.count("\n")), said
    assert said.startswith(f"tutorstudent: decision 1234: {words}")
    assert said.endswith(f"kept in {place / 'out'}; its run.json says that it is not complete.\n")
    record, decisions = kept(place / "out")
    assert (False, 1234) == (record["complete"], record["decided"])
    assert str(record["problem"]).startswith(f"decision 1234: {words}")
    check_same(1234, decisions, whole)
    assert {"pipeline.yaml", "run.json", "decisions.npz", "learned.npz"} == {
        path.name for path in (place / "out").iterdir()
    }


@pytest.mark.parametrize(
    ("how", "code", "words"),
    [
        ("exit", 1, "the process ended at once, with exit status 0, in world 'broken': step()."),
        ("crash", 139, "the process was ended by SIGSEGV, in world 'broken': step()."),
        ("kill", 137, "the process was ended by SIGKILL, in world 'broken': step()."),
    ],
)
def test_a_process_that_is_gone_leaves_all_but_the_last_thousand(
    place: Path, whole: Arrays, how: str, code: int, words: str
) -> None:
    status, said = run(place, f"world.how={how}", "world.at=2234")
    assert code == status, said
    assert said.endswith(
        f"tutorstudent: decision 2234: {words} What was decided before is kept in {place / 'out'}; its run.json says "
        "that it is not complete.\n"
    )
    record, decisions = kept(place / "out")
    assert (False, 2000) == (record["complete"], record["decided"])
    check_same(2000, decisions, whole)


def test_a_tutor_that_fails_is_named(place: Path) -> None:
    status, said = run(place, "tutor.fails_at=7")
    assert 1 == status
    assert said.startswith("tutorstudent: decision 7: tutor 'steady' raised OSError: no route to the arm. What was")
    assert 7 == kept(place / "out")[0]["decided"]


def test_a_failed_run_never_takes_the_place_of_a_complete_one(place: Path) -> None:
    assert 0 == run(place, "decisions=5")[0]
    status, said = run(place, "world.how=raise", "world.at=3")
    assert 1 == status
    assert f"kept in {place / 'out-failed'};" in said
    assert (True, 5) == (kept(place / "out")[0]["complete"], len(kept(place / "out")[1]["kind"]))
    assert 3 == kept(place / "out-failed")[0]["decided"]
    assert 0 == run(place, "decisions=6")[0]
    assert 6 == len(kept(place / "out")[1]["kind"])


def test_a_full_disk_leaves_whole_files_and_the_earlier_run(place: Path, whole: Arrays) -> None:
    status, said = run(place, "world.how=full", "world.at=1234", out="whole")
    assert (2, 1) == (status, said.count("\n")), said
    assert "decision 1999: the decisions cannot be written: File too large. Make room, or name another" in said
    assert f"kept in {place / 'whole-failed'};" in said
    check_same(2500, kept(place / "whole")[1], whole)
    left = place / "whole-failed"
    assert json.loads((left / "run.json").read_text())["complete"] is False
    check_same(1000, load_arrays(left / "block-0000000000.npz"), whole)
    assert [] == [path.name for path in left.iterdir() if 0 == path.stat().st_size]


def test_a_world_that_changes_the_folder_does_not_move_the_run(place: Path) -> None:
    assert 0 == run(place, "world.how=move", "decisions=5")[0]
    assert 5 == len(kept(place / "out")[1]["kind"])


def test_a_world_that_cannot_be_closed_costs_nothing(place: Path) -> None:
    status, said = run(place, "world.how=close", "decisions=5")
    assert (0, "tutorstudent: a part could not be closed: RuntimeError: the door is stuck.\n") == (status, said)
    assert kept(place / "out")[0]["complete"] is True


def test_a_thread_that_a_plugin_left_does_not_keep_the_run_from_ending(place: Path) -> None:
    status, said = run(place, "world.how=thread", "decisions=5")
    assert (0, "tutorstudent: a plugin left the thread 'pump' running; it is ended now.\n") == (status, said)


@pytest.mark.parametrize(("by", "code"), [(signal.SIGTERM, 143), (signal.SIGKILL, -9)])
def test_a_run_that_is_stopped_from_outside_keeps_what_was_decided(place: Path, by: int, code: int) -> None:
    words = ["--set", "world.how=stall", "--set", "world.at=1234"]
    process = begin(place, "run", "p.yaml", "--out", "out", *words)
    assert process.stderr is not None
    assert "stalled\n" == process.stderr.readline()
    process.send_signal(by)
    process.communicate(timeout=60)
    assert code == process.returncode
    wait_for(place / "out" / "run.json")
    record, decisions = kept(place / "out")
    assert (False, 1234, 1234) == (record["complete"], record["decided"], len(decisions["kind"]))
    assert "decision 1234: ended from outside" == record["problem"]


def test_ctrl_c_keeps_what_was_decided(place: Path) -> None:
    words = ["--set", "world.how=stall", "--set", "world.at=1234"]
    process = begin(place, "run", "p.yaml", "--out", "out", *words)
    assert process.stderr is not None
    assert "stalled\n" == process.stderr.readline()
    os.killpg(process.pid, signal.SIGINT)
    _, said = process.communicate(timeout=60)
    assert 130 == process.returncode
    assert "tutorstudent: decision 1234: interrupted. What was decided before is kept in " in said
    assert 1234 == kept(place / "out")[0]["decided"]


def wait_for(path: Path) -> None:
    until_s = time.monotonic() + 60
    while not path.exists() and time.monotonic() < until_s:
        time.sleep(0.05)


def test_two_processes_do_not_write_one_run(place: Path) -> None:
    first = begin(place, "run", "p.yaml", "--out", "out", "--set", "world.how=stall", "--set", "world.at=2")
    assert first.stderr is not None
    assert "stalled\n" == first.stderr.readline()
    status, said = run(place)
    first.send_signal(signal.SIGTERM)
    first.communicate(timeout=60)
    assert (
        2,
        f"tutorstudent: {place / 'out'}: another process is writing this run; wait for it, or name another folder.\n",
    ) == (status, said)


def test_what_a_killed_process_left_is_kept_when_the_folder_is_used_again(place: Path, whole: Arrays) -> None:
    left = place / ".out.partial"
    left.mkdir()
    (place / "whole" / "decisions.npz").rename(left / "block-0000000000.npz")
    (left / "run.json").write_text('{"complete": false, "problem": "gone"}')
    assert 0 == run(place, "decisions=5")[0]
    assert 5 == len(kept(place / "out")[1]["kind"])
    assert [] == [path.name for path in place.iterdir() if ".partial" in path.name]


def test_a_closed_standard_output_is_no_crash(place: Path) -> None:
    process = begin(place, "run", "p.yaml", "--out", "out", "--set", "decisions=5")
    assert process.stdout is not None
    assert process.stderr is not None
    process.stdout.close()
    said = leave_out_progress(process.stderr.read())
    process.stderr.close()
    assert (0, "") == (process.wait(timeout=60), said)
    assert 5 == len(kept(place / "out")[1]["kind"])
