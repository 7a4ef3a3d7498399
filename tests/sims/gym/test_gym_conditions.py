"""Conditions on what an environment says; true is violated, margin 0 is the edge."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import tutorstudent as ts
from tutorstudent.sims.gym import GymState, InfoTrue, ObservationOutside, RewardBelow, Terminated

SEEN = GymState(np.array([[0.5, -2.0]]), 1.0, False, False, {"crashed": np.True_, "lap": 0})


@pytest.mark.parametrize(("reward", "violated"), [(1.0, False), (0.99, True), (math.nan, True), (math.inf, False)])
def test_a_reward_below_the_threshold_violates(reward: float, violated: bool) -> None:
    assert violated is RewardBelow(threshold=1.0).violated(GymState(None, reward))


def test_the_margin_is_the_reward_beyond_the_threshold() -> None:
    assert [0.25] == RewardBelow(threshold=0.75).margins(SEEN)


@pytest.mark.parametrize(("key", "violated"), [("crashed", True), ("lap", False)])
def test_a_true_value_of_the_info_violates(key: str, violated: bool) -> None:
    condition = InfoTrue(key=key)
    assert violated is condition.violated(SEEN)
    assert f"info-true({key})" == condition.label


def test_a_key_that_is_not_there_is_told() -> None:
    with pytest.raises(ts.ContractError, match=r"no 'crash' \(did you mean 'crashed'\?\); it has crashed, lap"):
        InfoTrue(key="crash").violated(SEEN)


@pytest.mark.parametrize(
    ("index", "low", "high", "violated", "margins"),
    [
        (0, 0.0, 1.0, False, [0.5, 0.5]),
        (0, 0.5, 1.0, False, [0.0, 0.5]),
        (1, -1.0, 1.0, True, [-1.0, 3.0]),
        (1, -3.0, -2.5, True, [1.0, -0.5]),
    ],
)
def test_a_number_outside_its_range_violates(
    index: int, low: float, high: float, violated: bool, margins: list[float]
) -> None:
    condition = ObservationOutside(index=index, low=low, high=high)
    assert (violated, margins) == (condition.violated(SEEN), condition.margins(SEEN))
    assert f"observation-outside({index})" == condition.label


def test_a_number_that_is_none_violates() -> None:
    assert ObservationOutside(index=0, low=0, high=1).violated(GymState(np.array([math.nan])))


@pytest.mark.parametrize(
    ("observation", "message"),
    [
        (np.zeros(2), "there is no number 3; the observation has 2, counted from 0"),
        ({"x": 1}, "the observation is a dict; it reads arrays of numbers"),
        ("x", "the observation is a str"),
    ],
)
def test_an_observation_without_that_number_is_told(observation: Any, message: str) -> None:
    with pytest.raises(ts.ContractError, match=message):
        ObservationOutside(index=3, low=0, high=1).violated(GymState(observation))


def test_a_range_is_low_before_high() -> None:
    with pytest.raises(ts.PipelineError, match="low is not below high"):
        ObservationOutside(index=0, low=1, high=1)


@pytest.mark.parametrize("ended", [True, False])
def test_the_end_of_a_trial_can_be_a_violation(ended: bool) -> None:
    assert ended is Terminated().violated(GymState(None, 0.0, ended))
