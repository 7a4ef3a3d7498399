"""The Pioneer world as a Gymnasium environment."""

from __future__ import annotations

import math
from typing import Any, cast

import gymnasium
import numpy as np
from gymnasium.spaces import Box, Dict, Discrete
from numpy.typing import NDArray

from tutorstudent.sims.gym.drawing import draw_picture
from tutorstudent.sims.gym.scoring import Weights, check_weights, score
from tutorstudent.sims.pioneer.pioneer_world import PioneerWorld
from tutorstudent.sims.pioneer.types import Blob, DriveAction, PioneerState

Observation = dict[str, Any]
WEIGHTS: Weights = {"encounters": 1.0, "collided": -1.0}
"""The thesis counts attractors and collisions and weighs neither; so equally. Choice: see docs/fidelity.md."""


class PioneerEnv(gymnasium.Env[Observation, NDArray[np.float32]]):
    """Drive a Pioneer by translation and rotation, fractions of full speed.

    The observation is what the robot senses: 16 sonars in metres, the stall flag, and for the nearest red and blue
    thing in view whether there is one, its bearing (rad, left positive), range (m) and width (rad). Trials never end
    by themselves; the registered environment cuts them off after 1000 decisions.

    Args:
        weights: The reward, as the worth of one unit of the world's events.
        render_mode: ``rgb_array`` or none.
        options: Of the world, as in ``scene="cave-box"``.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": 5}

    def __init__(self, weights: Weights = WEIGHTS, render_mode: str | None = None, **options: Any) -> None:
        self.world = PioneerWorld(**options)
        self.world.setup()
        self.render_mode = render_mode
        self._weights = check_weights(weights, self.world.event_names)
        self.action_space = Box(-1.0, 1.0, (2,), np.float32)
        self._far_m = float(self.world.options.camera_range_m)
        thing = Box(np.array([0, -math.pi, 0, 0], np.float32), np.array([1, math.pi, self._far_m, math.pi], np.float32))
        sonars = Box(0.0, float(self.world.options.sonar_range_m), (16,), np.float32)
        self.observation_space = Dict({"sonar_m": sonars, "stalled": Discrete(2), "red": thing, "blue": thing})

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Begin a trial with a seed of its own, drawn from the environment's."""
        super().reset(seed=seed)
        return self._make_observation(self.world.reset(int(self.np_random.integers(2**31)))), {}

    def step(self, action: NDArray[np.float32]) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Hold the command for one decision. The info has the world's events."""
        step = self.world.step(make_drive_action(*np.clip(action, -1.0, 1.0).tolist()))
        reward = score(self._weights, step.events)
        return self._make_observation(step.state), reward, step.done, step.truncated, dict(step.events)

    def render(self) -> Any:
        """Return the world as it is now, from above."""
        return draw_picture(self.world.sketch()) if self.render_mode == "rgb_array" else None

    def close(self) -> None:
        """Release the simulator."""
        self.world.close()

    def _make_observation(self, state: PioneerState) -> Observation:
        seen = {
            "sonar_m": state.sonar_m.astype(np.float32),
            "stalled": np.int64(state.stalled),
            "red": self._observe_thing(state, "red"),
            "blue": self._observe_thing(state, "blue"),
        }
        return cast(Observation, seen)

    def _observe_thing(self, state: PioneerState, colour: str) -> NDArray[np.float32]:
        blob = next((blob for blob in state.blobs if blob.colour == colour), None)
        found = (0.0, 0.0, self._far_m, 0.0) if blob is None else self._measure(blob)
        return np.array(found, np.float32)

    def _measure(self, blob: Blob) -> tuple[float, float, float, float]:
        return 1.0, blob.bearing_rad, min(blob.range_m, self._far_m), blob.width_rad


def make_drive_action(translation: float, rotation: float) -> DriveAction:
    """Return a command of the kind that its larger component says; both components are driven.

    >>> make_drive_action(-0.5, 0.2).kind, make_drive_action(0.0, 0.0).kind
    ('backward', 'stop')
    """
    if translation == 0 and rotation == 0:
        return DriveAction(kind="stop")
    if abs(translation) >= abs(rotation):
        return DriveAction(
            kind="forward" if translation > 0 else "backward", translation=translation, rotation=rotation
        )
    return DriveAction(kind="left" if rotation > 0 else "right", translation=translation, rotation=rotation)
