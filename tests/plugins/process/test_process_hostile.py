"""Whatever a program does, the loop goes on, nothing is taken for the present answer that is not, and nothing stays."""

from __future__ import annotations

import gc
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import tutorstudent as ts
from tests.plugins.process.programs import (
    FRAME,
    LOOP,
    UNIT,
    answering,
    descriptors,
    eventually,
    python,
    runs,
    tutor,
)
from tutorstudent.plugins.process import ProcessTutor

pytestmark = pytest.mark.process

GENEROUS_S = 15.0
"""Far more than any deadline here; a loop that hangs would never come back at all."""

BAD_ANSWERS = {
    "hangs": ("time.sleep(1000)", "no answer within 0.2 s (deadline_s)"),
    "says half a line": ("sys.stdout.write('{\"type\":'); sys.stdout.flush()", "no answer within 0.2 s"),
    "floods stderr": ("while True: sys.stderr.write('x' * 70000)", "no answer within 0.2 s"),
    "answers the decision before, for ever": ("while True: answer(number - 1, 0.9)", "no answer within 0.2 s"),
    "dies": ("sys.exit(3)", "it ended with exit status 3. It is not restarted (restarts: 0)"),
    "is killed": ("os.kill(os.getpid(), 9)", "it was ended by signal 9."),
    "says why it dies": ("raise SystemExit('the motor is hot')", "Its standard error ends: the motor is hot"),
    "closes its output": ("os.close(1); time.sleep(1000)", "it closed its standard output."),
    "says garbage": ("say('garbage')", "it said 'garbage', which is no JSON object"),
    "says a megabyte": ("say('x' * 1_100_000)", "it said a line of more than 1000000 bytes (max_line_bytes)"),
    "never ends its line": ("while True: sys.stdout.write('x' * 70000)", "it said a line of more than 1000000 bytes"),
    "floods stdout": ("while True: say('{}')", 'it said \'{}\'; expected {"type":"action"'),
    "answers the next decision": ("answer(number + 1, 0.9)", "it answered decision 1, which it was not asked yet"),
    "answers out of bounds": ("answer(number, 7)", "its answer to decision 0 is not a ProcessAction: option 'value'"),
    "answers NaN": ("answer(number, float('nan'))", "its answer to decision 0 is not a ProcessAction"),
    "answers a string": ("answer(number, '0.5')", "its answer to decision 0 is not a ProcessAction"),
    "answers something more": (
        "say(json.dumps(dict(type='action', number=number, action=dict(value=0.5, speed=1))))",
        "unknown option 'speed'",
    ),
}


@pytest.mark.parametrize(("body", "message"), BAD_ANSWERS.values(), ids=BAD_ANSWERS)
def test_a_bad_answer_fails_the_decision_and_says_why(body: str, message: str) -> None:
    part = tutor(answering(body), deadline_s=0.2 if "0.2 s" in message else 20.0)
    begun_s = time.monotonic()
    with pytest.raises(ts.ContractError, match=re.escape(message)):
        part.act(50.0)
    part.close()
    assert time.monotonic() - begun_s < GENEROUS_S


@pytest.mark.parametrize("bad", ["hangs", "dies", "says garbage", "floods stdout", "answers out of bounds"])
def test_the_loop_goes_on_with_the_action_that_the_owner_wrote_down(bad: str) -> None:
    body, _ = BAD_ANSWERS[bad]
    part = ProcessTutor(program=answering(body), action=UNIT, deadline_s=0.05, close_timeout_s=0.0, backoff_s=0.0)
    loop = ts.wrap(part, on_tutor_failure={"value": -0.25})
    assert [-0.25] * 5 == [loop.step(1.0).value for _ in range(5)]
    assert {("tutor", "raised"): 5} == loop.engine.incident_counts
    loop.engine.close()


def test_a_slow_answer_is_never_taken_for_the_next_decision() -> None:
    # The first answer, 0.9, comes while the second decision is waited for.
    part = tutor(answering("time.sleep(0.5 if said == 1 else 0); answer(number, 0.9 if said == 1 else 0.1)"))
    with pytest.raises(ts.ContractError, match="no answer"):
        part.act(0.0)
    part.options.__dict__["deadline_s"] = 20.0
    assert 0.1 == part.act(0.0).value
    part.close()


def test_an_answer_that_was_guessed_in_advance_is_refused() -> None:
    body = """
        answers = [dict(type="action", number=number + i, action=dict(value=0.1 + i)) for i in (0, 1)]
        say("\\n".join(map(json.dumps, answers)))
    """
    part = tutor(answering(body), deadline_s=20.0)
    assert 0.1 == part.act(0.0).value
    with pytest.raises(ts.ContractError, match="it answered decision 1, which it was not asked yet"):
        part.act(0.0)
    part.close()


def test_an_answer_that_was_given_twice_counts_once() -> None:
    part = tutor(answering("answer(number, 0.1); answer(number, 0.9)"), deadline_s=20.0)
    assert [0.1] * 20 == [part.act(0.0).value for _ in range(20)]
    part.close()


def test_half_lines_are_put_together() -> None:
    body = """
        text = json.dumps(dict(type='action', number=number, action=dict(value=0.5))) + '\\n'
        for letter in text:
            sys.stdout.write(letter)
            sys.stdout.flush()
    """
    part = tutor(answering(body), deadline_s=20.0)
    assert [0.5, 0.5] == [part.act(0.0).value for _ in range(2)]
    part.close()


def test_a_program_that_complains_a_lot_is_heard_out() -> None:
    part = tutor(answering("sys.stderr.write('noise\\n' * 50_000); answer(number, 0.5)"), deadline_s=20.0)
    assert [0.5] * 3 == [part.act(0.0).value for _ in range(3)]
    part.close()


def test_a_program_that_does_not_read_blocks_nobody() -> None:
    script = 'import sys, time\nprint(\'{"type":"hello","protocol":1}\', flush=True)\ntime.sleep(1000)'
    part = tutor(python(script), deadline_s=0.02, patience=3)
    state = [0.0] * 300_000
    for _ in range(2):
        with pytest.raises(ts.ContractError, match="no answer within 0.02 s"):
            part.act(state)
        part.executed(part.action(value=0.5))
        part.reset()
    part.close()


def test_what_may_wait_for_a_program_that_does_not_read_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tutorstudent.plugins.process.program.PENDING", 100_000)
    script = 'import sys, time\nprint(\'{"type":"hello","protocol":1}\', flush=True)\ntime.sleep(1000)'
    part = tutor(python(script), deadline_s=0.02, patience=1000)
    with pytest.raises(ts.ContractError, match="no answer"):
        part.act([0.0] * 300_000)
    with pytest.raises(ts.ContractError, match="it does not read what it is told"):
        part.act(0.0)
    part.close()


def test_a_program_that_hangs_for_several_decisions_in_a_row_is_ended() -> None:
    part = tutor(answering("time.sleep(1000)"), deadline_s=0.02, patience=2)
    for _ in range(2):
        with pytest.raises(ts.ContractError, match="no answer within 0.02 s"):
            part.act(0.0)
    with pytest.raises(ts.ContractError, match=re.escape("no answer within 0.02 s (deadline_s), 2 times in a row")):
        part.act(0.0)
    part.close()


def test_a_program_that_died_is_started_again_and_asked_the_same(tmp_path: Path) -> None:
    # The first program dies of state 7 and leaves a file behind; its successor answers.
    body = """
        if state == 7 and not os.path.exists(sys.argv[1]):
            open(sys.argv[1], "w").close()
            sys.exit(3)
        answer(number, state / 100)
    """
    part = tutor([*answering(body), str(tmp_path / "second")], deadline_s=20.0, restarts=1)
    assert [0.05, 0.07, 0.08] == [part.act(state).value for state in (5, 7, 8)]
    part.close()


def test_after_the_last_restart_it_fails_for_good() -> None:
    part = tutor(answering("sys.exit(3)"), deadline_s=20.0, restarts=2)
    message = re.escape("it ended with exit status 3. It is not restarted (all 2 restarts are used up)")
    for _ in range(2):
        with pytest.raises(ts.ContractError, match=message):
            part.act(0.0)
    part.close()


def test_a_restart_that_is_not_due_yet_is_not_waited_for() -> None:
    part = tutor(answering("sys.exit(3)"), deadline_s=5.0, restarts=5, backoff_s=60.0)
    begun_s = time.monotonic()
    for _ in range(3):
        with pytest.raises(ts.ContractError, match=re.escape("exit status 3. It is restarted later (backoff_s)")):
            part.act(0.0)
    assert time.monotonic() - begun_s < GENEROUS_S
    part.close()


def test_a_restart_that_takes_long_does_not_hold_the_loop_up_and_ends_well(tmp_path: Path) -> None:
    # The second program says hello only when the test lets it.
    second, go = tmp_path / "second", tmp_path / "go"
    script = FRAME + f"second = os.path.exists({str(second)!r})\nopen({str(second)!r}, 'w').close()\n"
    script += f"while second and not os.path.exists({str(go)!r}): time.sleep(0.01)\n"
    script += LOOP + " " * 8 + "answer(number, 0.5) if second else sys.exit(3)"
    part = tutor(python(script), deadline_s=0.2, restarts=1, patience=1000, start_timeout_s=60)

    def outcome() -> str:
        try:
            return str(part.act(0.0).value)
        except ts.ContractError as error:
            return str(error)

    assert eventually(lambda: outcome().endswith("it ended with exit status 3. It is being restarted."))
    go.touch()
    assert eventually(lambda: outcome() == "0.5")
    part.close()


@pytest.mark.parametrize(
    ("program", "message"),
    [
        (["./there-is-none"], "it could not be started: [Errno 2] No such file or directory: './there-is-none'"),
        (["/etc/passwd"], "it could not be started: [Errno 13] Permission denied"),
        (["a\0b"], "it could not be started: embedded null byte"),
        (python("raise SystemExit('no licence')"), "it ended with exit status 1. Its standard error ends: no licence"),
        (python("print('ready', flush=True); input()"), "it said 'ready', which is no JSON object."),
        (python("import time; time.sleep(1000)"), "it said no hello within 0.3 s (start_timeout_s)."),
        (python('print(\'{"type":"hello","protocol":9}\', flush=True)'), "it speaks protocol 9; this is protocol 1"),
    ],
)
def test_a_program_that_does_not_start_is_told_at_assembly(program: list[str], message: str) -> None:
    timeout_s = 0.3 if "sleep" in program[-1] else 20.0
    with pytest.raises(ts.PipelineError, match=re.escape(message)) as caught:
        tutor(program, start_timeout_s=timeout_s)
    started = "It has to say hello on its standard output; docs/process-protocol.md shows how."
    remedy = "Its path counts from the working directory" if "be started" in message else started
    assert remedy in str(caught.value)


def test_a_folder_that_is_not_there_is_named() -> None:
    with pytest.raises(ts.PipelineError, match="could not be started: .*No such file or directory: '/nowhere'"):
        tutor(answering(), cwd="/nowhere")


CHILD = "child = subprocess.Popen([sys.executable, '-I', '-S', '-c', 'import time; time.sleep(1000)'], stdout={out})"


@pytest.mark.parametrize("out", ["subprocess.DEVNULL", "None"])
def test_a_grandchild_goes_with_the_program(out: str) -> None:
    # Where it inherits the pipes, the end of the program cannot be seen in them.
    body = f"{CHILD.format(out=out)}; answer(number, 0.5, situation=str(child.pid))"
    part = tutor(answering(body), deadline_s=20.0)
    part.act(0.0)
    child = int(part.situation)
    assert runs(child)
    part.close()
    assert eventually(lambda: not runs(child))


def test_a_program_that_dies_and_leaves_its_pipes_to_a_child_is_known_to_be_dead() -> None:
    part = tutor(answering(f"{CHILD.format(out='None')}; sys.exit(3)"), deadline_s=20.0)
    begun_s = time.monotonic()
    with pytest.raises(ts.ContractError, match="it ended with exit status 3"):
        part.act(0.0)
    assert time.monotonic() - begun_s < GENEROUS_S
    part.close()


def pid_of(part: ProcessTutor) -> int:
    part.act(0.0)
    return int(part.situation)


WHO = "answer(number, 0.5, situation=str(os.getpid()))"


def test_a_program_that_ignores_sigterm_and_the_end_of_its_input_is_ended_all_the_same() -> None:
    body = f"signal.signal(signal.SIGTERM, signal.SIG_IGN); {WHO}; time.sleep(1000)"
    part = tutor(answering(body), deadline_s=20.0)
    pid = pid_of(part)
    part.close()
    assert not runs(pid)
    part.close()
    with pytest.raises(ts.ContractError, match="it was closed"):
        part.act(0.0)


def test_a_tutor_that_nobody_closed_is_ended_when_it_is_forgotten() -> None:
    part = tutor(answering(WHO), deadline_s=20.0)
    pid = pid_of(part)
    del part
    gc.collect()
    assert not runs(pid)


def test_nothing_stays_open_behind_programs_that_failed() -> None:
    tutor(answering()).close()
    before = descriptors()
    for _ in range(3):
        part = tutor(answering("sys.exit(3)"), restarts=2, deadline_s=20.0)
        with pytest.raises(ts.ContractError, match="used up"):
            part.act(0.0)
        part.close()
    assert before == descriptors()


OWNER = """\
import sys, time
from tests.plugins.process.programs import answering, tutor
part = tutor(answering({body!r}), deadline_s=20.0)
part.act(0.0)
print(part.situation, flush=True)
{end}
"""
CLAN = f"""
{CHILD.format(out="subprocess.DEVNULL")}
answer(number, 0.5, situation=f"{{os.getpid()}} {{child.pid}}")
time.sleep(1000)
"""


@pytest.mark.parametrize("end", ["time.sleep(1000)", "sys.exit(0)", "raise RuntimeError", "import os; os._exit(1)"])
def test_no_program_outlives_its_owner_however_that_ends(end: str) -> None:
    script = OWNER.format(body=CLAN, end=end)
    owner = subprocess.Popen(
        [sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    )
    assert owner.stdout is not None
    pids = [int(word) for word in owner.stdout.readline().split()]
    if "sleep" in end:
        assert all(map(runs, pids))
        owner.send_signal(signal.SIGKILL)
    owner.wait()
    owner.stdout.close()
    assert 2 == len(pids)
    assert eventually(lambda: not any(map(runs, pids)))


def test_a_fork_of_the_owner_does_not_end_the_program() -> None:
    part = tutor(answering(WHO), deadline_s=20.0)
    if (fork := os.fork()) == 0:
        del part
        gc.collect()
        os._exit(0)
    os.waitpid(fork, 0)
    assert 0.5 == part.act(0.0).value
    part.close()
