"""The guard's own promises: what it remembers, how it says it, and whose the recursion limit is."""

from __future__ import annotations

import sys
from typing import Any

import pytest

from tests.core.oracle.scripted import LevelStudent, engine, forward, level
from tutorstudent.core.deciding.guard import Breach, Guard
from tutorstudent.core.words.proposals import LevelProposal


def test_it_counts_all_incidents_and_remembers_the_newest_thousand() -> None:
    guard = Guard("continue")
    for number in range(1200):
        guard.attend(number)
        guard.record("student", ValueError(str(number)))
    assert {("student", "raised"): 1200} == guard.counts
    assert (200, 1199, 1000) == (guard.log[0].decision, guard.log[-1].decision, len(guard.log))


@pytest.mark.parametrize("error", [ValueError("x" * 2000), Breach("mutated", "x" * 2000)], ids=["raised", "breach"])
def test_no_message_is_longer_than_500_characters(error: Exception) -> None:
    guard = Guard("continue")
    guard.attend(0)
    guard.record("student", error)
    assert 500 == len(guard.log[0].message)


def test_a_breach_says_its_message_and_nothing_else() -> None:
    assert "do not do that." == str(Breach("mutated", "do not do that."))


def test_a_context_that_failed_once_does_not_fail_for_ever() -> None:
    guard = Guard("continue")
    guard.attend(0)
    blame = guard.blame("student")
    with blame:
        raise ValueError
    assert blame.failed
    with blame:
        pass
    assert not blame.failed


def proposing(act: Any) -> LevelStudent:
    """Return a student that does something before it proposes."""

    def propose(moment: Any) -> LevelProposal:
        act(moment)
        return LevelProposal(level=3, ampbit=False)

    return LevelStudent(propose=propose)


@pytest.mark.parametrize("raises", [False, True])
def test_a_part_that_changes_the_recursion_limit_is_blamed_and_the_limit_is_put_back(raises: bool) -> None:
    before = sys.getrecursionlimit()

    def meddle(moment: Any) -> None:
        sys.setrecursionlimit(before + 77)
        if raises:
            raise ValueError("and more")

    wrapped = engine(forward(0.1), proposing(meddle))
    assert 0.1 == wrapped.step(None).translation
    assert before == sys.getrecursionlimit()
    assert {("student", "raised" if raises else "mutated"): 1} == wrapped.incident_counts


def test_a_listener_that_changes_the_recursion_limit_is_blamed_too() -> None:
    before = sys.getrecursionlimit()

    class Meddling(type(level(1))):  # type: ignore[misc]
        def reset(self) -> None:
            sys.setrecursionlimit(before + 77)

    wrapped = engine(forward(0.1), Meddling(propose=level(1).options.propose))
    wrapped.reset()
    assert before == sys.getrecursionlimit()
    assert {("student", "mutated"): 1} == wrapped.incident_counts
    assert "Python's recursion limit was changed; it is the owner's." == wrapped.incidents[0].message


def test_the_owner_may_change_the_recursion_limit_between_decisions() -> None:
    before = sys.getrecursionlimit()
    wrapped = engine(forward(0.1), level(1))
    wrapped.step(None)
    try:
        sys.setrecursionlimit(before + 77)
        wrapped.step(None)
        assert before + 77 == sys.getrecursionlimit()
        assert not wrapped.incidents
    finally:
        sys.setrecursionlimit(before)
