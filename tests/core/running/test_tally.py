"""How often the student names the tutor's kind."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest

from tests.core.oracle.scripted import KindStudent, LevelStudent
from tests.core.toys import Pusher, Rail
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.running.observers import Tally
from tutorstudent.core.running.runner import run
from tutorstudent.core.words.proposals import KindProposal, LevelProposal, Proposal
from tutorstudent.plugins.amplifiers import Never
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.selectors import SameKind
from tutorstudent.plugins.streamlined.modifier import Modifier


def summary(proposals: Sequence[Proposal | None], naming: bool = True) -> dict[str, float]:
    """Return what is counted in a run in which the tutor pushes and the student proposes these."""
    student = (KindStudent if naming else LevelStudent)(propose=lambda moment: proposals[moment.number])
    selector: Any = SameKind() if naming else Modifier()
    engine: Engine[Any, Any, Any] = Engine(
        tutor=Pusher(), student=student, selector=selector, amplifier=Never(), evaluator=Conditions()
    )
    tally = Tally()
    run(engine, Rail(), len(proposals), observers=[tally])
    return dict(tally.summary())


def test_the_match_rate_is_the_share_of_all_decisions_in_which_the_kind_was_the_tutors() -> None:
    push = KindProposal(kind="push", level=0, ampbit=True)
    rest = KindProposal(kind="rest", level=0, ampbit=True)
    nothing = KindProposal(kind=None, level=0, ampbit=True)
    assert 0.4 == summary([push, rest, nothing, None, push])["match_rate"]
    assert 0.0 == summary([rest])["match_rate"]


@pytest.mark.parametrize("naming", [True, False])
@pytest.mark.parametrize("decisions", [0, 1, 2])
def test_a_student_that_says_nothing_has_no_match_rate(decisions: int, naming: bool) -> None:
    assert "match_rate" not in summary([None] * decisions, naming)


def test_a_student_that_names_no_kinds_has_no_match_rate() -> None:
    assert "match_rate" not in summary([LevelProposal(level=3, ampbit=True), None], naming=False)
