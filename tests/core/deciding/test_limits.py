"""Cap, factor and slew: what the owner allows, and what is then recorded and taught (the behaviour contract, 2)."""

from __future__ import annotations

import itertools
from typing import Any, ClassVar

import pytest
from pydantic import ValidationError

import tutorstudent as ts
from tests.core.oracle.scripted import LevelStudent, ScriptedTutor, engine, forward, level
from tests.core.oracle.shapes import Oven, Valve
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.deciding.reach import find_highest
from tutorstudent.core.roles.leaves import change
from tutorstudent.core.words.actions import Action, AmplificationMap, component
from tutorstudent.core.words.proposals import LevelProposal
from tutorstudent.plugins.amplifiers import LearningPhase, Never
from tutorstudent.plugins.changes import Additive, Multiplicative
from tutorstudent.sims.pioneer.types import DriveAction


def decided(wrapped: Engine[Any, Any, Any], state: Any = None) -> tuple[int, int]:
    """Return the selected and the resulting level of one decision."""
    wrapped.step(state)
    return wrapped.pending.selected.level, wrapped.pending.resulting.level


def tutor(action: Action) -> ScriptedTutor:
    """Return a tutor that always says the same."""
    found = ScriptedTutor(act=lambda state: action)
    found.action = type(action)
    return found


def asking(script: Any) -> LevelStudent:
    """Return a student that proposes the script's levels."""
    levels = iter(script)
    return LevelStudent(propose=lambda moment: LevelProposal(level=next(levels), ampbit=False))


def test_the_default_cap_is_the_thesiss_eight_levels_and_nothing_else_is_limited() -> None:
    assert Limits().model_dump() == {"cap": 0.8, "factor": None, "slew": None}
    assert decided(engine(forward(0.0), level(9))) == (8, 8)


@pytest.mark.parametrize(("cap", "expected"), [(0.8, 8), (0.3, 3), (0.7, 7), (0.6, 6), (0.35, 3), (0.05, 0), (5.0, 11)])
def test_the_cap_lowers_the_level_that_is_executed_recorded_and_taught(cap: float, expected: int) -> None:
    wrapped = engine(forward(-0.9), level(11), limits=Limits(cap=cap))
    assert (expected, expected) == decided(wrapped)
    assert round(-0.9 + 0.1 * expected, 9) == round(wrapped.pending.executed.translation, 9)
    wrapped.step(None)
    lesson = wrapped.student.lessons[0]
    assert (expected, expected) == (lesson.target.level, lesson.executed_level)


def test_what_the_cap_takes_away_was_not_amplified() -> None:
    wrapped = engine(forward(0.0), level(8, ampbit=True), amplifier=LearningPhase(decisions=10))
    assert decided(wrapped) == (8, 8)
    assert not wrapped.pending.amplified


@pytest.mark.parametrize(
    ("translation", "factor", "expected"),
    [(0.4, 1.5, 2), (0.4, 1.0, 0), (0.4, 1.3, 1), (0.0, 3.0, 0), (-0.3, 1.0, 6), (0.9, 1.05, 0), (0.9, 1.2, 1)],
    ids=["two fit", "none fits", "one fits", "at zero", "through zero", "small room", "the bound is one level off"],
)
def test_the_factor_limits_the_magnitude_by_the_tutors_own(translation: float, factor: float, expected: int) -> None:
    wrapped = engine(forward(translation), level(8), limits=Limits(factor=factor))
    assert (expected, expected) == decided(wrapped)
    assert abs(wrapped.pending.executed.translation) <= factor * abs(translation) + 1e-9


def test_the_factor_counts_from_neutral() -> None:
    wrapped = engine(len, level(8), tutor=tutor(Oven(kind="hold", power=50.0, fan=2.0)), limits=Limits(factor=1.7))
    assert decided(wrapped) == (2, 2)
    assert round(wrapped.pending.executed.power, 9) == 56.0


def test_of_two_components_the_tighter_one_limits_both() -> None:
    wrapped = engine(len, level(5), tutor=tutor(Oven(kind="heat", power=60.0, fan=3.0)), limits=Limits(factor=2.0))
    assert decided(wrapped) == (1, 1)
    executed = wrapped.pending.executed
    assert (round(executed.power, 9), round(executed.fan, 9)) == (63.0, 4.0)


@pytest.mark.parametrize("magnitude", [0.2, 0.5, 0.75])
def test_a_multiplicative_change_is_a_factor_of_its_own(magnitude: float) -> None:
    wrapped = engine(forward(magnitude), level(9), amplifier=Never(change=Multiplicative()), limits=Limits(factor=1.3))
    assert decided(wrapped) == (3, 3)
    assert round(1.3 * magnitude, 9) == round(wrapped.pending.executed.translation, 9)


def test_slew_climbs_and_falls_by_at_most_its_levels() -> None:
    wrapped = engine(forward(0.0), asking([8, 8, 8, 8, 0, 0, 0, 0, 5]), limits=Limits(slew=3))
    assert [decided(wrapped)[1] for _ in range(9)] == [3, 6, 8, 8, 5, 2, 0, 0, 3]


def test_slowing_down_by_slew_is_not_taken_for_amplification() -> None:
    wrapped = engine(forward(0.0), asking([6, 6, 0, 0]), limits=Limits(slew=2), amplifier=LearningPhase(decisions=0))
    found = [decided(wrapped) for _ in range(4)]
    assert found == [(2, 2), (4, 4), (2, 2), (0, 0)]


def test_slew_counts_from_zero_after_a_change_of_kind() -> None:
    kinds = itertools.cycle(["forward", "forward", "left", "left"])
    wrapped = engine(lambda state: DriveAction(kind=next(kinds)), level(8), limits=Limits(slew=3))
    assert [decided(wrapped)[1] for _ in range(6)] == [3, 6, 3, 6, 3, 6]


def test_slew_counts_from_zero_after_a_reset() -> None:
    wrapped = engine(forward(0.0), level(8), limits=Limits(slew=3))
    assert [decided(wrapped)[1] for _ in range(2)] == [3, 6]
    wrapped.reset()
    assert decided(wrapped) == (3, 3)


def test_falling_back_goes_through_slew() -> None:
    wrapped = engine(forward(0.0), asking([4, 4]), limits=Limits(slew=2))
    executed = [wrapped.step(None) for _ in range(5)]  # the script ends: StopIteration
    assert [round(action.translation, 9) for action in executed] == [0.2, 0.4, 0.2, 0.0, 0.0]
    assert wrapped.incident_counts == {("student", "raised"): 3}
    assert wrapped.pending.resulting[1:] == (0, True)


def test_cap_and_factor_go_before_slew() -> None:
    speeds = iter([0.2, 0.2, 0.1])
    wrapped = engine(lambda state: forward(next(speeds))(state), level(8), limits=Limits(factor=3.0, slew=1, cap=2.0))
    assert [decided(wrapped)[1] for _ in range(3)] == [1, 2, 2]
    speeds = iter([0.4, 0.4, 0.2])
    wrapped = engine(lambda state: forward(next(speeds))(state), level(8), limits=Limits(factor=2.0, slew=2))
    assert [decided(wrapped)[1] for _ in range(3)] == [2, 4, 2]
    assert round(wrapped.pending.executed.translation, 9) == 0.4


def test_falling_back_goes_as_far_down_as_the_factor_asks_and_no_further() -> None:
    speeds = iter([0.6, 0.6, 0.2])
    wrapped = engine(lambda state: forward(next(speeds))(state), asking([8, 8]), limits=Limits(factor=1.5, slew=2))
    assert [decided(wrapped)[1] for _ in range(3)] == [2, 3, 1]
    assert round(wrapped.pending.executed.translation, 9) == 0.3


def test_an_enormous_level_is_lowered_by_few_questions() -> None:
    asked = itertools.count()

    @change("counting")
    def counting(amplification: float, magnitude: float) -> float:
        next(asked)
        return amplification

    wrapped = engine(forward(0.0), level(10**15), amplifier=Never(change=counting()))
    assert decided(wrapped) == (8, 8)
    assert next(asked) < 250


@pytest.mark.parametrize("fraction", [lambda a, m: 1 / (1 + a), lambda a, m: a % 0.31, lambda a, m: 0.9 - a / 100])
def test_a_change_that_does_not_grow_costs_amplification_and_breaks_no_limit(fraction: Any) -> None:
    odd = change("odd")(lambda amplification, magnitude: fraction(amplification, magnitude))
    for number in range(40):
        wrapped = engine(forward(0.1), level(number), amplifier=Never(change=odd()), limits=Limits(cap=0.25))
        action = wrapped.step(None)
        assert 0.1 <= action.translation <= 0.35 + 1e-9
        assert not wrapped.incidents


def test_at_neutral_an_outward_component_is_never_raised() -> None:
    wrapped = engine(len, level(0, True), tutor=tutor(Valve(opening=0.0)), amplifier=LearningPhase(decisions=9))
    assert decided(wrapped) == (0, 0)


@pytest.mark.parametrize(
    ("option", "bad"),
    [
        ("cap", 0),
        ("cap", -1.0),
        ("cap", float("nan")),
        ("cap", float("inf")),
        ("factor", 0.9),
        ("slew", 0),
        ("slaw", 1),
    ],
)
def test_limits_that_make_no_sense_are_refused(option: str, bad: float) -> None:
    with pytest.raises(ValidationError, match=option):
        Limits(**{option: bad})


def test_limits_are_frozen() -> None:
    with pytest.raises(ValidationError, match="frozen"):
        Limits().cap = 2.0  # type: ignore[misc]


def test_the_additive_change_is_the_default() -> None:
    assert isinstance(Never().change, Additive)
    assert Never().amount == 0.1


# A recorded level is one that moved something (docs/decisions/0013)

STANDING = {
    "at its bound": (forward(1.0), 8, 0, "bounds"),
    "one level off its bound": (forward(0.95), 8, 1, "bounds"),
    "exactly two levels off": (forward(0.8), 8, 2, "bounds"),
    "with nothing to move": (lambda state: DriveAction(kind="stop"), 8, 0, "nothing to move"),
    "free": (forward(0.1), 8, 8, ""),
}


@pytest.mark.parametrize("case", STANDING)
def test_a_recorded_and_taught_level_is_the_lowest_that_moves_as_far(case: str) -> None:
    act, asked, expected, by = STANDING[case]
    wrapped = engine(act, level(asked))
    assert (expected, expected) == decided(wrapped)
    wrapped.step(None)
    lesson = wrapped.student.lessons[0]
    assert (expected, expected) == (lesson.target.level, lesson.executed_level)
    assert by == wrapped.last.limited_by


@pytest.mark.parametrize("case", STANDING)
def test_a_level_that_moves_nothing_more_was_not_amplified(case: str) -> None:
    act, asked, expected, _ = STANDING[case]
    wrapped = engine(act, level(asked), amplifier=LearningPhase(decisions=100))
    assert (expected, expected) == decided(wrapped)
    assert not wrapped.pending.amplified


def test_slew_counts_from_the_level_that_moved_something() -> None:
    speeds = iter([0.1, 0.1, 1.0, 0.1, 0.1])
    wrapped = engine(lambda state: forward(next(speeds))(state), level(8), limits=Limits(slew=2))
    assert [2, 4, 0, 2, 4] == [decided(wrapped)[1] for _ in range(5)]


def test_a_change_that_stops_growing_keeps_its_levels_so_that_slew_can_pass_them() -> None:
    @change("three at most")
    def three_at_most(amplification: float, magnitude: float) -> float:
        return min(amplification, 0.3)

    wrapped = engine(forward(0.1), level(7), amplifier=Never(change=three_at_most()))
    assert (7, 7) == decided(wrapped)


def test_slew_climbs_over_levels_that_a_change_makes_equal() -> None:
    @change("pairs")
    def pairs(amplification: float, magnitude: float) -> float:
        return (round(10 * amplification) + 1) // 2 / 5

    wrapped = engine(forward(0.0), level(6), amplifier=Never(change=pairs()), limits=Limits(slew=1))
    assert [1, 2, 3, 4] == [decided(wrapped)[1] for _ in range(4)]


def test_a_change_that_moves_nothing_at_all_has_level_0() -> None:
    @change("none")
    def none(amplification: float, magnitude: float) -> float:
        return 0.0

    wrapped = engine(forward(0.1), level(7), amplifier=Never(change=none()))
    action = wrapped.step(None)
    assert 0.1 == action.translation
    assert (0, 0) == (wrapped.pending.selected.level, wrapped.pending.resulting.level)


def test_what_somebody_took_back_has_level_0_and_says_so() -> None:
    wrapped = engine(forward(0.1), level(3))
    wrapped.step(None)
    wrapped.executed(DriveAction(kind="forward", translation=0.1))
    assert 0 == wrapped.pending.resulting.level
    wrapped.evaluate(None)
    assert "executed" == wrapped.last.limited_by


class Press(Action):
    """A press that is let go upwards, and whose rest is its upper end."""

    force: float = component(-1.0, 0.0)
    amplification: ClassVar[AmplificationMap] = {"command": {"force": "+"}}


STOPPED = {
    "outward at its bound": (Valve(opening=2.0), "bounds"),
    "outward at its nearer bound": (Valve(opening=-1.0), "bounds"),
    "outward at neutral": (Valve(opening=0.0), "nothing to move"),
    "upward at neutral, which is its bound": (Press(force=0.0), "bounds"),
}


def test_what_was_taken_back_and_executed_after_all_is_limited_as_it_was_decided() -> None:
    wrapped = engine(forward(0.1), level(9), limits=Limits(cap=0.35))
    action = wrapped.step(None)
    wrapped.executed(DriveAction(kind="forward", translation=0.1))
    wrapped.executed(action)
    wrapped.evaluate(None)
    assert ("cap", 3) == (wrapped.last.limited_by, wrapped.last.decision.resulting.level)


@pytest.mark.parametrize("case", STOPPED)
def test_a_bound_is_told_from_having_nothing_to_move(case: str) -> None:
    action, by = STOPPED[case]
    wrapped = engine(len, level(3), tutor=tutor(action))
    assert action is wrapped.step("a state")
    wrapped.evaluate("another")
    assert by == wrapped.last.limited_by


def test_a_change_that_moves_nothing_has_nothing_to_move() -> None:
    @change("none")
    def none(amplification: float, magnitude: float) -> float:
        return 0.0

    wrapped = engine(forward(0.1), level(7), amplifier=Never(change=none()))
    wrapped.step(None)
    wrapped.evaluate(None)
    assert "nothing to move" == wrapped.last.limited_by


HIGHEST = {
    "the thesis's": (Additive(), 0.1, Limits(cap=0.8), 8),
    "cap": (Additive(), 0.1, Limits(cap=0.35), 3),
    "factor": (Multiplicative(), 0.1, Limits(factor=1.3), 3),
    "nothing": (Multiplicative(), 0.5, Limits(factor=1.3), 0),
    "more than eight": (Multiplicative(), 0.01, Limits(factor=1.3), 8),
}


@pytest.mark.parametrize("case", HIGHEST)
def test_the_highest_level_is_the_last_one_that_the_limits_allow_for_any_command(case: str) -> None:
    law, amount, limits, expected = HIGHEST[case]
    assert expected == find_highest(ts.scalar(-1, 1), Never(amount=amount, change=law), limits, 8)


def test_a_change_that_cannot_be_asked_leaves_all_levels() -> None:
    @change("broken")
    def broken(amplification: float, magnitude: float) -> float:
        raise SystemExit(3)

    assert 8 == find_highest(DriveAction, Never(change=broken()), Limits(), 8)
