"""Operational conditions on what a Gymnasium environment says."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from pydantic import model_validator

from tutorstudent.core.roles import part
from tutorstudent.core.roles.leaves import Condition
from tutorstudent.core.roles.part import Field
from tutorstudent.core.words.errors import ContractError, list_names, suggest
from tutorstudent.sims.gym.types import GymState


class RewardBelow(Condition[GymState]):
    """The reward of a step is below a threshold, or is no number. Its margin is the reward beyond the threshold."""

    name = "reward-below"

    class Options(part.Options):
        """How little is too little."""

        threshold: float = Field(description="smallest reward of a step that is no violation")

    def violated(self, state: GymState) -> bool:
        return not state.reward >= self.options.threshold

    def margins(self, state: GymState) -> Sequence[float]:
        return [state.reward - self.options.threshold]


class InfoTrue(Condition[GymState]):
    """A value of the environment's info is true, as in ``{use: info-true, key: crashed}``.

    Where the environment does not give the key, the condition fails, and so counts as violated.
    """

    name = "info-true"

    class Options(part.Options):
        """Which value."""

        key: str = Field(description="key of the environment's info")

    @property
    def label(self) -> str:
        return f"{self.name}({self.options.key})"

    def violated(self, state: GymState) -> bool:
        key = self.options.key
        if key not in state.info:
            raise ContractError(
                f"condition 'info-true': the info has no '{key}'{suggest(key, state.info)}; it has "
                f"{list_names(state.info)}."
            )
        return bool(state.info[key])


class ObservationOutside(Condition[GymState]):
    """A number of the observation leaves a range, or is no number. Its margins are the distances from both ends."""

    name = "observation-outside"

    class Options(part.Options):
        """Which number and which range."""

        index: int = Field(ge=0, description="index of the number in the flattened observation, from 0")
        low: float = Field(description="smallest value that is no violation, in the observation's unit")
        high: float = Field(description="largest value that is no violation, in the observation's unit")

        @model_validator(mode="after")
        def _check_order(self) -> ObservationOutside.Options:
            if self.low >= self.high:
                raise ValueError("low is not below high")
            return self

    @property
    def label(self) -> str:
        return f"{self.name}({self.options.index})"

    def violated(self, state: GymState) -> bool:
        return not self.options.low <= self._read_value(state) <= self.options.high

    def margins(self, state: GymState) -> Sequence[float]:
        value = self._read_value(state)
        return [value - self.options.low, self.options.high - value]

    def _read_value(self, state: GymState) -> float:
        numbers = np.asarray(state.observation)
        if numbers.dtype.kind not in "fiub":
            raise ContractError(
                f"condition 'observation-outside': the observation is a {type(state.observation).__name__}; "
                "it reads arrays of numbers."
            )
        if self.options.index >= numbers.size:
            raise ContractError(
                f"condition 'observation-outside': there is no number {self.options.index}; the observation has "
                f"{numbers.size}, counted from 0."
            )
        return float(numbers.ravel()[self.options.index])


class Terminated(Condition[GymState]):
    """The environment ended the trial; where that means a failure, as in balancing."""

    name = "terminated"

    def violated(self, state: GymState) -> bool:
        return state.terminated
