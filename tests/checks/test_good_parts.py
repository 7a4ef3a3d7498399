"""Parts that keep every promise pass, the shipped ones among them; what is skipped says why."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.checks.good import GOOD, Heat, House, Room, Stove, room
from tests.plugins.process.programs import UNIT, answering
from tutorstudent.checks import Report, checks_of, run_checks
from tutorstudent.checks.process import make
from tutorstudent.core.files.registry import ROLES, Installed, Registry
from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.roles.leaves import Encoder, condition, encoder
from tutorstudent.core.roles.part import Component
from tutorstudent.core.words.commands import scalar
from tutorstudent.core.words.errors import ContractError, PipelineError
from tutorstudent.core.words.records import Moment
from tutorstudent.plugins.backprop import BackpropStudent
from tutorstudent.plugins.changes import Additive
from tutorstudent.plugins.prototype2 import Bits
from tutorstudent.plugins.ranges import Ranges
from tutorstudent.sims.gym.types import GymState

IN_ANOTHER_PROCESS = "same_answers_in_another_process"
REQUIRED: dict[tuple[str, str], dict[str, Any]] = {
    ("student", "backprop"): {"encoder": "prototype2-bits"},
    ("student", "table"): {"encoder": "prototype2-bits"},
    ("student", "sklearn"): {
        "encoder": "prototype2-bits",
        "estimator": "sklearn.neural_network.MLPRegressor",
        "teaching_rate": 1,
    },
    ("condition", "any-of"): {"of": ["near"]},
    ("condition", "all-of"): {"of": ["bumped", "near"]},
    ("condition", "not"): {"of": "bumped"},
    ("condition", "info-true"): {"key": "crashed"},
    ("condition", "observation-outside"): {"index": 0, "low": -1.0, "high": 1.0},
    ("condition", "reward-below"): {"threshold": 0.0},
    ("world", "gymnasium"): {"id": "Pendulum-v1"},
    ("tutor", "process"): {"program": answering(), "action": UNIT, "deadline_s": 20.0},
}
"""Options that have no default."""
GYM_STATES = [
    GymState(np.array([position, 0.5]), position, position > 1, info={"crashed": position > 1})
    for position in (-2.0, 0.5, 2.0)
]
HOW: dict[tuple[str, str], dict[str, Any]] = {
    ("condition", "info-true"): {"states": GYM_STATES},
    ("condition", "observation-outside"): {"states": GYM_STATES},
    ("condition", "reward-below"): {"states": GYM_STATES},
    ("condition", "terminated"): {"states": GYM_STATES},
    ("world", "gymnasium"): {"action": scalar(-2.0, 2.0)},
    ("tutor", "process"): {"states": [-30, 10, 20]},
}
"""What parts are tried with that are made for any state or action."""
REGISTRY = Registry.discover()
SHIPPED = [
    pytest.param(
        installed,
        id=f"{installed.cls.role}-{installed.cls.name}",
        marks=[pytest.mark.process] if installed.cls.name == "process" else [],
    )
    for installed in REGISTRY
    if installed.distribution.startswith("tutorstudent ")
]


def quickly(part: Any, **how: Any) -> Report:
    return run_checks([check for check in checks_of(part, **how) if check.name != IN_ANOTHER_PROCESS])


def skipped(report: Report) -> dict[str, str]:
    return {result.check: result.note for result in report.of("skipped")}


@pytest.mark.parametrize("cls", GOOD, ids=lambda cls: cls.name)
def test_a_part_that_keeps_its_promises_passes(cls: type[Component]) -> None:
    report = run_checks(checks_of(cls()))
    assert [] == report.of("failed")
    assert 12 <= len(report.of("passed"))


def test_there_is_a_good_part_of_every_role() -> None:
    assert set(ROLES) == {cls.role for cls in GOOD}


@pytest.mark.parametrize("installed", SHIPPED)
def test_every_shipped_part_passes(installed: Installed) -> None:
    role, name = installed.cls.role, installed.cls.name
    part = make(REGISTRY, role, {"use": name} | REQUIRED.get((role, name), {}))
    report = quickly(part, **HOW.get((role, name), {}))
    assert [] == report.of("failed")
    assert "works" not in skipped(report)


@pytest.mark.parametrize("check", checks_of(Stove(goal_celsius=25.0)), ids=str)
def test_the_line_in_a_third_partys_tests(check: Any) -> None:
    check()


@pytest.mark.process
def test_another_process_is_asked_for_installed_parts_and_says_the_same() -> None:
    (check,) = [check for check in checks_of(Bits()) if check.name == IN_ANOTHER_PROCESS]
    check()


def test_a_class_or_a_function_makes_the_part_too() -> None:
    assert [] == quickly(Stove).of("failed")
    assert [] == quickly(lambda: Stove(goal_celsius=-3.0)).of("failed")


def test_the_instance_is_only_copied() -> None:
    part = Stove()
    quickly(part)
    assert part.slot == ""
    assert not hasattr(part, "asked")


def test_a_part_that_stands_in_a_pipeline_is_refused() -> None:
    part = checks_of(Stove())[0].usage.subject.make_bound()
    with pytest.raises(ContractError, match="tutor 'stove' stands at 'tutor' of a pipeline; give the checks one that"):
        checks_of(part)


def test_a_class_that_needs_options_says_so() -> None:
    with pytest.raises(PipelineError, match="option 'encoder' is required"):
        checks_of(BackpropStudent)


class Bare(Tutor[Any, Heat]):
    """Says nothing about its states."""

    name = "bare"
    action = Heat

    def act(self, state: Any) -> Heat:
        return Heat(kind="heat", power=0.5 if state.celsius < 20 else 0.1)


def test_without_states_nothing_is_tried_and_it_is_said_why() -> None:
    reasons = skipped(quickly(Bare()))
    assert (
        "it is not known what states Bare is made for: give its class or its state class examples(),"
        in reasons["works"]
    )
    assert "is_described" not in reasons


def test_states_can_be_given_or_taken_from_a_world() -> None:
    for how in ({"states": [room(3.0), room(30.0)]}, {"world": House()}):
        report = quickly(Bare(), **how)
        assert [] == report.of("failed")
        assert "works" not in skipped(report)


def test_states_come_from_the_part_before_its_state_class() -> None:
    class Choosy(Stove):
        """Has states of its own."""

        name = "choosy"

        def examples(self) -> list[Room]:
            return [room(float(degrees)) for degrees in range(20)]

    assert 20 == len(checks_of(Choosy())[0].usage.states)
    assert 12 == len(checks_of(Stove())[0].usage.states)


def test_a_part_for_any_state_is_tried_with_a_number() -> None:
    student = make(REGISTRY, "student", {"use": "constant"})
    assert [0.0] * 12 == checks_of(student)[0].usage.states


def test_states_and_actions_of_a_nested_part_are_those_of_the_whole() -> None:
    usage = checks_of(make(REGISTRY, "student", {"use": "backprop", "encoder": "prototype2-bits"}))[0].usage
    assert "PioneerState" == type(usage.states[0]).__name__
    assert "DriveAction" == usage.subject.action.__name__


def test_what_a_function_says_of_its_argument_counts() -> None:
    @condition("hot")
    def hot(state: Room) -> bool:
        """Too hot."""
        return state.celsius > 20

    @encoder("warm", width=1)
    def warm(moment: Moment[Room, Heat]) -> list[float]:
        """Warm or not."""
        return [float(moment.state.celsius > 20)]

    for cls in (hot, warm):
        usage = checks_of(cls)[0].usage
        assert Room is type(usage.states[0])
    assert Heat is usage.subject.action


def test_an_action_class_can_be_given() -> None:
    usage = checks_of(Ranges(), action=Heat)[0].usage
    assert {"off", "heat"} == {action.kind for action in usage.subject.actions}


def test_a_check_can_be_waived_with_a_reason() -> None:
    class Fragile(Encoder[Room, Heat]):
        """Asks for finite readings."""

        name = "fragile"
        width = 1
        waived_checks = {"survives_broken_readings": "the driver delivers numbers only"}

        def encode(self, moment: Any) -> Any:
            raise AssertionError("not reached")

    (check,) = [check for check in checks_of(Fragile()) if check.name == "survives_broken_readings"]
    assert "waived by the part: the driver delivers numbers only" == run_checks([check]).results[0].note


def test_what_uses_no_random_numbers_is_skipped_with_that_reason() -> None:
    assert "it uses no random numbers" == skipped(quickly(Additive()))["has_its_own_random_numbers"]


def test_the_time_is_reported_and_never_judged() -> None:
    notes = {result.check: result.note for result in quickly(Stove()).of("passed")}
    assert notes["says_how_long_it_takes"].startswith("median ")
    assert notes["says_how_long_it_takes"].endswith(" us per decision")


def test_whatever_a_check_opens_is_closed() -> None:
    closed: list[int] = []

    class Opening(Stove):
        """Counts its ends."""

        def close(self) -> None:
            closed.append(id(self))

    checks = {check.name: check for check in checks_of(Opening())}
    checks["answers_are_sound"]()
    assert 1 == len(closed)
