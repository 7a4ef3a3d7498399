"""The engine against a transcription of the thesis's numbered steps, over the whole decision space."""

from __future__ import annotations

import itertools
import random
from typing import NamedTuple

import pytest

from tests.core.oracle.scripted import KindStudent, LevelStudent, Says, ScriptedTutor
from tests.core.oracle.thesis import KINDS, Components, Period, Produced, Said, Taught, TutorStudentAlgorithm
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.words.proposals import KindProposal, LevelProposal
from tutorstudent.core.words.records import GradedAction, Lesson
from tutorstudent.plugins.amplifiers import LearningPhase
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.selectors import SameKind
from tutorstudent.plugins.streamlined.modifier import Modifier
from tutorstudent.sims.pioneer.types import DriveAction

NO_KIND = None
LEVELS = range(8)
SMALL = {
    "stop": Components(0.0, 0.0, 0.4),
    "forward": Components(0.1, -0.05, 0.0),
    "backward": Components(-0.15, 0.2, 0.5),
    "left": Components(0.3, 0.05, 1.0),
    "right": Components(-0.2, -0.1, 0.0),
}
LARGE = {
    "stop": Components(0.0, 0.0, 0.0),
    "forward": Components(0.65, 0.0, 0.0),
    "backward": Components(-0.95, 0.0, 2.0),
    "left": Components(0.0, 0.55, 0.0),
    "right": Components(0.0, -1.0, 0.0),
}


class Case(NamedTuple):
    """One point of the decision space."""

    tutor_kind: str
    student: Said
    violated: bool


def full_cases() -> list[Case]:
    """Return every case of the full algorithm: 5 kinds x (5 kinds and no kind) x 8 levels x 2 bits x 2 outcomes."""
    space = itertools.product(KINDS, (*KINDS, NO_KIND), LEVELS, (0, 1), (False, True))
    return [Case(tutor, Said(said, number, bit), violated) for tutor, said, number, bit, violated in space]


def streamlined_cases() -> list[Case]:
    """Return every case of the streamlined algorithm: the student names no kind."""
    space = itertools.product(KINDS, LEVELS, (0, 1), (False, True))
    return [Case(tutor, Said(NO_KIND, number, bit), violated) for tutor, number, bit, violated in space]


def history(cases: list[Case]) -> list[Period]:
    """Return the time periods in which every case is met inside and outside the learning phase, and is judged."""
    shuffled = [random.Random(seed).sample(cases, len(cases)) for seed in (1, 2)]
    met = [case for phase in shuffled for case in phase]
    met.append(Case("stop", Said("stop", 0, 0), False))  # one more, whose state judges the last case
    periods = []
    for number, case in enumerate(met):
        violated = number > 0 and met[number - 1].violated
        tutor = (SMALL if number % 2 else LARGE)[case.tutor_kind]
        periods.append(Period(number, violated, case.tutor_kind, tutor, case.student))
    return periods


def drive(period: Period) -> DriveAction:
    """Return what the tutor says in a period."""
    translation, rotation, duration = period.tutor
    return DriveAction(kind=period.tutor_kind, translation=translation, rotation=rotation, duration_s=duration)


def engine_for(streamlined: bool, learning_phase: int) -> Engine:
    """Return the real engine of shipped parts; the state is the period itself."""
    tutor = ScriptedTutor(act=drive)
    shared = {
        "tutor": tutor,
        "amplifier": LearningPhase(decisions=learning_phase),
        "evaluator": Conditions(),
        "conditions": [Says(violated=lambda period: period.violated)],
        "on_incident": "raise",
    }
    if streamlined:
        student = LevelStudent(propose=lambda m: LevelProposal(level=m.state.student[1], ampbit=m.state.student[2]))
        return Engine(student=student, selector=Modifier(), **shared)
    student = KindStudent(
        propose=lambda m: KindProposal(kind=m.state.student[0], level=m.state.student[1], ampbit=m.state.student[2])
    )
    return Engine(student=student, selector=SameKind(), **shared)


def said(graded: GradedAction) -> Said:
    """Return a graded action as the thesis says it."""
    return Said(graded.action.kind, graded.level, int(graded.ampbit))


def taught(lesson: Lesson) -> Taught:
    """Return a lesson as the thesis says it."""
    return Taught(lesson.moment.state.state, said(lesson.target))


def produced(engine: Engine, period: Period) -> Produced:
    """Return what the engine makes of a period."""
    told = len(engine.student.lessons)
    action = engine.step(period)
    executed = Components(round(action.translation, 9), round(action.rotation, 9), round(action.duration_s, 9))
    lessons = engine.student.lessons[told:]
    assert len(lessons) <= 1
    assert action.kind == period.tutor_kind
    decision = engine.pending
    lesson = taught(lessons[0]) if lessons else None
    return Produced(said(decision.selected), said(decision.resulting), executed, lesson)


@pytest.mark.parametrize(("streamlined", "count"), [(False, 1920), (True, 320)], ids=["3.2.3", "5.2.1"])
def test_every_case_is_decided_and_taught_as_the_thesis_says(streamlined: bool, count: int) -> None:
    cases = streamlined_cases() if streamlined else full_cases()
    periods = history(cases)
    assert count == len(periods) - 1
    engine, thesis = engine_for(streamlined, len(cases)), TutorStudentAlgorithm(streamlined, len(cases))
    for period in periods:
        expected = thesis.time_period(period)
        actual = produced(engine, period)
        assert expected == actual, f"period {period}"
    assert not engine.incidents


ROWS = {
    "C(a)i": (Said("forward", 3, 1), True, Said("forward", 3, 0)),
    "C(a)ii": (Said("forward", 3, 1), False, Said("forward", 4, 1)),
    "C(b)i": (Said("forward", 3, 0), True, Said("forward", 0, 0)),
    "C(b)ii": (Said("forward", 3, 0), False, Said("forward", 3, 1)),
}


@pytest.mark.parametrize("streamlined", [False, True], ids=["3.2.3", "5.2.1"])
@pytest.mark.parametrize("row", ROWS)
def test_each_row_of_the_evaluation_table_teaches_its_action(streamlined: bool, row: str) -> None:
    student, violated, expected = ROWS[row]
    engine = engine_for(streamlined, learning_phase=0)
    engine.step(Period(0, False, "forward", SMALL["forward"], student))
    engine.step(Period(1, violated, "left", SMALL["left"], student))
    assert [Taught(0, expected)] == [taught(lesson) for lesson in engine.student.lessons]


@pytest.mark.parametrize("streamlined", [False, True], ids=["3.2.3", "5.2.1"])
def test_the_learning_phase_overrules_the_ampbit_for_its_decisions_and_not_one_more(streamlined: bool) -> None:
    engine = engine_for(streamlined, learning_phase=3)
    levels = []
    for number in range(5):
        engine.step(Period(number, False, "left", SMALL["left"], Said("left", 2, 0)))
        levels.append(engine.pending.resulting.level)
    assert levels == [3, 3, 3, 2, 2]


@pytest.mark.parametrize("streamlined", [False, True], ids=["3.2.3", "5.2.1"])
@pytest.mark.parametrize("ampbit", [0, 1])
@pytest.mark.parametrize("learning_phase", [0, 100])
def test_a_stop_is_never_raised_and_has_level_0(streamlined: bool, ampbit: int, learning_phase: int) -> None:
    engine = engine_for(streamlined, learning_phase)
    for number in LEVELS:
        engine.step(Period(number, False, "stop", SMALL["stop"], Said("stop", number, ampbit)))
        assert 0 == engine.pending.selected.level == engine.pending.resulting.level
        assert not engine.pending.amplified


@pytest.mark.parametrize("streamlined", [False, True], ids=["3.2.3", "5.2.1"])
def test_the_first_decision_teaches_nothing_and_no_lesson_crosses_a_reset(streamlined: bool) -> None:
    engine = engine_for(streamlined, learning_phase=100)
    for number in range(6):
        if number == 3:
            engine.reset()
        engine.step(Period(number, False, "left", SMALL["left"], Said("left", 1, 1)))
    # 0 is taught by 1, 1 by 2; 2 is forgotten by the reset; 3 by 4, 4 by 5
    assert [lesson.moment.state.state for lesson in engine.student.lessons] == [0, 1, 3, 4]


@pytest.mark.parametrize("streamlined", [False, True], ids=["3.2.3", "5.2.1"])
def test_a_lesson_is_about_the_state_before_and_carries_the_state_after(streamlined: bool) -> None:
    engine = engine_for(streamlined, learning_phase=0)
    before = Period(0, False, "right", SMALL["right"], Said("right", 2, 1))
    after = Period(1, True, "stop", SMALL["stop"], Said("stop", 0, 0))
    engine.step(before)
    executed = engine.step(after)
    (lesson,) = engine.student.lessons
    assert before is lesson.moment.state
    assert after is lesson.outcome.state
    assert (lesson.moment.number, lesson.executed_level, lesson.outcome.violated) == (0, 3, ("says",))
    assert "right" == lesson.executed.kind != executed.kind
