"""One turn carries everything of a decision, and every part may hear it."""

from __future__ import annotations

from typing import Any

import pytest

from tests.core.oracle.scripted import ListeningTutor, Says, ScriptedTutor, engine, forward, level
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.roles.leaves import Change
from tutorstudent.core.roles.part import Field
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.records import GradedAction
from tutorstudent.core.words.turn import Turn
from tutorstudent.plugins.amplifiers import LearningPhase, Never
from tutorstudent.plugins.changes import Additive
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.streamlined.modifier import Modifier
from tutorstudent.sims.pioneer.types import DriveAction


class Hearing(Never[Any]):
    """An amplifier that remembers the turns."""

    def setup(self) -> None:
        self.turns: list[Turn[Any, Any]] = []

    def judged(self, turn: Turn[Any, Any]) -> None:
        self.turns.append(turn)


class Halving(Never[Any]):
    """Half as far after a violation, one level more after every second success: it reacts, and needs no student."""

    def setup(self) -> None:
        self._ceiling = 8

    def judged(self, turn: Turn[Any, Any]) -> None:
        if turn.outcome is not None:
            self._ceiling = self._ceiling // 2 if turn.outcome.violated else self._ceiling + 1

    def amplify(self, selected: GradedAction[Any], decision_number: int) -> GradedAction[Any]:
        return selected._replace(level=min(selected.level, self._ceiling))


def hearing(**others: Any) -> Engine[Any, Any, Any]:
    return engine(forward(0.1), level(3), amplifier=Hearing(), **others)


def test_a_part_hears_every_turn_once_and_whole() -> None:
    wrapped = hearing(conditions=[Says(violated=lambda state: state == 2)])
    for state in range(4):
        wrapped.step(state)
    turns = wrapped.amplifier.turns
    assert [0, 1, 2] == [turn.number for turn in turns]
    assert [(), ("says",), ()] == [turn.outcome.violated for turn in turns]
    assert [turn.lesson for turn in turns] == wrapped.student.lessons
    assert turns[-1] is wrapped.last


def test_a_part_hears_of_void_and_dropped_decisions_too() -> None:
    wrapped = hearing()
    wrapped.step(0)
    wrapped.void("joystick")
    wrapped.step(1)
    wrapped.drop()
    assert ["joystick", "dropped"] == [turn.void for turn in wrapped.amplifier.turns]
    assert [None, None] == [turn.lesson for turn in wrapped.amplifier.turns]
    assert wrapped.amplifier.turns[1].outcome is None


def test_a_nested_part_hears_turns_and_is_blamed_under_its_own_slot() -> None:
    class HearingChange(Additive):
        def judged(self, turn: Turn[Any, Any]) -> None:
            raise ValueError("cannot hear")

    wrapped = engine(forward(0.1), level(3), amplifier=Never(change=HearingChange()))
    wrapped.step(0)
    wrapped.step(1)
    assert {("amplifier.change", "raised"): 1} == wrapped.incident_counts
    assert ("amplifier.change",) == tuple(incident.part for incident in wrapped.last.incidents)


def test_a_strategy_that_reacts_to_violations_needs_nothing_but_an_amplifier() -> None:
    wrapped = engine(
        forward(0.1), level(8), amplifier=Halving(), conditions=[Says(violated=lambda state: state in (1, 2))]
    )
    levels = [wrapped.step(state) and wrapped.pending.resulting.level for state in range(5)]
    assert [8, 4, 2, 3, 4] == levels


@pytest.mark.parametrize("name", ["decision", "outcome", "lesson", "void", "limited_by", "incidents", "number"])
def test_a_turn_is_for_reading(name: str) -> None:
    wrapped = hearing()
    wrapped.step(0)
    wrapped.step(1)
    with pytest.raises(AttributeError):
        setattr(wrapped.last, name, None)


def test_what_a_listener_spoils_is_mended_and_blamed_on_it_alone() -> None:
    class Spoiling(Hearing):
        def judged(self, turn: Turn[Any, Any]) -> None:
            turn.decision.moment.tutor_action.__dict__["translation"] = 0.9

    conditions = [Says(violated=lambda state: False)]
    wrapped = engine(forward(0.1), level(3), amplifier=Spoiling(), conditions=conditions)
    wrapped.step(0)
    wrapped.step(1)
    assert {("amplifier", "mutated"): 1} == wrapped.incident_counts
    assert 0.1 == wrapped.last.decision.moment.tutor_action.translation
    assert 0.1 == wrapped.last.lesson.moment.tutor_action.translation
    assert 0.1 == wrapped.last.lesson.target.action.translation


def test_a_student_that_spoils_a_record_is_not_laid_at_a_listeners_door() -> None:
    class Spoiler(type(level(3))):  # type: ignore[misc]
        def teach(self, lesson: Any) -> None:
            lesson.moment.tutor_action.__dict__["translation"] = 0.9

    wrapped = engine(forward(0.1), Spoiler(propose=level(3).options.propose), amplifier=Hearing())
    wrapped.step(0)
    wrapped.step(1)
    assert {("student", "mutated"): 1} == wrapped.incident_counts
    assert 0.1 == wrapped.last.decision.moment.tutor_action.translation


LIMITED = {
    "cap": ({"cap": 0.25}, 8, forward(0.1), "cap", 2),
    "factor": ({"cap": 8.0, "factor": 3.0}, 8, forward(0.1), "factor", 2),
    "slew": ({"slew": 1}, 8, forward(0.1), "slew", 1),
    "nothing": ({}, 3, forward(0.1), "", 3),
    "a bound": ({"cap": 8.0}, 9, forward(0.75), "bounds", 3),
    "a bound and slew": ({"cap": 8.0, "slew": 5}, 9, forward(0.75), "bounds", 3),
    "a bound from the start": ({}, 9, forward(1.0), "bounds", 0),
}


@pytest.mark.parametrize("case", LIMITED)
def test_a_turn_says_which_limit_bound(case: str) -> None:
    limits, proposed, act, by, expected = LIMITED[case]
    wrapped = engine(act, level(proposed), limits=Limits(**limits), tutor=ScriptedTutor(act=act))
    wrapped.step(0)
    wrapped.evaluate(1)
    assert (by, expected) == (wrapped.last.limited_by, wrapped.last.decision.resulting.level)


def test_no_level_goes_beyond_the_highest_one() -> None:
    wrapped = engine(forward(0.1), level(10**9), amplifier=Never(amount=1e-6), limits=Limits(cap=1e6))
    wrapped.step(0)
    wrapped.evaluate(1)
    assert ("highest level", 1000) == (wrapped.last.limited_by, wrapped.last.decision.resulting.level)


def test_a_turn_says_that_slew_held_the_level_up() -> None:
    student = level(0)
    student.options.__dict__["propose"] = lambda moment: level(4 if moment.number < 4 else 0).options.propose(moment)
    wrapped = engine(forward(0.1), student, limits=Limits(slew=1))
    for state in range(6):
        wrapped.step(state)
    assert ("slew", 3) == (wrapped.last.limited_by, wrapped.last.decision.resulting.level)


def test_a_level_that_has_nothing_to_move_is_said() -> None:
    outward = engine(lambda state: DriveAction(kind="stop"), level(0, True), amplifier=LearningPhase(decisions=0))
    outward.step(0)
    outward.evaluate(1)
    assert 0 == outward.last.decision.resulting.level


def test_the_change_is_asked_for_each_level_once() -> None:
    asked: list[float] = []

    class Counting(Change):
        name = "counting"

        def fraction(self, amplification: float, magnitude: float) -> float:
            asked.append(round(amplification, 9))
            return amplification

    phase = LearningPhase(decisions=10, change=Counting())
    wrapped = engine(forward(0.1), level(3), amplifier=phase)
    wrapped.step(0)
    assert [0.3, 0.2, 0.4] == asked
    assert 4 == wrapped.pending.resulting.level


def test_no_level_is_executed_that_a_limit_forbids_even_where_the_change_goes_up_and_down() -> None:
    class Bump(Change):
        name = "bump"

        def fraction(self, amplification: float, magnitude: float) -> float:
            return 0.9 if round(10 * amplification) % 2 else 0.1

    wrapped = engine(forward(0.1), level(5), amplifier=Never(change=Bump()))
    assert 0.2 == round(wrapped.step(0).translation, 9)
    assert "cap" == wrapped.evaluate(1).limited_by


def closable(log: list[str], slot: str, base: type[Any], failing: bool) -> type[Any]:
    def close(self: Any) -> None:
        log.append(slot)
        if failing:
            raise OSError(f"{slot} is stuck")

    return type(base.__name__, (base,), {"close": close, "reset": close})


@pytest.mark.parametrize("action", ["close", "reset"])
@pytest.mark.parametrize("mode", ["continue", "raise"])
def test_all_parts_are_closed_and_reset_whatever_some_of_them_raise(action: str, mode: str) -> None:
    log: list[str] = []
    student = level(3)
    wrapped = engine(
        forward(0.1),
        closable(log, "student", type(student), failing=True)(propose=student.options.propose),
        selector=closable(log, "selector", Modifier, failing=True)(),
        amplifier=closable(log, "amplifier", Never, failing=False)(),
        evaluator=closable(log, "evaluator", Conditions, failing=False)(),
        on_incident=mode,
    )
    if mode == "raise":
        with pytest.raises(ContractError, match="is stuck"):
            getattr(wrapped, action)()
    else:
        getattr(wrapped, action)()
    assert ["student", "selector", "amplifier", "evaluator"] == log
    assert {("student", "raised"): 1, ("selector", "raised"): 1} == wrapped.incident_counts


def test_a_parts_own_parts_are_all_closed_whatever_some_of_them_raise() -> None:
    log: list[str] = []

    class Two(Never[Any]):
        class Options(Never.Options):
            """Two changes."""

            change: Any = Field(description="one")
            other: Any = Field(description="another")

    stuck, sound = (closable(log, name, Additive, name == "stuck")() for name in ("stuck", "sound"))
    with pytest.raises(OSError, match="stuck is stuck"):
        Two(change=stuck, other=sound).close()
    assert ["stuck", "sound"] == log


def test_the_tutor_hears_the_turn_after_it_has_heard_what_was_executed() -> None:
    log: list[str] = []

    class Both(ListeningTutor):
        def executed(self, action: Any) -> None:
            log.append("executed")

        def judged(self, turn: Turn[Any, Any]) -> None:
            log.append("judged")

    wrapped = engine(forward(0.1), level(3), tutor=Both(act=forward(0.1)))
    wrapped.step(0)
    wrapped.step(1)
    assert ["executed", "judged"] == log
