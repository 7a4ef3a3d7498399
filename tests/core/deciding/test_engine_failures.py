"""What happens when a part, a condition or the tutor itself fails (the behaviour contract, 4)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from pydantic import ValidationError

from tests.core.oracle.lies import Fatal, LyingInt, Touchy, Unsayable
from tests.core.oracle.scripted import (
    LevelStudent,
    ListeningTutor,
    Measures,
    Says,
    ScriptedTutor,
    engine,
    forward,
    level,
)
from tests.core.oracle.shapes import Valve
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.roles.leaves import Change
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.proposals import LevelProposal
from tutorstudent.plugins.amplifiers import Never
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.streamlined.modifier import Modifier
from tutorstudent.sims.pioneer.types import DriveAction

STOP = DriveAction(kind="stop")


def raising(error: BaseException) -> Callable[..., Any]:
    """Return a function that raises."""

    def fail(*arguments: Any) -> Any:
        raise error

    return fail


def tampered(state: Any) -> DriveAction:
    """Return an action that was valid once."""
    action = DriveAction(kind="forward", translation=0.2)
    action.__dict__["translation"] = float("inf")
    return action


BAD_TUTORS: dict[str, Callable[[Any], Any]] = {
    "raises": raising(ValueError("sensor gone")),
    "raises SystemExit": raising(SystemExit(1)),
    "returns None": lambda state: None,
    "returns another class": lambda state: Valve(opening=0.1),
    "returns a tampered action": tampered,
}


@pytest.mark.parametrize(
    ("bad", "error", "message"),
    [
        ("raises", ValueError, "sensor gone"),
        ("raises SystemExit", SystemExit, "1"),
        ("returns None", ContractError, "tutor 'scripted' returned NoneType; expected DriveAction. Tutors return"),
        ("returns another class", ContractError, "returned Valve; expected DriveAction. Tutors return an action of"),
        ("returns a tampered action", ValidationError, "translation\n  Input should be a finite number"),
    ],
)
def test_a_tutor_that_fails_is_let_through_by_default(bad: str, error: Any, message: str) -> None:
    wrapped = engine(BAD_TUTORS[bad], level(3))
    with pytest.raises(error, match=message):
        wrapped.step(0)
    assert wrapped.pending is None


@pytest.mark.parametrize("bad", BAD_TUTORS)
def test_where_the_tutor_fails_the_written_action_executes_and_teaches_nothing(bad: str) -> None:
    wrapped = engine(lambda s: BAD_TUTORS[bad](s) if s == 1 else forward(0.1)(s), level(3), on_tutor_failure=STOP)
    executed = [wrapped.step(state) for state in range(4)]
    assert [action.kind for action in executed] == ["forward", "stop", "forward", "forward"]
    assert executed[1] is STOP
    assert [lesson.moment.number for lesson in wrapped.student.lessons] == [0, 2]
    assert wrapped.incident_counts == {("tutor", "raised"): 1}
    assert wrapped.incidents[0].decision == 1


def test_a_turn_says_that_the_tutor_failed() -> None:
    wrapped = engine(raising(ValueError("sensor gone")), level(3), on_tutor_failure=STOP)
    wrapped.step(0)
    assert (wrapped.pending.selected.level, wrapped.pending.resulting.level) == (0, 0)
    wrapped.step(1)
    assert wrapped.last.void == "the tutor failed"
    assert wrapped.last.incidents[0].message == "ValueError: sensor gone"


def test_the_message_of_a_tutor_that_returns_the_wrong_thing_says_what_is_expected() -> None:
    with pytest.raises(ContractError, match="tutor 'scripted' returned NoneType; expected DriveAction"):
        engine(lambda state: None, level(3)).step(0)


def test_a_written_action_amplifies_nothing_even_where_slew_would_hold_the_level_up() -> None:
    halt = DriveAction(kind="forward", translation=0.05)
    script = lambda s: forward(0.1)(s) if s < 5 else 1 / 0  # noqa: E731
    wrapped = engine(script, level(8), on_tutor_failure=halt, limits=Limits(slew=1))
    executed = [wrapped.step(state) for state in range(6)]
    assert round(executed[4].translation, 9) == 0.6
    assert executed[5] is halt


def test_a_situation_that_is_no_string_is_the_tutors_failure() -> None:
    class Odd(ScriptedTutor):
        situation = 7  # type: ignore[assignment]

    with pytest.raises(ContractError, match="tutor 'scripted': situation is 7; it is a string"):
        engine(len, level(1), tutor=Odd(act=forward(0.1))).step(0)


def test_a_tutor_that_cannot_hear_is_let_through_by_default_and_an_incident_otherwise() -> None:
    class Deaf(ListeningTutor):
        def executed(self, action: Any) -> None:
            raise RuntimeError("deaf")

    wrapped = engine(len, level(1), tutor=Deaf(act=forward(0.1)))
    wrapped.step(0)
    with pytest.raises(RuntimeError, match="deaf"):
        wrapped.step(1)
    wrapped = engine(len, level(1), tutor=Deaf(act=forward(0.1)), on_tutor_failure=STOP)
    wrapped.step(0)
    wrapped.step(1)
    assert wrapped.incident_counts == {("tutor", "raised"): 1}


@pytest.mark.parametrize(
    "error", [ValueError("oh"), SystemExit(2), Fatal("f"), Unsayable()], ids=lambda e: type(e).__name__
)
def test_in_raise_mode_an_incident_is_a_contract_error_that_names_decision_part_and_kind(error: BaseException) -> None:
    wrapped = engine(forward(0.1), LevelStudent(propose=raising(error)), on_incident="raise")
    with pytest.raises(ContractError, match=f"decision 0: student: raised: {type(error).__name__}") as caught:
        wrapped.step(0)
    assert caught.value.__cause__ is error


def test_a_message_that_cannot_be_read_is_said_so() -> None:
    wrapped = engine(forward(0.1), LevelStudent(propose=raising(Unsayable())))
    wrapped.step(0)
    assert wrapped.incidents[0].message == "Unsayable (its message could not be read)"


class Interrupting:
    """What an impatient person does, in every part."""

    class Student(LevelStudent):
        def teach(self, lesson: Any) -> None:
            raise KeyboardInterrupt

    class Selector(Modifier[Any]):
        select = raising(KeyboardInterrupt())  # type: ignore[assignment]

    class Amplifier(Never[Any]):
        amplify = raising(KeyboardInterrupt())  # type: ignore[assignment]

    class Change(Change):
        name = "interrupting"
        fraction = raising(KeyboardInterrupt())  # type: ignore[assignment]

    class Evaluator(Conditions[Any, Any]):
        evaluate = raising(KeyboardInterrupt())  # type: ignore[assignment]


SAID = LevelProposal(level=2, ampbit=True)
INTERRUPTED: dict[str, Callable[[], dict[str, Any]]] = {
    "tutor": lambda: {"tutor": ScriptedTutor(act=raising(KeyboardInterrupt())), "on_tutor_failure": STOP},
    "student": lambda: {"student": LevelStudent(propose=raising(KeyboardInterrupt()))},
    "selector": lambda: {"selector": Interrupting.Selector()},
    "amplifier": lambda: {"amplifier": Interrupting.Amplifier()},
    "change": lambda: {"amplifier": Never(change=Interrupting.Change())},
    "evaluator": lambda: {"evaluator": Interrupting.Evaluator()},
    "teach": lambda: {"student": Interrupting.Student(propose=lambda moment: SAID)},
    "condition": lambda: {"conditions": [Says(violated=raising(KeyboardInterrupt()))]},
    "margins": lambda: {"conditions": [Measures(violated=bool, margins=raising(KeyboardInterrupt()))]},
}


@pytest.mark.parametrize("part", INTERRUPTED)
def test_a_keyboard_interrupt_passes_through_from(part: str) -> None:
    parts = INTERRUPTED[part]()
    wrapped = engine(forward(0.1), parts.pop("student", level(2)), **parts)
    with pytest.raises(KeyboardInterrupt):
        [wrapped.step(state) for state in range(2)]
    assert not wrapped.incidents


BAD_ANSWERS: dict[str, Callable[[Any], Any]] = {
    "None": lambda state: None,
    "two": lambda state: 2,
    "NaN": lambda state: float("nan"),
    "a string": lambda state: "no",
    "a lying int": lambda state: LyingInt(9),
    "something touchy": lambda state: Touchy(),
    "an exception": raising(ValueError("no sensor")),
    "an exit": raising(SystemExit(0)),
}


@pytest.mark.parametrize("answer", BAD_ANSWERS)
def test_a_condition_counts_as_violated_and_as_an_incident_when_it_answers(answer: str) -> None:
    conditions = [Says(violated=BAD_ANSWERS[answer], label="bad"), Says(violated=lambda state: False, label="good")]
    wrapped = engine(forward(0.1), level(2), conditions=conditions)
    wrapped.step(0)
    wrapped.step(1)
    assert wrapped.last.outcome.violated == ("bad",)
    assert [incident.part for incident in wrapped.last.incidents] == ["conditions.bad"]
    assert wrapped.student.lessons[0].target[1:] == (0, False)


@pytest.mark.parametrize("violated", [False, True])
@pytest.mark.parametrize("margins", [[1.0, float("nan")], ["far"], 3.0, [None]], ids=repr)
def test_a_margin_that_is_no_number_counts_as_violated_once(margins: Any, violated: bool) -> None:
    condition = Measures(violated=lambda state: violated, margins=lambda state: margins, label="near")
    wrapped = engine(forward(0.1), level(2), conditions=[condition])
    wrapped.step(0)
    wrapped.step(1)
    assert wrapped.last.outcome.violated == ("near",)
    assert "near" not in wrapped.last.outcome.margins
    assert len(wrapped.last.incidents) == 1


def test_an_infinite_margin_is_a_margin() -> None:
    condition = Measures(violated=lambda state: False, margins=lambda state: [float("inf")], label="near")
    wrapped = engine(forward(0.1), level(2), conditions=[condition], on_incident="raise")
    wrapped.step(0)
    wrapped.step(1)
    assert {"near": (float("inf"),)} == wrapped.last.outcome.margins
