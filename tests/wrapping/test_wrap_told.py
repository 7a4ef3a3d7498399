"""What `wrap` says of parts that fail, and of conditions that are none."""

from __future__ import annotations

import functools
import threading
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import tutorstudent as ts
from tests.core.oracle.scripted import LevelStudent
from tutorstudent.core.deciding.function_tutor import as_tutor
from tutorstudent.core.files.yamlfile import Document


def told(caplog: pytest.LogCaptureFixture) -> list[str]:
    return [record.getMessage() for record in caplog.records if record.name == "tutorstudent"]


def fail(moment: Any) -> Any:
    raise RuntimeError("no weights")


def faulty(**slots: Any) -> ts.Loop:
    """Return a loop whose student fails in every decision."""
    student = LevelStudent(propose=fail)
    values = {"student": "silent", "selector": "modifier", "limits": {"factor": 1.3, "slew": 1}}
    pipeline = ts.Pipeline(Document("test", values, {}))
    return ts.Loop(pipeline.engine(tutor=as_tutor(lambda y: 0.5, ts.scalar(-1, 1)), student=student, **slots))


def test_a_part_that_fails_in_every_decision_is_told_once(caplog: pytest.LogCaptureFixture) -> None:
    loop = faulty()
    for _ in range(5):
        assert 0.5 == loop.step(0.25)
    (message,) = told(caplog)
    assert "decision 0: student: raised: RuntimeError: no weights" in message
    assert 5 <= sum(loop.engine.incident_counts.values())


def test_every_part_that_fails_is_told(caplog: pytest.LogCaptureFixture) -> None:
    loop = faulty(conditions=[ts.condition("hot")(fail)()])
    for _ in range(3):
        loop.step(0.25)
    assert ["conditions.hot", "student"] == sorted(message.split(": ")[1] for message in told(caplog))


UNREAD: list[tuple[Any, Any, str]] = [
    ([1.0] * 4, [(0, 1)] * 3, "the state has 4 numbers, but 3 ranges are declared"),
    ({"cgm": [1.0, 2.0], "iob": 0.5}, [(0, 1)], "a dict is no plain list of numbers"),
    (SimpleNamespace(x=1.0), [(0, 1)], "a SimpleNamespace is no plain list of numbers"),
    (SimpleNamespace(x=1.0), {"y": (0, 1)}, "SimpleNamespace has no 'y'"),
    (threading.Lock(), [(0, 1)], "state is a lock, which cannot be shown to parts"),
]


@pytest.mark.parametrize(("state", "ranges", "said"), UNREAD)
def test_ranges_that_do_not_fit_the_state_are_an_error_in_the_first_decision(
    state: Any, ranges: Any, said: str
) -> None:
    loop = ts.wrap(lambda y: 0.5, action=ts.scalar(-1, 1), ranges=ranges)
    for _ in range(2):
        with pytest.raises(ts.UnreadableState, match=f"encoder 'ranges': .*{said}"):
            loop.step(state)
    assert not loop.engine.incidents
    assert loop.engine.pending is None


def test_a_state_that_cannot_be_read_later_is_an_incident() -> None:
    loop = ts.wrap(lambda y: 0.5, action=ts.scalar(-1, 1), ranges=(0, 1))
    assert 0.55 == loop.step(0.25)
    assert [0.5, 0.5] == [loop.step([0.25, 0.5]), loop.step("gone")]
    assert {("student", "raised")} == set(loop.engine.incident_counts)


@pytest.mark.parametrize(
    ("state", "ranges"),
    [
        ({"odom": SimpleNamespace(x=0.4), "y": 20}, {"odom.x": (0, 1), "y": (0, 100)}),
        (0.4, (0, 1)),
        ([0.4, 20.0], np.array([[0, 1], [0, 100]])),
    ],
)
def test_ranges_take_names_and_a_single_range(state: Any, ranges: Any) -> None:
    loop = ts.wrap(lambda y: 0.5, action=ts.scalar(-1, 1), ranges=ranges)
    assert [0.55, 0.6, 0.65] == pytest.approx([loop.step(state) for _ in range(3)])
    assert not loop.engine.incidents


def test_ranges_beside_a_student_of_ones_own_would_say_nothing_to_anybody() -> None:
    with pytest.raises(
        ts.ContractError, match=r"wrap\(\): found ranges= and student=; .* as in student=\{'use': 'table'"
    ):
        ts.wrap(lambda y: 0.5, action=ts.scalar(-1, 1), ranges=(0, 1), student="silent")


def test_nothing_is_said_where_nothing_fails(caplog: pytest.LogCaptureFixture) -> None:
    loop = ts.wrap(lambda y: 0.5, action=ts.scalar(-1, 1), ranges=[(0, 1)])
    for _ in range(3):
        loop.step(0.25)
    assert [] == told(caplog)


class Hotter:
    def __init__(self, limit: float) -> None:
        self.limit = limit

    def __call__(self, y: float) -> bool:
        return y > self.limit


def beyond(limit: float, y: float) -> bool:
    return y > limit


@pytest.mark.parametrize("condition", [Hotter(80), functools.partial(beyond, 80), Hotter(80).__call__])
def test_a_condition_is_anything_that_can_be_called(condition: Any) -> None:
    loop = ts.wrap(lambda y: 0.5, action=ts.scalar(-1, 1), condition=condition)
    loop.step(20.0)
    loop.step(90.0)
    turn = loop.engine.last
    assert turn is not None
    assert turn.outcome is not None
    assert ("condition-1",) == turn.outcome.violated


@pytest.mark.parametrize("condition", [5, "y > 3"])
def test_a_condition_that_is_no_function_is_a_sentence(condition: Any) -> None:
    with pytest.raises(ts.ContractError, match=r"condition 'condition-1': found .*; expected a function, as in lambda"):
        ts.wrap(lambda y: 0.5, action=ts.scalar(-1, 1), condition=condition)
