"""The reference world: Pioneers in a plane arena (Thesis 4.1), in pybullet.

Time runs in ticks. An action is held for ``max(1, round(duration_s / tick_s))`` ticks and at least
``ticks_per_decision``; the other robots act in every tick; the state is sampled after the last. What the learner reads
is as old as its latency, in ticks, however long decisions are: with a latency longer than a decision, a violation is
credited to a later decision than the one that caused it. Without latency there are no collisions at any speed.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, ClassVar

from tutorstudent.core.roles.world import Sketch, Step, World
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.measures import Measure, Summary
from tutorstudent.sims.pioneer.bullet import Bullet, load_pybullet
from tutorstudent.sims.pioneer.events import EVENTS
from tutorstudent.sims.pioneer.layout import Layout, load_layout
from tutorstudent.sims.pioneer.scene_files import make_lasting_name
from tutorstudent.sims.pioneer.trial import Trial
from tutorstudent.sims.pioneer.types import DriveAction, PioneerState
from tutorstudent.sims.pioneer.world_options import PioneerOptions


class PioneerWorld(World[PioneerState, DriveAction]):
    """Pioneers in a plane arena, among walls, boxes, prey and predators. Trials never end by themselves."""

    name: ClassVar[str] = "pioneer"
    action: type[Action] = DriveAction
    goal_event: ClassVar[str] = "encounters"
    Options = PioneerOptions
    options: PioneerOptions

    _bullet: Bullet | None = None
    _layout: Layout | None = None
    _trial: Trial | None = None

    @property
    def event_names(self) -> Mapping[str, Summary | Measure]:
        return EVENTS

    def setup(self) -> None:
        """Read the scene and open the physics client.

        Raises:
            PipelineError: The scene cannot be used, or pybullet is not installed.
        """
        self._layout = load_layout(
            self.options.scene, self.options.side_m, self.options.box_side_m, self.options.box_places
        )
        if self._bullet is None:
            self.connect(Bullet(load_pybullet(), self.options.gui))

    def connect(self, bullet: Bullet) -> None:
        """Use this physics client, which `close` will release; for benchmarks that log its calls."""
        self._bullet = bullet

    def reset(self, seed: int) -> PioneerState:
        if self._layout is None or self._bullet is None:
            self.setup()
        assert self._layout is not None  # noqa: S101 - setup has read it
        assert self._bullet is not None  # noqa: S101 - setup has opened it
        self._trial = Trial(self._bullet, self._layout, self.options, seed)
        return self._trial.sense()

    def step(self, action: DriveAction) -> Step[PioneerState]:
        trial = self._require_trial()
        options = self.options
        speed = action.translation * options.full_speed_mps
        turn = action.rotation * math.radians(options.full_turn_degps)
        for _ in range(self.count_ticks(action.duration_s)):
            trial.tick((speed, turn))
        return Step(trial.sense(), trial.take_events())

    def count_ticks(self, duration_s: float) -> int:
        """Return for how many ticks an action of this duration is held."""
        return max(1, round(duration_s / self.options.tick_s), self.options.ticks_per_decision)

    def describe(self) -> dict[str, Any]:
        """Return the world as a pipeline in any folder would name it: a scene's path is absolute."""
        return super().describe() | {"scene": make_lasting_name(self.options.scene)}

    def sketch(self) -> Sketch:
        return self._require_trial().sketch()

    def close(self) -> None:
        """Release the physics client. A later `reset` opens a new one."""
        super().close()
        if self._bullet is not None:
            self._bullet.close()
        self._bullet = None
        self._trial = None

    def _require_trial(self) -> Trial:
        if self._trial is None:
            raise ContractError("world 'pioneer': no trial is running; call reset(seed) first.")
        return self._trial
