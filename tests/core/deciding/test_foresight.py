"""What a student is told of a moment: margins as of now, and what each level would execute."""

from __future__ import annotations

import copy
import gc
import pickle
import sys
import weakref
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import tutorstudent as ts
from tests.core.oracle.scripted import LevelStudent, Measures, engine, forward
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.roles.leaves import change
from tutorstudent.core.words.proposals import LevelProposal
from tutorstudent.plugins.amplifiers import Never
from tutorstudent.plugins.changes import Multiplicative
from tutorstudent.plugins.controls import Constant


def looking(look: Callable[[ts.Moment[Any, Any]], Any], level: int = 0) -> tuple[LevelStudent, list[Any]]:
    """Return a student that proposes a level, and what it saw."""
    found: list[Any] = []

    def propose(moment: ts.Moment[Any, Any]) -> LevelProposal:
        found.append(look(moment))
        return LevelProposal(level=level, ampbit=False)

    return LevelStudent(propose=propose), found


@pytest.mark.parametrize(
    ("speed", "limits", "expected"),
    [
        (0.1, Limits(), [0, 1, 2, 3, 4, 5, 6, 7, 8, 8]),
        (0.1, Limits(cap=0.35), [0, 1, 2, 3, 3, 3, 3, 3, 3, 3]),
        (0.75, Limits(), [0, 1, 2, 3, 3, 3, 3, 3, 3, 3]),
        (0.1, Limits(slew=2), [0, 1, 2, 2, 2, 2, 2, 2, 2, 2]),
    ],
    ids=["free", "cap", "bounds", "slew"],
)
def test_a_student_is_told_which_level_would_be_executed(speed: float, limits: Limits, expected: list[int]) -> None:
    student, found = looking(lambda moment: [moment.levels.settle(level) for level in range(10)])
    engine(forward(speed), student, limits=limits).step(None)
    assert [expected] == found


@pytest.mark.parametrize("asked", range(10))
def test_what_is_foreseen_is_what_is_executed(asked: int) -> None:
    student, found = looking(lambda moment: (moment.levels.settle(asked), moment.levels.measure(asked)), asked)
    limits = Limits(slew=3, factor=4.0)
    wrapped = engine(forward(0.2), student, limits=limits)
    for _ in range(3):
        action = wrapped.step(None)
        level, sizes = found[-1]
        assert level == wrapped.pending.resulting.level
        assert (pytest.approx(action.translation),) == sizes


def test_slew_holds_foreseen_levels_up_too() -> None:
    student, found = looking(lambda moment: moment.levels.settle(0), 6)
    wrapped = engine(forward(0.1), student, limits=Limits(slew=3))
    for _ in range(3):
        wrapped.step(None)
    assert [0, 0, 3] == found


def test_the_highest_level_is_the_last_that_the_limits_allow_for_any_command() -> None:
    student, found = looking(lambda moment: moment.levels.highest)
    loop = ts.wrap(lambda state: state, action=ts.scalar(-1, 1), student=student)
    for state in (0.0, 0.5, 1.0):
        loop.step(state)
    assert [3, 3, 3] == found


def test_a_change_that_raises_when_it_is_asked_is_the_amplifiers_incident() -> None:
    @change("moody")
    def moody(amplification: float, magnitude: float) -> float:
        raise ValueError("not now")

    student, found = looking(lambda moment: (moment.levels.settle(3), moment.levels.measure(3)))
    wrapped = engine(forward(0.25), student, amplifier=Never(change=moody()))
    assert 0.25 == wrapped.step(None).translation
    assert [(0, (0.25,))] == found
    assert {("amplifier", "raised"): 2} == wrapped.incident_counts


def test_asking_what_a_level_would_do_changes_nothing() -> None:
    curious, _ = looking(lambda moment: [moment.levels.measure(level) for level in range(20)], 3)
    plain, _ = looking(lambda moment: None, 3)
    made = [
        engine(forward(0.3), student, amplifier=Never(change=Multiplicative()), limits=Limits(factor=1.25, slew=1))
        for student in (curious, plain)
    ]
    for _ in range(5):
        one, other = (wrapped.step(None) for wrapped in made)
        assert one == other
        assert made[0].pending.selected == made[1].pending.selected
    assert made[0].evaluate(None).limited_by == made[1].evaluate(None).limited_by == "factor"


def test_a_student_is_told_the_margins_of_this_very_state_once_one_was_judged() -> None:
    student, found = looking(lambda moment: moment.margins)
    wrapped = engine(
        forward(0.1),
        student,
        conditions=[Measures(violated=lambda state: False, margins=lambda state: [state], label="says")],
    )
    for state in (1.0, 2.0):
        wrapped.step(state)
    wrapped.reset()
    wrapped.step(3.0)
    assert [None, {"says": (2.0,)}, None] == found


def test_a_decision_that_is_over_is_let_go_at_once_also_where_nobody_collects() -> None:
    class Curious(Constant):
        def propose(self, moment: ts.Moment[Any, Any]) -> LevelProposal:
            moment.levels.measure(3)
            return super().propose(moment)

    loop = ts.wrap(lambda state: 0.1, action=ts.scalar(-1, 1), student=Curious(level=2))
    states = [np.zeros(3) for _ in range(5)]
    watched = [weakref.ref(state) for state in states]
    gc.disable()
    try:
        while states:
            loop.step(states.pop(0))
        assert [None, None] == [ref() for ref in watched[:2]]
    finally:
        gc.enable()


def test_a_copy_of_a_moment_keeps_all_but_the_levels() -> None:
    student, found = looking(lambda moment: (moment, copy.deepcopy(moment), pickle.loads(pickle.dumps(moment))))
    condition = Measures(violated=lambda state: False, margins=lambda state: [state], label="says")
    wrapped = engine(forward(0.1), student, conditions=[condition])
    wrapped.step(1.0)
    wrapped.step(2.0)
    own, *copies = found[-1]
    assert [own._replace(levels=None)] * 2 == copies
    assert {"says": (2.0,)} == copies[0].margins


def test_a_level_that_is_no_whole_number_is_the_students_incident() -> None:
    student, _ = looking(lambda moment: moment.levels.settle(2.5))
    wrapped = engine(forward(0.1), student)
    wrapped.step(None)
    assert {("student", "raised"): 1} == wrapped.incident_counts


def test_a_student_that_changes_the_recursion_limit_before_it_asks_is_blamed_itself() -> None:
    before = sys.getrecursionlimit()

    def meddle(moment: ts.Moment[Any, Any]) -> int:
        sys.setrecursionlimit(before + 77)
        return moment.levels.settle(3)

    student, _ = looking(meddle)
    wrapped = engine(forward(0.1), student)
    wrapped.step(None)
    assert {("student", "mutated"): 1} == wrapped.incident_counts
