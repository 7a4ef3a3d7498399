"""Gymnasium both ways: its environments as worlds; the Pioneer and any pipeline as environments.

The environments are in `tutorstudent.sims.gym.envs`; importing that registers them.
"""

from __future__ import annotations

from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.part import Component
from tutorstudent.sims.gym.conditions import InfoTrue, ObservationOutside, RewardBelow, Terminated
from tutorstudent.sims.gym.gym_world import GymnasiumWorld
from tutorstudent.sims.gym.spaces import box_action
from tutorstudent.sims.gym.types import GymState

__all__ = ["GymState", "GymnasiumWorld", "InfoTrue", "ObservationOutside", "RewardBelow", "Terminated", "box_action"]


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the world and the conditions on its states."""
    return [GymnasiumWorld, RewardBelow, InfoTrue, ObservationOutside, Terminated]
