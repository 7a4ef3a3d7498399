"""An action class made for a Box: its bounds, its names, what is amplified."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest
from gymnasium.spaces import Box, Dict, Discrete, MultiDiscrete

import tutorstudent as ts
from tutorstudent.sims.gym import box_action

CAR = Box(np.array([-1, 0, 0], np.float32), np.array([1, 1, 1], np.float32))


def test_it_has_the_boxs_bounds_and_all_numbers_are_amplified_together() -> None:
    action = box_action(Box(-2.0, 2.0, (2, 1)))
    words = action.vocabulary
    assert [("x0", -2.0, 2.0), ("x1", -2.0, 2.0)] == [spec[:3] for spec in words.components.values()]
    assert [("x0", "x1")] == [group.names for group in words.groups["command"]]
    assert [0.5, 1.0] == [getattr(action.read([0.5, 1.0]), name) for name in words.components]


def test_numbers_have_names_and_are_amplified_one_by_one() -> None:
    action = box_action(CAR, ["steer", "gas", "brake"], amplified=["gas", "brake"])
    groups = action.vocabulary.groups["command"]
    assert [(("gas",), "outward"), (("brake",), "outward")] == [(group.names, group.direction) for group in groups]


def test_a_neutral_other_than_zero() -> None:
    action = box_action(Box(1.0, 3.0, (1,)), neutral=2.0)
    assert 2.0 == action.vocabulary.components["x0"].neutral


@pytest.mark.parametrize(
    "space", [Discrete(3), MultiDiscrete([2, 2]), Dict({"x": Box(0, 1, (1,))}), Box(0, 5, (1,), np.int64)]
)
def test_a_space_without_magnitudes_is_refused(space: Any) -> None:
    with pytest.raises(ts.ContractError, match=re.escape(f"box_action(): the action space {space} has no magnitudes")):
        box_action(space)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"names": ["a"]}, "found the names ['a']; the space Box"),
        ({"names": ["a", "b", "a"]}, "needs 3, all different"),
        (
            {"names": ["steer", "gas", "brake"], "amplified": ["gass"]},
            "there is no component 'gass' (did you mean 'gas'?)",
        ),
        ({"neutral": -1.0}, "has the neutral -1.0; it lies in [0.0, 1.0]"),
    ],
)
def test_names_that_do_not_fit_are_told(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(ts.ContractError, match=re.escape(message)):
        box_action(CAR, **arguments)


def test_an_unbounded_number_has_no_scale() -> None:
    with pytest.raises(ts.ContractError, match="has no finite scale"):
        box_action(Box(-np.inf, np.inf, (1,)))
