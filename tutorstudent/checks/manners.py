"""Checks of how a part treats what it is handed, and what it says."""

from __future__ import annotations

import math
from typing import Any

from tutorstudent.checks.likeness import damage, take_snapshot
from tutorstudent.checks.outcome import RAISED, CheckFailed, CheckSkipped, describe_error, expect
from tutorstudent.checks.usage import Question, Usage, collect_answers, make_fresh
from tutorstudent.core.roles.interfaces import Tutor

BROKEN_READINGS = (math.nan, math.inf, -math.inf)


def answers_are_sound(usage: Usage) -> None:
    """What it says is what its role declares: types, kinds, bounds, widths, names, finite numbers."""

    def ask_and_judge(part: Any, question: Question) -> None:
        usage.judge(part, question, usage.ask(part, question))

    collect_answers(usage, make_fresh(usage), ask_and_judge)


def changes_nothing_it_is_handed(usage: Usage) -> None:
    """States, moments, actions, lessons and all else are as they were when it is done with them."""
    asked = 0

    def ask_and_watch(part: Any, question: Question) -> Any:
        nonlocal asked
        asked += 1
        before = take_snapshot(question)
        try:
            answer = usage.ask(part, question)
        except RAISED as error:
            _check_refused_write(error)
            raise
        expect(
            before == take_snapshot(question),
            "what it is handed stays as it is",
            f"it changed what it was handed in question {asked}",
            "copy what you change: numpy's -=, sort() and x[...] = write into the shared state",
        )
        return answer

    collect_answers(usage, make_fresh(usage), ask_and_watch)


def survives_broken_readings(usage: Usage) -> None:
    """With NaN or infinite readings a tutor still acts soundly; others may raise, and go on soundly afterwards."""
    broken = _make_broken_questions(usage)
    part = _make_sound(usage)
    for question in broken:
        try:
            usage.judge(part, question, usage.ask(part, question))
        except RAISED as error:
            if isinstance(part, Tutor):
                raise CheckFailed(
                    "a tutor answers with a sound action where a reading is NaN or infinite",
                    describe_error(error),
                    "read it as the worst that it can mean; nothing can replace a tutor that fails",
                ) from error
    _check_goes_on(usage, part, "after readings that were NaN or infinite")


def goes_on_after_an_exception(usage: Usage) -> None:
    """It is asked again after it raised once: an exception must not leave it half done."""
    part = _make_sound(usage)
    try:
        usage.ask(part, usage.make_unreadable())
    except RAISED as error:
        _check_goes_on(usage, part, f"after it raised {type(error).__name__} once")
        return
    raise CheckSkipped("it does not raise, whatever it is handed")


def _make_sound(usage: Usage) -> Any:
    # A part in the middle of its work, whose answers were sound so far.
    try:
        answers_are_sound(usage)
    except CheckFailed as error:
        raise CheckSkipped("its answers are never sound, see the check 'answers_are_sound'") from error
    part = make_fresh(usage)
    collect_answers(usage, part)
    return part


def _check_goes_on(usage: Usage, part: Any, when: str) -> None:
    try:
        for question in usage.make_usual():
            usage.judge(part, question, usage.ask(part, question))
    except RAISED as error:
        raise CheckFailed(
            f"it works as before {when}",
            describe_error(error),
            "change its memory only when nothing can fail any more, and keep no NaN",
        ) from error


def _make_broken_questions(usage: Usage) -> list[Question]:
    if not usage.reads_states:
        raise CheckSkipped("it is handed no readings")
    states, broken = usage.states, []
    for reading in BROKEN_READINGS:
        for state in states:
            try:
                copy = damage(state, reading)
            except Exception:  # noqa: S112 - a state class may refuse what no sensor can say
                continue
            if take_snapshot(copy) != take_snapshot(state):
                broken.append(copy)
    if not broken:
        raise CheckSkipped("its states hold no floats that could be broken")
    return usage.make_questions(broken)


def _check_refused_write(error: BaseException) -> None:
    # numpy refuses to write into read-only arrays, pydantic and dataclasses into frozen objects.
    refused = ("read-only", "is frozen", "frozen_instance", "cannot assign to field")
    if any(word in str(error) for word in refused):
        raise CheckFailed(
            "what it is handed stays as it is",
            f"it tried to change it: {describe_error(error)}",
            "copy what you change",
        ) from error
