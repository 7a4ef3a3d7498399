"""Other hands on the wheel: what was really executed."""

from __future__ import annotations

from typing import Any

import pytest

from tests.core.oracle.scripted import ListeningTutor, Says, ScriptedTutor, engine, forward, level
from tests.core.oracle.shapes import Flight, Oven, Valve
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.roles.leaves import Change
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import ContractError
from tutorstudent.plugins.amplifiers import LearningPhase, Never
from tutorstudent.sims.pioneer.types import DriveAction


def taught_after(said: Action, student: int, executed: Action, **others: Any) -> list[tuple[int, int]]:
    """Return (taught, executed) level of the lessons after something else was executed."""
    tutor = ScriptedTutor(act=lambda state: said)
    tutor.action = type(said)
    wrapped = engine(len, level(student), tutor=tutor, on_incident="raise", **others)
    wrapped.step(0)
    wrapped.executed(executed)
    wrapped.step(1)
    assert executed == wrapped.last.decision.executed
    return [(lesson.target.level, lesson.executed_level) for lesson in wrapped.student.lessons]


def drive(translation: float, kind: str = "forward", **others: float) -> DriveAction:
    """Return a command."""
    return DriveAction(kind=kind, translation=translation, **others)


@pytest.mark.parametrize(
    ("translation", "expected"),
    [(0.7, 5), (0.6, 4), (0.5, 3), (0.35, 1), (0.3, 1), (0.29, 0), (0.2, 0)],
)
def test_a_limiter_that_lowers_makes_the_lesson_about_the_level_really_reached(
    translation: float, expected: int
) -> None:
    assert [(expected, expected)] == taught_after(drive(0.2), 5, drive(translation))


@pytest.mark.parametrize(
    "executed",
    [
        drive(0.19),
        drive(-0.5),
        drive(0.9),
        drive(0.5, rotation=0.1),
        drive(0.5, duration_s=1.0),
        drive(-0.5, "backward"),
        drive(0.0, "stop"),
    ],
    ids=["less", "reverse", "more than was asked for", "turning too", "for longer", "another kind", "a stop"],
)
def test_what_is_no_amplification_of_the_tutors_action_teaches_nothing(executed: DriveAction) -> None:
    assert taught_after(drive(0.2), 5, executed) == []


def test_an_outward_component_on_the_other_side_of_neutral_teaches_nothing() -> None:
    assert taught_after(Valve(opening=0.3), 2, Valve(opening=-0.6)) == []
    assert taught_after(Valve(opening=0.3), 2, Valve(opening=0.7)) == [(2, 2)]


def test_a_vector_that_was_turned_teaches_nothing() -> None:
    said = Flight(kind="cruise", forward_mps=0.3, left_mps=0.4, up_mps=0.0)
    assert taught_after(said, 2, Flight(kind="cruise", forward_mps=0.36, left_mps=0.48, up_mps=0.0)) == [(2, 2)]
    assert taught_after(said, 2, Flight(kind="cruise", forward_mps=0.48, left_mps=0.36, up_mps=0.0)) == []
    assert taught_after(said, 2, Flight(kind="cruise", forward_mps=-0.36, left_mps=-0.48, up_mps=0.0)) == []


def test_of_two_components_the_slower_one_tells_the_level() -> None:
    said = Oven(kind="heat", power=40.0, fan=2.0)
    assert taught_after(said, 3, Oven(kind="heat", power=49.0, fan=3.4)) == [(1, 1)]
    assert taught_after(said, 3, Oven(kind="heat", power=49.0, fan=1.0)) == []


def test_a_level_below_the_selected_one_was_not_amplified() -> None:
    """The selected level is 4 and the resulting 5; a limiter executes 3, and that bumps: C(b)i teaches level 0."""
    bumped = [[Says(violated=lambda state: state == 1)] for _ in range(2)]
    lowered = taught_after(drive(0.2), 4, drive(0.5), amplifier=LearningPhase(decisions=10), conditions=bumped[0])
    reached = taught_after(drive(0.2), 4, drive(0.7), amplifier=LearningPhase(decisions=10), conditions=bumped[1])
    assert lowered == [(0, 3)]
    assert reached == [(4, 5)]


def test_slew_counts_from_what_was_really_executed() -> None:
    wrapped = engine(forward(0.1), level(8), limits=Limits(slew=2))
    wrapped.step(0)
    wrapped.step(1)
    assert wrapped.pending.resulting.level == 4
    wrapped.executed(drive(0.2))
    wrapped.step(2)
    assert wrapped.pending.resulting.level == 3


def test_the_tutor_hears_what_was_really_executed_and_not_what_was_decided() -> None:
    tutor = ListeningTutor(act=forward(0.1))
    wrapped = engine(len, level(3), tutor=tutor)
    wrapped.step(0)
    wrapped.executed(drive(0.2))
    wrapped.step(1)
    assert [drive(0.2)] == tutor.heard


def test_what_was_executed_is_kept_as_a_copy() -> None:
    wrapped = engine(forward(0.1), level(3))
    wrapped.step(0)
    mine = drive(0.2)
    wrapped.executed(mine)
    mine.__dict__["translation"] = 0.9
    wrapped.step(1)
    assert drive(0.2) == wrapped.student.lessons[0].executed


def test_executed_without_a_pending_decision_is_refused() -> None:
    wrapped = engine(forward(0.1), level(3))
    with pytest.raises(ContractError, match=r"executed\(\): no decision is pending; call it after step\(\)"):
        wrapped.executed(drive(0.2))


def test_executing_another_class_is_refused() -> None:
    wrapped = engine(forward(0.1), level(3))
    wrapped.step(0)
    with pytest.raises(ContractError, match=r"executed\(\): found Valve; expected the tutor's DriveAction\."):
        wrapped.executed(Valve(opening=0.1))  # type: ignore[arg-type]


def test_executing_an_action_that_was_tampered_with_is_refused() -> None:
    wrapped = engine(forward(0.1), level(3))
    wrapped.step(0)
    tampered = drive(0.2)
    tampered.__dict__["rotation"] = float("nan")
    with pytest.raises(ContractError, match=r"executed\(\)"):
        wrapped.executed(tampered)


class Breaking(Change):
    """Lawful until told to break."""

    name = "breaking"

    def setup(self) -> None:
        self.broken = False

    def fraction(self, amplification: float, magnitude: float) -> float:
        if self.broken:
            raise SystemExit("broken")
        return amplification


def test_a_change_that_breaks_while_the_executed_level_is_told_is_an_incident_and_teaches_nothing() -> None:
    change = Breaking()
    wrapped: Engine[Any, Any, Any] = engine(forward(0.1), level(3), amplifier=Never(change=change))
    wrapped.step(0)
    change.broken = True
    wrapped.executed(drive(0.2))
    change.broken = False
    wrapped.step(1)
    assert wrapped.student.lessons == []
    assert wrapped.incident_counts == {("amplifier", "raised"): 1}


@pytest.mark.parametrize("reported", [[drive(0.0, "stop")], [drive(0.3)], [drive(0.0, "stop"), drive(0.3)]])
def test_an_emergency_stop_is_not_taken_back_by_what_was_executed(reported: list[DriveAction]) -> None:
    wrapped = engine(len, level(5), tutor=ScriptedTutor(act=lambda state: drive(0.2)), on_incident="raise")
    wrapped.step(0)
    wrapped.void("emergency stop")
    for executed in reported:
        wrapped.executed(executed)
    wrapped.step(1)
    assert wrapped.last is not None
    assert (None, "emergency stop") == (wrapped.last.lesson, wrapped.last.void)


def test_a_void_without_a_reason_is_void() -> None:
    wrapped = engine(len, level(5), tutor=ScriptedTutor(act=lambda state: drive(0.2)), on_incident="raise")
    wrapped.step(0)
    wrapped.void("")
    wrapped.step(1)
    assert wrapped.last is not None
    assert (None, "no reason given") == (wrapped.last.lesson, wrapped.last.void)


def test_a_corrected_word_about_what_was_executed_counts() -> None:
    wrapped = engine(len, level(5), tutor=ScriptedTutor(act=lambda state: drive(0.2)), on_incident="raise")
    wrapped.step(0)
    wrapped.executed(drive(0.0, "stop"))
    wrapped.executed(drive(0.7))
    wrapped.step(1)
    assert wrapped.last is not None
    assert wrapped.last.lesson is not None
