"""What a Gymnasium environment says, as the state of a world."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple


class GymState(NamedTuple):
    """A copy of what the environment's `step` returned; its arrays are read-only."""

    observation: Any
    """As the environment gives it, most often an array."""
    reward: float = 0.0
    """Of the last step; 0 at the beginning of a trial."""
    terminated: bool = False
    truncated: bool = False
    info: Mapping[str, Any] = {}
