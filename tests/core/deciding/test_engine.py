"""The engine's life: steps, trials, records, learned state."""

from __future__ import annotations

from typing import Any

import pytest

from tests.core.oracle.scripted import LevelStudent, ListeningTutor, Measures, Says, engine, forward, level
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.guard import REMEMBERED
from tutorstudent.core.roles.part import Learned
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.proposals import LevelProposal
from tutorstudent.plugins.amplifiers import LearningPhase
from tutorstudent.plugins.controls import Random


def measuring(**others: Any) -> Engine[Any, Any, Any]:
    """Return an engine whose states are numbers, violated below zero, with the number as its margin."""
    condition = Measures(violated=lambda x: x < 0, margins=lambda x: [x], label="near")
    return engine(forward(0.1), level(1), conditions=[condition], **others)


def test_a_step_is_an_evaluation_and_a_propagation() -> None:
    whole, halves = measuring(), measuring()
    for state in (3.0, -1.0, 2.0, -4.0):
        expected = whole.step(state)
        halves.evaluate(state)
        assert expected == halves.propagate(state)
        assert whole.last == halves.last
        assert whole.pending == halves.pending


def test_nothing_is_judged_before_the_first_decision() -> None:
    fresh = measuring()
    assert fresh.evaluate(-1.0) is None
    assert fresh.last is None
    assert fresh.pending is None


def test_a_turn_tells_the_whole_decision() -> None:
    wrapped = measuring()
    executed = wrapped.step(2.0)
    wrapped.step(-3.0)
    turn = wrapped.last
    assert (turn.decision.moment.number, turn.decision.moment.state, turn.decision.moment.situation) == (0, 2.0, "")
    assert executed == turn.decision.executed
    assert (turn.outcome.state, turn.outcome.violated) == (-3.0, ("near",))
    assert turn.lesson == wrapped.student.lessons[0]
    assert (turn.incidents, turn.void) == ((), "")


def test_margins_before_are_those_of_the_previous_state_or_none_where_it_was_never_judged() -> None:
    wrapped = measuring()
    for state in (5.0, 4.0, 3.0):
        wrapped.step(state)
    lessons = wrapped.student.lessons
    assert [lesson.outcome.margins_before for lesson in lessons] == [None, {"near": (4.0,)}]
    assert [lesson.outcome.margins for lesson in lessons] == [{"near": (4.0,)}, {"near": (3.0,)}]


def test_margins_before_do_not_cross_a_reset() -> None:
    wrapped = measuring()
    wrapped.step(5.0)
    wrapped.step(4.0)
    wrapped.reset()
    wrapped.step(3.0)
    wrapped.step(2.0)
    assert wrapped.student.lessons[-1].outcome.margins_before is None


def test_margins_before_are_none_after_a_dropped_decision() -> None:
    wrapped = measuring()
    wrapped.step(5.0)
    wrapped.step(4.0)
    wrapped.propagate(3.0)  # drops the decision at 4.0; nobody judges the state 3.0
    wrapped.evaluate(2.0)
    lesson = wrapped.student.lessons[-1]
    assert lesson.moment.state == 3.0
    assert lesson.outcome.margins_before is None


def test_a_void_decision_teaches_nothing_and_says_why() -> None:
    wrapped = measuring()
    wrapped.step(1.0)
    wrapped.void("emergency stop")
    wrapped.step(-1.0)
    assert wrapped.student.lessons == []
    assert (wrapped.last.outcome.violated, wrapped.last.lesson, wrapped.last.void) == (
        ("near",),
        None,
        "emergency stop",
    )
    wrapped.step(1.0)
    assert [lesson.moment.number for lesson in wrapped.student.lessons] == [1]


def test_voiding_before_any_decision_voids_none() -> None:
    wrapped = measuring()
    wrapped.void("nothing to void")
    wrapped.step(1.0)
    wrapped.step(1.0)
    assert [lesson.moment.number for lesson in wrapped.student.lessons] == [0]


def test_a_dropped_decision_is_never_judged() -> None:
    asked: list[float] = []
    condition = Says(violated=lambda x: asked.append(x) or False)
    wrapped = engine(forward(0.1), level(1), conditions=[condition])
    wrapped.step(1.0)
    wrapped.drop()
    assert wrapped.pending is None
    assert (wrapped.last.void, wrapped.last.outcome, wrapped.last.lesson) == ("dropped", None, None)
    assert wrapped.evaluate(2.0) is None
    assert (asked, wrapped.student.lessons) == ([], [])


def test_a_reset_keeps_decision_count_learning_phase_and_what_was_learned() -> None:
    wrapped = engine(forward(0.1), level(1), amplifier=LearningPhase(decisions=3))
    raised = []
    for _ in range(5):
        wrapped.step(None)
        raised.append(wrapped.pending.amplified)
        wrapped.reset()
    assert raised == [True, True, True, False, False]
    assert wrapped.decisions == 5


def test_the_tutor_hears_once_and_in_order_what_was_executed() -> None:
    tutor = ListeningTutor(act=lambda state: forward(state / 10)(state))
    wrapped = engine(forward(0.0), level(2), tutor=tutor)
    expected = [wrapped.step(state) for state in range(4)]
    assert [round(action.translation, 9) for action in tutor.heard] == [0.2, 0.3, 0.4]
    wrapped.drop()
    assert expected == tutor.heard


def test_incidents_are_bounded_in_memory_while_their_counts_go_on() -> None:
    failing = LevelStudent(propose=lambda moment: 1 / 0)
    wrapped = engine(forward(0.1), failing)
    for number in range(REMEMBERED + 50):
        wrapped.step(number)
    assert len(wrapped.incidents) == REMEMBERED
    assert wrapped.incident_counts == {("student", "raised"): REMEMBERED + 50}
    assert wrapped.incidents[-1].message == "ZeroDivisionError: division by zero"
    assert wrapped.incidents[-1].decision == REMEMBERED + 49


def test_a_megabyte_of_message_is_not_remembered() -> None:
    def fail(moment: Any) -> Any:
        raise ValueError("x" * 2**20)

    wrapped = engine(forward(0.1), LevelStudent(propose=fail))
    wrapped.step(None)
    assert len(wrapped.incidents[0].message) <= 1000


def levels(seed: int, **others: Any) -> list[int]:
    """Return what a random student proposes."""
    wrapped = engine(forward(0.1), Random(max_level=1000), seed=seed, **others)
    found = []
    for _ in range(20):
        wrapped.step(None)
        found.append(wrapped.pending.proposal.level)
    return found


def test_each_part_draws_from_a_stream_of_its_own() -> None:
    class Drawing(Says):
        def violated(self, state: Any) -> bool:
            return bool(self.rng.random() < 0.5)

    expected = levels(7)
    assert expected == levels(7)
    assert expected == levels(7, conditions=[Drawing(violated=len, label="a"), Drawing(violated=len, label="b")])
    assert expected != levels(8)


def test_a_part_stands_in_one_engine_only() -> None:
    student = level(1)
    engine(forward(0.1), student)
    with pytest.raises(ContractError, match="student 'scripted-level' is already at 'student' of a pipeline"):
        engine(forward(0.1), student)


class Learner(LevelStudent):
    """Learns how many lessons it had."""

    name = "learner"

    def state_dict(self) -> Learned:
        return {"lessons": len(self.lessons)}

    def load_state_dict(self, state: Learned) -> None:
        self.lessons = [None] * state["lessons"]


def learning() -> Engine[Any, Any, Any]:
    """Return an engine that learns."""
    return engine(forward(0.1), Learner(propose=lambda moment: LevelProposal(level=0, ampbit=True)))


def test_what_was_learned_survives_a_round_trip() -> None:
    first, second = learning(), learning()
    for state in range(4):
        first.step(state)
    saved = first.state_dict()
    assert saved == {"decisions": 4, "student": {"lessons": 3}}
    second.load_state_dict(saved)
    assert saved == second.state_dict()
    assert (second.decisions, len(second.student.lessons)) == (4, 3)


def test_a_saved_state_of_another_pipeline_is_refused_by_name() -> None:
    with pytest.raises(ContractError, match="names the part 'stduent'; this pipeline has tutor, student, selector"):
        learning().load_state_dict({"stduent": {}})


def test_everything_is_closed_even_if_a_part_refuses() -> None:
    closed: list[str] = []

    class Closing(LevelStudent):
        def close(self) -> None:
            raise RuntimeError("I stay")

    class Condition(Says):
        def close(self) -> None:
            closed.append(self.label)

    wrapped = engine(forward(0.1), Closing(propose=len), conditions=[Condition(violated=len, label="last")])
    wrapped.close()
    assert closed == ["last"]
    assert wrapped.incident_counts == {("student", "raised"): 1}
