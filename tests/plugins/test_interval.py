"""Teaching within an interval of decisions (Thesis 5.2.5)."""

from __future__ import annotations

from typing import Any

import pytest

from tests.core.toys import PIPELINE, toy_pipeline
from tutorstudent.core.deciding.judging import NO_MARGINS
from tutorstudent.core.files.rundir import run_pipeline
from tutorstudent.core.words.errors import PipelineError, TutorStudentError
from tutorstudent.core.words.records import Decision, GradedAction, Moment, Outcome
from tutorstudent.plugins.controls import Blind
from tutorstudent.plugins.evaluators import Conditions, Interval
from tutorstudent.sims.pioneer.types import DriveAction

FORWARD = DriveAction(kind="forward", translation=0.2)


def judged(part: Any, number: int, violated: tuple[str, ...] = ()) -> Any:
    graded = GradedAction(FORWARD, 1, True)
    decision = Decision(Moment(number, None, FORWARD, ""), graded._replace(level=0), graded, FORWARD, None)
    return part.evaluate(decision, Outcome(None, violated, None, NO_MARGINS))


@pytest.mark.parametrize(
    ("begin", "end", "taught"),
    [(0, None, range(10)), (3, None, range(3, 10)), (0, 4, range(4)), (3, 7, range(3, 7)), (9, 10, [9])],
)
def test_what_lies_in_the_interval_is_taught_and_nothing_else(begin: int, end: int | None, taught: Any) -> None:
    part = Interval(begin=begin, end=end)
    assert list(taught) == [number for number in range(10) if judged(part, number) is not None]


def test_within_it_the_lesson_is_the_other_evaluators() -> None:
    for violated in ((), ("bumped",)):
        assert judged(Conditions(), 5, violated) == judged(Interval(begin=5, end=6), 5, violated)
        assert judged(Blind(), 5, violated) == judged(Interval(evaluator=Blind()), 5, violated)


def test_by_default_it_teaches_about_everything() -> None:
    assert {"use": "interval", "begin": 0, "end": None, "evaluator": {"use": "conditions"}} == Interval().describe()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"begin": 5, "end": 5}, r"end \(5\) must be more than begin \(5\), or nothing is ever taught"),
        ({"begin": -1}, "option 'begin': input should be greater than or equal to 0"),
        ({"end": 0}, "option 'end': input should be greater than or equal to 1"),
        ({"evaluator": "conditions"}, "option 'evaluator' must be a part"),
    ],
)
def test_an_interval_that_is_none_is_refused(options: dict[str, Any], message: str) -> None:
    with pytest.raises(PipelineError, match=message):
        Interval(**options)


def test_a_pipeline_says_where_an_empty_interval_stands() -> None:
    text = PIPELINE + "evaluator: {use: interval, begin: 20, end: 10}\n"
    with pytest.raises(TutorStudentError, match=r"p.yaml:\d+:1: evaluator: .*must be more than begin \(20\)"):
        toy_pipeline(text).engine()


def test_a_run_is_taught_in_the_interval_and_its_violations_are_counted_throughout() -> None:
    text = PIPELINE + "evaluator: {use: interval, begin: 20, end: 30}\n"
    whole = run_pipeline(toy_pipeline())
    part = run_pipeline(toy_pipeline(text))
    assert whole.summary["decisions"] == whole.summary["taught"]
    assert 10 == part.summary["taught"]
    taught = part.decisions["taught_level"] >= 0
    assert [*range(20, 30)] == taught.nonzero()[0].tolist()
    assert part.decisions["violated"][~taught].any()
