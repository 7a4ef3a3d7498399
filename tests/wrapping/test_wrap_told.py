"""What `wrap` says of parts that fail, and of conditions that are none."""

from __future__ import annotations

import functools
from typing import Any

import pytest

import tutorstudent as ts


def told(caplog: pytest.LogCaptureFixture) -> list[str]:
    return [record.getMessage() for record in caplog.records if record.name == "tutorstudent"]


def test_a_part_that_fails_in_every_decision_is_told_once(caplog: pytest.LogCaptureFixture) -> None:
    loop = ts.wrap(lambda y: 0.5, action=ts.scalar(-1, 1), ranges=[(0, 1), (0, 1)])
    for _ in range(5):
        assert 0.5 == loop.step(0.25)
    (message,) = told(caplog)
    assert "decision 0: student: raised: ValueError: the state has 1 numbers; 2 ranges are declared." in message
    assert 5 <= sum(loop.engine.incident_counts.values())


def test_every_part_that_fails_is_told(caplog: pytest.LogCaptureFixture) -> None:
    def hot(y: float) -> bool:
        raise RuntimeError("no reading")

    loop = ts.wrap(lambda y: 0.5, action=ts.scalar(-1, 1), condition=hot, ranges=[(0, 1), (0, 1)])
    for _ in range(3):
        loop.step(0.25)
    assert ["conditions.condition-1", "student"] == sorted(message.split(": ")[1] for message in told(caplog))


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
