"""Any Gymnasium environment with a continuous action space as a world."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any, ClassVar

from tutorstudent.core.deciding.guard import is_owners
from tutorstudent.core.roles import part
from tutorstudent.core.roles.part import Field
from tutorstudent.core.roles.world import Step, World
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import ContractError, PipelineError, say_error
from tutorstudent.core.words.measures import Measure, Summary
from tutorstudent.core.words.snapshots import take_snapshot
from tutorstudent.sims.gym.loading import load_gymnasium
from tutorstudent.sims.gym.spaces import check_box, check_fit, make_box_values
from tutorstudent.sims.gym.types import GymState, make_info, make_reward

LARGEST_SEED = 2**31
"""Many environments hand their seed to what takes no larger one."""


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
    _count = 0

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
        self._return, self._count = 0.0, 0
        with self._blame("reset()", "return (observation, info)"):
            observation, info = self._env.reset(seed=seed % LARGEST_SEED)
            return GymState(take_snapshot(observation), info=make_info(info))

    def step(self, action: Action) -> Step[GymState]:
        if self._env is None:
            raise ContractError("world 'gymnasium': no trial is running; call reset(seed) first.")
        if type(action) is not self._fits:
            self._check(type(action))
        values = make_box_values(action, self._env.action_space)
        with self._blame(
            f"step() {self._count} of a trial", "return (observation, reward, terminated, truncated, info)"
        ):
            observation, reward, terminated, truncated, info = self._env.step(values)
            state = GymState(
                take_snapshot(observation), make_reward(reward), bool(terminated), bool(truncated), make_info(info)
            )
        self._count += 1
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
        except BaseException as error:  # whatever an environment of somebody else raises
            if is_owners(error):
                raise
            raise PipelineError(f"{self._format_name()}: it cannot be made: {say_error(error)}") from error
        try:
            check_box(env.action_space, self._format_name())
        except ContractError:
            env.close()
            raise
        self._env = env

    @contextmanager
    def _blame(self, method: str, remedy: str) -> Iterator[None]:
        try:
            yield
        except BaseException as error:  # whatever an environment of somebody else raises or returns
            if is_owners(error):
                raise
            raise ContractError(
                f"{self._format_name()}: {method} failed: {say_error(error)} An environment has to {remedy}."
            ) from error

    def _check(self, action: type[Action]) -> None:
        check_fit(action, self._env.action_space, self._format_name())
        self._fits = action

    def _format_name(self) -> str:
        return f"world 'gymnasium' ({self.options.id})"
