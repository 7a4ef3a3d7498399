"""A callable that works becomes a tutor in one line; its own types go in and come out."""

from __future__ import annotations

import array
import dataclasses
import re
from typing import Any, NamedTuple

import numpy as np
import pytest

import tutorstudent as ts
from tests.core.toys import Push

UNIT = ts.scalar(-1, 1)


def half(_: Any) -> float:
    return 0.5


def test_a_command_that_is_not_amplified_is_the_controllers_own_object() -> None:
    command = np.array([0.3, -0.4])
    loop = ts.wrap(lambda _: command, action=ts.vector(-1, 1, 2), student="silent", amplifier="never")
    assert command is loop.step(0.0)


def test_it_is_amplified_up_to_the_factor_one_level_at_a_time() -> None:
    loop = ts.wrap(half, action=UNIT, student={"use": "constant", "level": 8})
    assert [0.55, 0.6, 0.65, 0.65, 0.65] == pytest.approx([loop.step(0.0) for _ in range(5)])


def test_by_default_it_begins_at_level_1_and_climbs_while_nothing_is_violated() -> None:
    loop = ts.wrap(half, action=UNIT, condition=lambda y: y > 80)
    assert "budgeted" == loop.engine.student.name
    commands = [loop.step(0.0) for _ in range(600)]
    assert [0.55, 0.6, 0.65] == pytest.approx([commands[0], commands[300], commands[599]])


def test_a_violation_is_unlearned() -> None:
    loop = ts.wrap(half, action=UNIT, condition=lambda y: y > 80)
    for _ in range(6):
        loop.step(0.0)
    loop.step(99.0)
    assert ("condition-1",) == loop.engine.last.outcome.violated  # type: ignore[union-attr]
    assert not loop.engine.last.lesson.target.ampbit  # type: ignore[union-attr]


@pytest.mark.parametrize("like", [0.5, np.float32(0.5), np.float64(0.5)])
def test_a_number_comes_back_in_its_own_type(like: Any) -> None:
    loop = ts.wrap(lambda _: like, action=UNIT)
    assert type(like) is type(loop.step(0.0))


@pytest.mark.parametrize("like", [[0.3, 0.4], (0.3, 0.4), np.array([0.3, 0.4], np.float32), np.array([[0.3], [0.4]])])
def test_several_numbers_come_back_in_their_type_and_shape_and_keep_their_direction(like: Any) -> None:
    loop = ts.wrap(lambda _: like, action=ts.vector(-1, 1, 2))
    found = loop.step(0.0)
    assert type(like) is type(found)
    values = np.asarray(found, dtype=float).ravel()
    assert values == pytest.approx(np.array([0.3, 0.4]) * 1.1, rel=1e-6)
    assert np.shape(like) == np.shape(found)


def test_a_command_at_neutral_is_never_amplified() -> None:
    loop = ts.wrap(lambda _: 0.0, action=UNIT)
    assert [0.0] * 5 == [loop.step(1.0) for _ in range(5)]


def test_buffers_that_the_owner_reuses_do_not_change_what_parts_saw() -> None:
    buffer, seen = np.zeros(2), []
    loop = ts.wrap(lambda state: 0.5, action=UNIT, condition=lambda state: seen.append(state) or False)
    loop.step(buffer)
    for _ in range(2):
        buffer += 1
        loop.step(buffer)
    assert [[1.0, 1.0], [2.0, 2.0]] == [state.tolist() for state in seen]
    assert not seen[0].flags.writeable


def test_what_was_really_executed_is_what_is_taught() -> None:
    loop = ts.wrap(half, action=UNIT)
    for _ in range(4):
        loop.step(0.0)
    loop.executed(0.55)
    loop.step(0.0)
    assert 1 == loop.engine.last.lesson.target.level  # type: ignore[union-attr]


def test_an_emergency_stop_teaches_nothing() -> None:
    loop = ts.wrap(half, action=UNIT)
    loop.step(0.0)
    loop.void("emergency stop")
    loop.step(0.0)
    turn = loop.engine.last
    assert turn is not None
    assert (None, "emergency stop") == (turn.lesson, turn.void)


def test_ranges_let_the_student_tell_states_apart() -> None:
    loop = ts.wrap(half, action=UNIT, condition=lambda y: y > 80, ranges=[(0, 100)])
    for _ in range(5):
        loop.step(20.0)
    assert 0.65 == pytest.approx(loop.step(20.0))
    assert not loop.engine.incidents


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"controller": 7, "action": UNIT}, "a controller is a Tutor or a callable of the state, not int"),
        ({"controller": half}, "action=None: a callable needs the action class of what it returns"),
        ({"controller": half, "action": float}, "a callable needs the action class of what it returns"),
        ({"controller": half, "action": UNIT, "factor": 0.5}, "wrap(): limits.factor: limits: option 'factor': input"),
        ({"controller": half, "action": UNIT, "student": "tabel"}, "no student named 'tabel' (did you mean 'table'?)"),
        ({"controller": half, "action": UNIT, "ranges": [(3, 1)]}, "every range is a low and a high number"),
        ({"controller": half, "action": UNIT, "colour": 1}, "wrap(): colour: unknown key. Allowed:"),
        ({"controller": half, "action": type("Still", (ts.Action,), {})}, "Still has nothing to amplify"),
    ],
)
def test_a_mistake_is_told_with_the_remedy(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(ts.TutorStudentError, match=re.escape(message)):
        ts.wrap(**arguments)


@pytest.mark.parametrize("command", [[0.1, 0.2], "full speed", "0.5", None, True, array.array("d", [0.1])])
def test_a_controller_that_returns_something_else_is_told_so(command: Any) -> None:
    with pytest.raises(ts.ContractError, match=r"the controller's command is .*; expected a number."):
        ts.wrap(lambda _: command, action=UNIT).step(0.0)


@pytest.mark.parametrize("command", [0.1, [0.1], array.array("d", [0.1, 0.2]), {"x": 1, "y": 2}])
def test_several_numbers_are_a_list_a_tuple_or_an_array(command: Any) -> None:
    with pytest.raises(ts.ContractError, match="expected a list, tuple or numpy array of 2 numbers"):
        ts.wrap(lambda _: command, action=ts.vector(-1, 1, 2)).step(0.0)


def test_a_command_out_of_bounds_is_told_with_the_remedy() -> None:
    with pytest.raises(ts.ContractError, match="command is 1.2: input should be less than or equal to 1. State wider"):
        ts.wrap(lambda _: 1.2, action=UNIT).step(0.0)
    loop = ts.wrap(half, action=UNIT)
    loop.step(0.0)
    with pytest.raises(ts.ContractError, match="command is 1.5"):
        loop.executed(1.5)


def test_a_named_tuple_comes_back_as_one() -> None:
    class Twist(NamedTuple):
        v: float
        w: float

    found = ts.wrap(lambda _: Twist(0.3, 0.4), action=ts.vector(-1, 1, 2)).step(0.0)
    assert Twist(v=pytest.approx(0.33), w=pytest.approx(0.44)) == found
    assert type(found) is Twist


def test_a_whole_number_is_amplified_like_any_other() -> None:
    assert 2.2 == pytest.approx(ts.wrap(lambda _: 2, action=ts.scalar(-5, 5)).step(0.0))


def test_a_failure_action_comes_back_in_the_shape_of_the_last_command() -> None:
    def failing(state: float) -> list[float]:
        if state:
            raise RuntimeError("sensor lost")
        return [0.3, 0.4]

    stop = {"kind": "command", "x0": 0.0, "x1": 0.0}
    loop = ts.wrap(failing, action=ts.vector(-1, 1, 2), on_tutor_failure=stop)
    assert [0.0, 0.0] == loop.step(1.0)
    assert pytest.approx([0.33, 0.44]) == loop.step(0.0)
    assert [0.0, 0.0] == loop.step(1.0)


def test_limits_add_to_factor_and_slew() -> None:
    limits = ts.wrap(half, action=UNIT, limits={"cap": 0.1}).engine.limits
    assert (0.1, 1.3, 1) == (limits.cap, limits.factor, limits.slew)


def test_states_are_copied_and_frozen_all_the_way_down() -> None:
    @dataclasses.dataclass
    class Sensed:
        scan: Any

    seen: list[Any] = []
    loop = ts.wrap(lambda state: 0.5, action=UNIT, condition=lambda state: seen.append(state) or False)
    buffer = np.zeros(2)
    loop.step(0.0)
    for state in ({"scan": buffer}, (buffer, 1), [buffer], Sensed(buffer)):
        loop.step(state)
    buffer += 1
    scans = (seen[0]["scan"], seen[1][0], seen[2][0], seen[3].scan)
    assert [[0.0, 0.0]] * 4 == [scan.tolist() for scan in scans]
    assert not any(scan.flags.writeable for scan in scans)


def test_an_own_action_class_goes_through_as_it_is() -> None:
    loop = ts.wrap(lambda _: Push(kind="push", force=0.2), action=Push)
    action = loop.step(0.0)
    assert ("push", pytest.approx(0.22)) == (action.kind, action.force)
    with pytest.raises(ts.ContractError, match="the controller returned float; expected Push"):
        ts.wrap(lambda _: 0.2, action=Push).step(0.0)


@pytest.mark.parametrize(("low", "high"), [([0, 0, 0], 1), (0, [1])])
def test_a_vector_has_a_bound_for_every_number(low: Any, high: Any) -> None:
    with pytest.raises(ts.ContractError, match="expected 2 of each"):
        ts.vector(low, high, 2)


@pytest.mark.parametrize("limits", [None, 0.8, ts.Limits(factor=1.3)], ids=repr)
def test_limits_that_are_no_mapping_are_a_sentence(limits: Any) -> None:
    with pytest.raises(ts.PipelineError, match="limits.* write a mapping, as in limits: {cap: 0.8}"):
        ts.wrap(half, action=UNIT, limits=limits)
