"""Any pipeline as a Gymnasium environment: its agent replaces the student, under the same contract."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from gymnasium.spaces import Box, Discrete
from numpy.typing import NDArray

from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.roles.world import Step, World
from tutorstudent.core.running.runner import check_world, make_trial_seed
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import ContractError, PipelineError
from tutorstudent.core.words.records import Moment
from tutorstudent.core.words.turn import Turn
from tutorstudent.sims.gym.drawing import draw_picture
from tutorstudent.sims.gym.driven import Driven, drive
from tutorstudent.sims.gym.scoring import Weights, check_weights, score

Observation = NDArray[np.float32]
VIOLATED = "violated"
WEIGHTS: Weights = {VIOLATED: -1.0}


class AmplificationEnv(gymnasium.Env[Observation, np.int64]):
    """Choose the amplification level of every decision; the tutor chooses everything else.

    The action is a level, the observation what the pipeline's encoder makes of the state and the tutor's action. The
    engine works as in the pipeline, with its conditions and limits: a level beyond the limits is lowered, a failing
    part falls back to the tutor's own action. ``reset(seed=...)`` builds the parts anew from that seed; without a
    seed, the next trial of the same run begins.

    Args:
        pipeline: A pipeline, or its file. Its student's encoder and everything but student, selector and amplifier is
            used; how far a level moves a component stays the amplifier's.
        max_level: The highest level that can be chosen.
        weights: The reward, as the worth of one unit of ``violated`` (1 if any condition is violated) and of the
            world's events.
        encoded: Lowest and highest number of the encoder.
        render_mode: ``rgb_array`` or none.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": 5}

    def __init__(
        self,
        pipeline: Pipeline | Path | str,
        max_level: int = 8,
        weights: Weights = WEIGHTS,
        encoded: tuple[float, float] = (0.0, 1.0),
        render_mode: str | None = None,
    ) -> None:
        if max_level < 1:
            raise PipelineError(f"max_level: found {max_level}; the highest level is at least 1.")
        self._pipeline = pipeline if isinstance(pipeline, Pipeline) else Pipeline.read(pipeline)
        self._driven: Driven = drive(self._pipeline)
        self.world: World[Any, Any] = self._pipeline.world(self._driven.tutor.action)
        check_world(self._driven.engine, self.world)
        self._weights = check_weights(weights, {VIOLATED: None, **self.world.event_names})
        self.render_mode = render_mode
        self.action_space = Discrete(max_level + 1)
        self.observation_space = Box(*encoded, (self._encoder.width,), np.float32)
        self._seed, self._trial = self._pipeline.header.seed, 0
        self._begun = False

    @property
    def engine(self) -> Any:
        """The engine, for its records, incidents and limits."""
        return self._driven.engine

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Begin a trial: the first of a new run where a seed is given, the next one otherwise."""
        super().reset(seed=seed)
        if seed is not None:
            self._driven.engine.close()
            self._driven = drive(self._pipeline.replaced({"seed": seed}))
            self._seed, self._trial = seed, 0
        self._driven.engine.reset()
        state = self.world.reset(make_trial_seed(self._seed, self._trial))
        self._trial += 1
        self._begun = True
        return self._observe(state, self._ask(state)), {}

    def step(self, action: Any) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Execute the tutor's action at this level.

        The info has the level that was executed, whether a condition is violated, and the world's events. After the
        last decision of a trial the tutor is not asked again; the observation then has its last action.
        """
        if not self._begun:
            raise ContractError("step(): no trial is running; call reset() first.")
        if not self.action_space.contains(action):
            raise ContractError(f"step(): found {action!r}; a level is a whole number in {self.action_space}.")
        engine = self._driven.engine
        self._driven.student.level = int(action)
        step = self.world.step(engine.propagate(self._state))
        if step.truncated and not step.done:
            engine.drop()
        else:
            engine.evaluate(step.state)
        turn = engine.last
        assert turn is not None  # noqa: S101 - the decision was just judged or dropped
        ended = step.done or step.truncated
        seen = self._observe(step.state, turn.decision.moment.tutor_action if ended else self._ask(step.state))
        return seen, self._make_reward(turn, step), step.done, step.truncated and not step.done, _make_info(turn, step)

    def render(self) -> Any:
        """Return the world as it is now, from above; white where it does not draw itself."""
        return draw_picture(self.world.sketch()) if self.render_mode == "rgb_array" else None

    def close(self) -> None:
        """Let every part and the world go."""
        self._driven.engine.close()
        self.world.close()

    @property
    def _encoder(self) -> Any:
        return self._driven.student.options.encoder

    def _ask(self, state: Any) -> Action:
        return self._driven.tutor.ask(state, self._driven.engine.on_tutor_failure)

    def _observe(self, state: Any, shown: Action) -> Observation:
        self._state = state
        moment = Moment(self._driven.engine.decisions, state, shown, self._driven.tutor.situation)
        seen = np.array(self._encoder.encode(moment), np.float32)
        if not self.observation_space.contains(seen):
            raise ContractError(
                f"encoder '{self._encoder.name}': returned {seen}; expected {self.observation_space}. State the range "
                "of its numbers, as in encoded=(-1.0, 1.0)."
            )
        return seen

    def _make_reward(self, turn: Turn[Any, Any], step: Step[Any]) -> float:
        return score(self._weights, {**step.events, VIOLATED: _read_violated(turn)})


def _read_violated(turn: Turn[Any, Any]) -> float:
    return float(turn.outcome is not None and bool(turn.outcome.violated))


def _make_info(turn: Turn[Any, Any], step: Step[Any]) -> dict[str, Any]:
    return {**step.events, "level": turn.decision.resulting.level, VIOLATED: _read_violated(turn)}
