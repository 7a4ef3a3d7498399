"""What a Gymnasium environment says, as the state of a world."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from tutorstudent.core.words.snapshots import take_snapshot


def make_reward(reward: Any) -> float:
    """Return a reward as a number; an array of one number is taken too, and None is nothing.

    >>> make_reward(np.array([0.5])), make_reward(None)
    (0.5, 0.0)
    """
    return 0.0 if reward is None else float(np.asarray(reward, dtype=np.float64).item())


def make_info(info: Any) -> Mapping[str, Any]:
    """Return a copy of an info with words as keys; None is an empty one.

    >>> make_info(None), make_info({3: "x"})
    ({}, {'3': 'x'})
    """
    if info is None:
        return {}
    if isinstance(info, Mapping) and not all(isinstance(key, str) for key in info):
        info = {str(key): value for key, value in info.items()}
    found: Mapping[str, Any] = take_snapshot(info)
    return found


class GymState(NamedTuple):
    """A copy of what the environment's `step` returned; its arrays are read-only."""

    observation: Any
    """As the environment gives it, most often an array."""
    reward: float = 0.0
    """Of the last step; 0 at the beginning of a trial."""
    terminated: bool = False
    truncated: bool = False
    info: Mapping[str, Any] = {}
