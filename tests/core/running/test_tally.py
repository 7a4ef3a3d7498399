"""How often the student names the tutor's kind."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from tests.core.oracle.scripted import KindStudent, LevelStudent
from tests.core.toys import Push, Pusher, Rail
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.function_tutor import FunctionTutor
from tutorstudent.core.running.arrays import Arrays
from tutorstudent.core.running.observers import Tally
from tutorstudent.core.running.recorder import Recorder
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


def drive(said: float, level: int, decisions: int = 6) -> tuple[dict[str, float], Arrays]:
    """Return what is counted and recorded where a student asks for the same level in every decision."""
    propose = LevelStudent(propose=lambda moment: LevelProposal(level=level, ampbit=True))
    engine: Engine[Any, Any, Any] = Engine(
        tutor=FunctionTutor(lambda _: Push(kind="push", force=said), Push),
        student=propose,
        selector=Modifier(),
        amplifier=Never(),
        evaluator=Conditions(),
    )
    tally, recorder = Tally(), Recorder()
    run(engine, Rail(), decisions, observers=[tally, recorder])
    return dict(tally.summary()), recorder.arrays()


@pytest.mark.parametrize(("said", "ratio"), [(0.2, 2.5), (-0.2, 2.5), (0.8, 1.25)])
def test_the_executed_ratio_is_what_was_executed_as_a_multiple_of_what_was_said(said: float, ratio: float) -> None:
    summary, arrays = drive(said, level=3)
    assert pytest.approx(ratio) == summary["executed_ratio"]
    assert [pytest.approx(ratio)] * 6 == arrays["executed_ratio"].tolist()


def test_a_command_at_neutral_has_no_executed_ratio() -> None:
    summary, arrays = drive(0.0, level=3)
    assert "executed_ratio" not in summary
    assert np.isnan(arrays["executed_ratio"]).all()
