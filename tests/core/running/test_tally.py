"""How often the student names the tutor's kind."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from tutorstudent.core.running.observers import Tally
from tutorstudent.core.words.proposals import KindProposal, LevelProposal, Proposal


def summary(*proposals: Proposal | None) -> dict[str, float]:
    tally = Tally()
    for proposal in proposals:
        tutor_action = SimpleNamespace(kind="forward")
        decision: Any = SimpleNamespace(
            proposal=proposal,
            amplified=False,
            resulting=SimpleNamespace(level=0),
            moment=SimpleNamespace(tutor_action=tutor_action, situation=""),
        )
        turn: Any = SimpleNamespace(decision=decision, lesson=None, incidents=(), outcome=None)
        step: Any = SimpleNamespace(done=False)
        tally.observe(turn, step)
    return dict(tally.summary())


def test_the_match_rate_is_the_share_of_all_decisions_in_which_the_kind_was_the_tutors() -> None:
    forward = KindProposal(kind="forward", level=0, ampbit=True)
    left = KindProposal(kind="left", level=0, ampbit=True)
    nothing = KindProposal(kind=None, level=0, ampbit=True)
    assert 0.4 == summary(forward, left, nothing, None, forward)["match_rate"]
    assert 0.0 == summary(left)["match_rate"]


@pytest.mark.parametrize("proposals", [(), (None,), (LevelProposal(level=3, ampbit=True), None)])
def test_a_student_that_names_no_kinds_has_no_match_rate(proposals: tuple[Proposal | None, ...]) -> None:
    assert "match_rate" not in summary(*proposals)
