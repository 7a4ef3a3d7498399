"""A callable that works becomes a tutor in one line; its own types go in and come out."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

import tutorstudent as ts
from tests.core.toys import Push

UNIT = ts.scalar(-1, 1)


def half(_: Any) -> float:
    return 0.5


def test_a_command_that_is_not_amplified_is_the_controllers_own_object() -> None:
    command = np.array([0.3, -0.4])
    loop = ts.wrap(lambda _: command, action=ts.vector(-1, 1, 2), amplifier="never")
    assert command is loop.step(0.0)


def test_it_is_amplified_up_to_the_factor_one_level_at_a_time() -> None:
    loop = ts.wrap(half, action=UNIT)
    assert [0.55, 0.6, 0.65, 0.65, 0.65] == pytest.approx([loop.step(0.0) for _ in range(5)])


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


def test_buffers_that_the_owner_reuses_do_not_change_what_was_seen() -> None:
    buffer, seen = np.zeros(2), []
    loop = ts.wrap(lambda state: seen.append(state) or 0.5, action=UNIT)
    loop.step(buffer)
    buffer += 1
    loop.step(buffer)
    assert [[0.0, 0.0], [1.0, 1.0]] == [state.tolist() for state in seen]
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


@pytest.mark.parametrize("command", [[0.1, 0.2], "full speed", None])
def test_a_controller_that_returns_something_else_is_named(command: Any) -> None:
    with pytest.raises((ts.ContractError, ValueError, TypeError)):
        ts.wrap(lambda _: command, action=UNIT).step(0.0)


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
