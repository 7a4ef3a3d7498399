"""The budget controller on closed forms, and the student that carries it (docs/guide/budgeted.md)."""

from __future__ import annotations

import itertools
import random
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest

import tutorstudent as ts
from tutorstudent.core.words.errors import ContractError
from tutorstudent.plugins.budgeted.controller import BudgetController, Pace
from tutorstudent.plugins.budgeted.student import Budgeted

PACE = Pace(budget=0.003, fall=0.1, climb=0.004, window=20)


def standing(level: float, pace: Pace = PACE) -> BudgetController:
    """Return a controller that has just asked for the whole part of a level."""
    controller = BudgetController(pace, level)
    controller.ask(8)
    return controller


def play(
    plant: Callable[[list[int]], bool], decisions: int, highest: int = 8, pace: Pace = PACE
) -> tuple[BudgetController, list[int], list[bool]]:
    """Return the controller, its levels and the violations of a plant that is a function of all levels so far."""
    controller = BudgetController(pace, 0.0)
    levels: list[int] = []
    violations: list[bool] = []
    for _ in range(decisions):
        levels.append(controller.ask(highest))
        violations.append(plant(levels))
        controller.learn(levels[-1], violations[-1])
    return controller, levels, violations


def bound(controller: BudgetController, start: float, decisions: int) -> float:
    """Return the most own violations that the theorem allows after the first one, at which the level was `start`."""
    pace = controller.pace
    return pace.budget * decisions + max(0.0, start - 1.0) / pace.fall + pace.window + 1


# Closed forms


def test_without_a_violation_it_climbs_steadily_to_the_highest_level_and_stays() -> None:
    _, levels, _ = play(lambda levels: False, 3000, highest=3)
    assert [0] * 250 + [1] * 250 + [2] * 250 == levels[:750]
    assert {3} == set(levels[750:])


@pytest.mark.parametrize("highest", [0, 1, 5])
def test_it_never_asks_for_more_than_there_is(highest: int) -> None:
    controller, levels, _ = play(lambda levels: False, 5000, highest)
    assert highest == max(levels)
    assert controller.level < highest + 1 + PACE.climb


def test_an_own_violation_takes_a_tenth_of_a_level_and_budget_gives_it_back() -> None:
    controller = standing(2.5)
    controller.learn(2, violated=True)
    assert pytest.approx(2.5 - 0.1 + 0.0003) == controller.level
    for _ in range(332):
        controller.learn(2, violated=False)
    assert pytest.approx(2.5, abs=4e-4) == controller.level


def test_at_a_level_where_the_budget_is_just_spent_it_stays() -> None:
    every_333rd = itertools.count(1)
    controller, _, _ = play(lambda levels: next(every_333rd) % 333 == 0 and levels[-1] > 0, 20_000)
    start = controller.level
    for number in range(1, 3331):
        controller.learn(1, violated=number % 333 == 0)
    assert abs(controller.level - start) < 0.11


def test_a_violation_without_amplification_before_it_is_the_controllers_own_and_costs_nothing() -> None:
    controller = BudgetController(PACE, 0.0)
    for _ in range(100):
        controller.learn(0, violated=True)
    assert 0 == controller.own
    assert pytest.approx(0.4) == controller.level


@pytest.mark.parametrize(("decisions_later", "own"), [(0, 1), (1, 1), (20, 1), (21, 0)])
def test_a_violation_is_its_own_as_far_as_the_window_reaches(decisions_later: int, own: int) -> None:
    controller = standing(3.0)
    for number in range(decisions_later + 1):
        controller.learn(3 if number == 0 else 0, violated=number == decisions_later)
    assert own == controller.own


def test_what_others_amplified_without_being_asked_is_not_its_own() -> None:
    controller = standing(0.5)
    controller.learn(3, violated=True)
    assert 0 == controller.own


def test_it_does_not_rise_where_less_was_executed_than_it_asked_for() -> None:
    controller = standing(2.5)
    for executed in (0, 1):
        controller.learn(executed, violated=False)
        assert 2.5 == controller.level
    controller.learn(2, violated=False)
    assert 2.504 == controller.level


def test_nothing_is_laid_to_what_was_amplified_before_the_trial() -> None:
    controller = standing(3.0)
    controller.learn(3, violated=False)
    controller.forget()
    controller.learn(0, violated=True)
    assert 0 == controller.own


def test_a_decision_that_teaches_nothing_is_remembered_as_amplified() -> None:
    controller = standing(3.0)
    controller.pass_over(3)
    controller.learn(0, violated=True)
    assert 1 == controller.own


def test_what_was_spent_beyond_the_budget_is_made_up_for() -> None:
    controller, levels, _ = play(lambda levels: levels[-1] > 0, 4000)
    assert controller.level <= 1.0
    first = levels.index(1)
    assert 1 == sum(levels[first : first + 300])  # one step over the edge, then back below it for its price


# The theorem: whatever the plant does, own violations stay within the budget in the long run


def cliff(at: int) -> Callable[[list[int]], bool]:
    return lambda levels: levels[-1] >= at


def late_cliff(at: int, delay: int) -> Callable[[list[int]], bool]:
    return lambda levels: len(levels) > delay and levels[-1 - delay] >= at


def moody(seed: int) -> Callable[[list[int]], bool]:
    draw = random.Random(seed)
    return lambda levels: draw.random() < 0.02 * levels[-1] ** 2


def spiteful() -> Callable[[list[int]], bool]:
    return lambda levels: max(levels[-21:]) > 0


PLANTS: dict[str, Callable[[list[int]], bool]] = {
    "always": lambda levels: True,
    "a cliff at 1": cliff(1),
    "a cliff at 4": cliff(4),
    "a late cliff at 2": late_cliff(2, 8),
    "a very late cliff at 4": late_cliff(4, 20),
    "moody": moody(1),
    "moody too": moody(2),
    "spiteful": spiteful(),
    "a change half-way": lambda levels: levels[-1] >= (6 if len(levels) < 10_000 else 2),
    "now and then nothing": lambda levels: levels[-1] > 0 and len(levels) % 500 < 30,
}


@pytest.mark.parametrize("plant", PLANTS)
@pytest.mark.parametrize(
    "pace", [PACE, Pace(0.02, 0.5, 0.01, 20), Pace(0.001, 0.05, 0.0, 20)], ids=["default", "fast", "slow"]
)
def test_own_violations_stay_within_the_budget_and_a_constant_whatever_the_plant_does(plant: str, pace: Pace) -> None:
    controller = BudgetController(pace, 0.0)
    levels: list[int] = []
    start, since = None, 0
    for _ in range(20_000):
        levels.append(controller.ask(8))
        before = controller.own, controller.level
        controller.learn(levels[-1], PLANTS[plant](levels))
        if start is None and controller.own:
            start = before[1]
        if start is not None:
            since += 1
            assert controller.own <= bound(controller, start, since) + 1e-6
    assert controller.own <= pace.budget * 20_000 + bound(controller, start or 0.0, 0)


@pytest.mark.parametrize(
    "options", [{}, {"fall": 20.0}, {"fall": 20.0, "window": 5, "climb": 0.0}, {"budget": 0.01, "fall": 1.0}]
)
@pytest.mark.parametrize("amplifier", ["never", "learning-phase"])
def test_the_bound_holds_in_a_wrapped_loop_with_slew_whatever_the_amplifier_raises(
    options: dict[str, Any], amplifier: str
) -> None:
    """The plant saves its violations for the end, where the budget of a whole run can be spent at once."""
    loop = ts.wrap(
        lambda y: 0.5,
        action=ts.scalar(-1, 1),
        condition=lambda y: y > 0,
        factor=1.8,
        student={"use": "budgeted"} | options,
        amplifier={"use": amplifier, "change": "multiplicative"},
    )
    student, command, start = loop.engine.student, 0.5, None
    for number in range(6000):
        spent = number in (1500,) or number > 5800
        command = loop.step(float(spent and command > 0.5))
        if start is None and student.own_violations:
            start = (number, student.level + student.options.fall)
    assert start is not None
    assert student.own_violations <= bound(student._controller, start[1], 6000 - start[0])


def test_the_book_balances_to_the_last_violation() -> None:
    """Without climb and ceiling: level = start + fall x (budget x decisions - own), counted exactly."""
    pace = Pace(0.25, 0.5, 0.0, 20)  # exact in binary
    controller, draw = standing(3.0, pace), random.Random(3)
    controller.learn(9, violated=True)
    for _ in range(999):
        controller.learn(9, violated=draw.random() < 0.4)
    expected = 3 + Fraction(1, 2) * (Fraction(1, 4) * 1000 - controller.own)
    assert expected == Fraction(controller.level)


def test_a_blind_twin_climbs_to_the_top_and_stays_where_it_violates() -> None:
    seeing, _, told = play(late_cliff(3, 8), 10_000)
    blind = BudgetController(PACE, 0.0)
    levels: list[int] = []
    untold = 0
    for _ in range(10_000):
        levels.append(blind.ask(8))
        untold += late_cliff(3, 8)(levels)
        blind.learn(levels[-1], violated=False)
    assert seeing.own == sum(told) <= 60
    assert untold > 100 * seeing.own


# The student


def loop_of(violated: Callable[[float], bool] = lambda y: False, **slots: Any) -> ts.Loop:
    return ts.wrap(
        lambda y: 0.5,
        action=ts.scalar(-1, 1),
        condition=violated,
        student={"use": "budgeted"} | slots.pop("student", {}),
        **slots,
    )


def test_a_wrapped_controller_is_amplified_step_by_step_to_what_factor_allows() -> None:
    loop = loop_of()
    commands = [loop.step(0.0) for _ in range(1000)]
    assert [0.55, 0.6, 0.65] == sorted({round(command, 9) for command in commands})
    assert 0.65 == round(commands[-1], 9)
    assert commands == sorted(commands)


def test_it_stands_just_below_what_the_limits_allow_so_that_the_first_violations_count() -> None:
    loop = loop_of(lambda y: y > 0)
    for _ in range(5000):
        loop.step(0.0)
    for _ in range(11):
        loop.step(1.0)
    loop.step(0.0)
    assert 2 == loop.engine.pending.resulting.level


def test_a_void_decision_teaches_nothing_but_is_remembered_as_amplified() -> None:
    loop = loop_of(lambda y: y > 0, student={"climb": 1.0})
    loop.step(0.0)
    loop.step(0.0)  # at level 1 from here on
    loop.step(0.0)
    loop.void("teleoperation")
    own = loop.engine.student.own_violations
    loop.step(1.0)
    assert own == loop.engine.student.own_violations
    loop.step(1.0)
    assert own + 1 == loop.engine.student.own_violations


def test_a_reset_ends_the_window_and_keeps_the_level() -> None:
    loop = loop_of(lambda y: y > 0, student={"climb": 1.0})
    for _ in range(3):
        loop.step(0.0)
    level = loop.engine.student.level
    loop.engine.reset()
    assert level == loop.engine.student.level
    loop.engine.student.teach(_lesson(0, violated=True))
    assert 0 == loop.engine.student.own_violations


def _lesson(level: int, violated: bool) -> ts.Lesson[Any, Any]:
    moment = ts.Moment(0, None, None, "")
    return ts.Lesson(
        moment, ts.GradedAction(None, level, True), level, None, ts.Outcome(None, ("bad",) * violated, None, {})
    )


def test_what_it_learned_is_taken_back() -> None:
    one, other = Budgeted(), Budgeted()
    for part in (one, other):
        part.setup()
    for number in range(3000):
        one.teach(_lesson(one.propose(ts.Moment(0, None, None, "")).level, violated=number == 2000))
    other.load_state_dict(one.state_dict())
    assert one.state_dict() == other.state_dict()
    assert (1, 3000) == (other.own_violations, other.state_dict()["decisions"])


@pytest.mark.parametrize(
    ("state", "problem"),
    [
        ({"level": 1.0, "own": 0}, "misses 'decisions'"),
        ({"level": float("nan"), "own": 0, "decisions": 1}, "'level': some of its values are not finite"),
        ({"level": [1.0, 2.0], "own": 0, "decisions": 1}, "'level': found the shape"),
        ({"level": 1.0, "own": 0, "decisions": 1, "more": 2}, "nothing named 'more'"),
        ({"level": 1.0, "own": -3, "decisions": 1}, "'own': found -3; it is a count"),
        ({"level": 1.0, "own": 0, "decisions": 0.5}, "'decisions': found 0.5; it is a count"),
    ],
)
def test_what_it_cannot_have_learned_is_refused_and_changes_nothing(state: dict[str, Any], problem: str) -> None:
    student = Budgeted()
    student.setup()
    before = student.state_dict()
    with pytest.raises(ContractError, match=problem):
        student.load_state_dict(state)
    assert before == student.state_dict()


@pytest.mark.parametrize(
    ("option", "bad"),
    [
        ("budget", 0.0),
        ("budget", 1.0),
        ("budget", float("nan")),
        ("fall", 0.0),
        ("climb", -0.1),
        ("window", -1),
        ("begin", -0.5),
    ],
)
def test_options_that_make_no_sense_are_refused(option: str, bad: float) -> None:
    with pytest.raises(ts.PipelineError, match=option):
        Budgeted(**{option: bad})
