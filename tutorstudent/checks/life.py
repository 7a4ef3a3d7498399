"""Checks of a part's life: bound, reset, used, closed."""

from __future__ import annotations

import contextlib
import io
import statistics
import time
from typing import Any

from tutorstudent.checks.likeness import take_snapshot
from tutorstudent.checks.outcome import RAISED, CheckFailed, CheckSkipped, describe_error, expect
from tutorstudent.checks.usage import Question, Usage, close, collect_answers, make_fresh


def works(usage: Usage) -> None:
    """It can be made, bound, used and closed without raising."""
    subject, doing = usage.subject, "made"
    questions = usage.make_usual()
    try:
        part = subject.make()
        doing = "bound (setup)"
        part = subject.make_bound()
        doing = "reset"
        usage.begin(part)
        for number, question in enumerate(questions, start=1):
            doing = f"asked question {number}"
            usage.ask(part, question)
        doing = "closed"
        part.close()
    except RAISED as error:
        raise CheckFailed(
            "it can be made, bound, reset, used and closed",
            f"{describe_error(error)}, when it was {doing}",
            "see the traceback; if it is made for other states, give them with examples() or states=[...]",
        ) from error


def resets_twice(usage: Usage) -> None:
    """A trial may begin before anything was done, after use, and twice in a row."""
    part = make_fresh(usage)
    try:
        usage.begin(part)
        usage.begin(part)
        collect_answers(usage, part)
        usage.begin(part)
        usage.begin(part)
        usage.ask(part, usage.make_usual()[0])
    except CheckSkipped:
        raise
    except RAISED as error:
        raise CheckFailed(
            "it can be reset at any time, twice in a row too",
            describe_error(error),
            "let reset() restore the beginning of a trial at any time; open things in setup()",
        ) from error


def closes_twice(usage: Usage) -> None:
    """It may be closed unused, and closed again."""
    unused, used = make_fresh(usage), make_fresh(usage)
    collect_answers(usage, used)
    close(used)
    try:
        for part in (used, unused, unused):
            part.close()
    except RAISED as error:
        raise CheckFailed(
            "close() lets go of what is held, and does nothing where nothing is",
            describe_error(error),
            "set what was closed to None, and close only what is not",
        ) from error


def keeps_what_it_learned_over_trials(usage: Usage) -> None:
    """`reset` forgets the trial only: what `state_dict` hands out is the same before and after."""
    part = make_fresh(usage)
    collect_answers(usage, part)
    learned = part.state_dict()
    if not learned:
        raise CheckSkipped("it has learned nothing that it hands out in state_dict()")
    before = take_snapshot(learned)
    usage.begin(part)
    expect(
        before == take_snapshot(part.state_dict()),
        "reset() keeps what was learned",
        "state_dict() changed",
        "forget only the trial; what was learned survives all trials",
    )


def prints_nothing(usage: Usage) -> None:
    """A part in a loop is silent: what it has to say belongs to `situation`, events or an observer."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
        part = make_fresh(usage)
        collect_answers(usage, part)
        close(part)
    expect(not out.getvalue(), "nothing is printed", f"{out.getvalue()[:200]!r}", "remove the print, or use logging")


def says_how_long_it_takes(usage: Usage) -> str:
    """Reports the median time of one question; it never fails for being slow."""
    times: list[float] = []

    def ask_timed(part: Any, question: Question) -> Any:
        start = time.perf_counter()
        answer = usage.ask(part, question)
        times.append(time.perf_counter() - start)
        return answer

    collect_answers(usage, make_fresh(usage), ask_timed)
    return f"median {statistics.median(times) * 1e6:.0f} us per decision"
