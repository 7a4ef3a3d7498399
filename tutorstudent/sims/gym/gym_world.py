"""Any Gymnasium environment with a continuous action space as a world."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from tutorstudent.core.roles import part
from tutorstudent.core.roles.part import Field
from tutorstudent.core.roles.world import Step, World
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import ContractError, PipelineError
from tutorstudent.core.words.measures import Measure, Summary
from tutorstudent.core.words.snapshots import take_snapshot
from tutorstudent.sims.gym.loading import load_gymnasium
from tutorstudent.sims.gym.spaces import check_box, check_fit, make_box_values
from tutorstudent.sims.gym.types import GymState


class GymnasiumWorld(World[GymState, Action]):
    """An environment by its id. Terminated ends a trial; truncated cuts it off, and its last decision teaches nothing.

    It executes every action class whose components are the numbers of the action space, in order and within its
    bounds; kinds are the tutor's own affair. The tutor is a function of a `GymState`.
    """

    name: ClassVar[str] = "gymnasium"
    action: type[Action] = Action
    goal_event: ClassVar[str] = "reward"

    class Options(part.Options):
        """Which environment."""

        id: str = Field(min_length=1, description="registered id, as in Pendulum-v1, or module:id")
        kwargs: dict[str, Any] = Field({}, description="arguments of the environment, plain values")
        max_steps: int | None = Field(None, ge=1, description="length of a trial instead of its own, decisions")

    _env: Any = None
    _fits: type[Action] | None = None
    _return = 0.0

    @property
    def event_names(self) -> Mapping[str, Summary | Measure]:
        last = "what the last trial had come to when the run ended"
        return {
            "reward": Measure("reward", better="more", description="what the environment pays"),
            "episode_return": Measure("episode_return", "return", summed="last", description=last, detail=True),
            "episodes": Measure("episodes", description="trials that ended", detail=True),
        }

    def setup(self) -> None:
        """Make the environment.

        Raises:
            PipelineError: It cannot be made, or gymnasium is not installed.
            ContractError: Its action space has nothing to amplify, or does not fit the tutor's actions.
        """
        self._open()
        self._check(self.action_class)

    def reset(self, seed: int) -> GymState:
        if self._env is None:
            self._open()
        self._return = 0.0
        observation, info = self._env.reset(seed=seed)
        return GymState(take_snapshot(observation), info=take_snapshot(info))

    def step(self, action: Action) -> Step[GymState]:
        if self._env is None:
            raise ContractError("world 'gymnasium': no trial is running; call reset(seed) first.")
        if type(action) is not self._fits:
            self._check(type(action))
        observation, reward, terminated, truncated, info = self._env.step(
            make_box_values(action, self._env.action_space)
        )
        state = GymState(
            take_snapshot(observation), float(reward), bool(terminated), bool(truncated), take_snapshot(info)
        )
        self._return += state.reward
        ended = state.terminated or state.truncated
        events = {"reward": state.reward, "episode_return": self._return, "episodes": float(ended)}
        return Step(state, events, state.terminated, state.truncated)

    def close(self) -> None:
        """Close the environment. A later `reset` makes a new one."""
        super().close()
        if self._env is not None:
            self._env.close()
        self._env = None

    def _open(self) -> None:
        gymnasium = load_gymnasium()
        limit = {} if self.options.max_steps is None else {"max_episode_steps": self.options.max_steps}
        try:
            env = gymnasium.make(self.options.id, **limit, **self.options.kwargs)
        except (gymnasium.error.Error, TypeError, ValueError, ImportError) as error:
            raise PipelineError(f"{self._format_name()}: it cannot be made: {type(error).__name__}: {error}") from None
        try:
            check_box(env.action_space, self._format_name())
        except ContractError:
            env.close()
            raise
        self._env = env

    def _check(self, action: type[Action]) -> None:
        check_fit(action, self._env.action_space, self._format_name())
        self._fits = action

    def _format_name(self) -> str:
        return f"world 'gymnasium' ({self.options.id})"
