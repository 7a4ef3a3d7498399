"""Operational conditions: assertions on the resulting state; true means violated (Thesis 3.2.2.5)."""

from __future__ import annotations

import abc
from collections.abc import Sequence
from typing import Any

from tutorstudent.core.roles import part
from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.leaves import Condition
from tutorstudent.core.roles.part import Component, Field
from tutorstudent.core.roles.part_options import Part
from tutorstudent.core.words.records import StateT
from tutorstudent.sims.pioneer.types import PioneerState


class Bumped(Condition[PioneerState]):
    """The robot reports that it hit an obstacle, at any moment since the decision (Thesis 3.3.5).

    Its margins are the sonar readings, in metres; where it is violated, the smallest is 0, since the robot's outline is
    not where its sonars are.
    """

    name = "bumped"

    def violated(self, state: PioneerState) -> bool:
        return state.bumped or state.stalled

    def margins(self, state: PioneerState) -> Sequence[float]:
        margins: list[float] = state.sonar_m.tolist()
        if self.violated(state):
            margins[int(state.sonar_m.argmin())] = 0.0
        return margins


class Near(Condition[PioneerState]):
    """A sonar reads less than a clearance. Its margins are the readings beyond the clearance, in metres."""

    name = "near"

    class Options(part.Options):
        """How near is too near."""

        clearance_m: float = Field(default=0.15, ge=0, description="smallest allowed sonar reading, metres")

    def violated(self, state: PioneerState) -> bool:
        return bool(state.sonar_m.min() < self.options.clearance_m)

    def margins(self, state: PioneerState) -> Sequence[float]:
        margins: list[float] = (state.sonar_m - self.options.clearance_m).tolist()
        return margins


class _Composed(Condition[StateT]):
    """Several conditions taken as one. All of them are asked, every time: a condition may have a memory."""

    class Options(part.Options):
        """Which conditions."""

        of: list[Part[Condition[Any]]] = Field(min_length=1, description="the conditions to combine")

    @property
    def label(self) -> str:
        return f"{self.name}({', '.join(part.label for part in self.options.of)})"

    def violated(self, state: StateT) -> bool:
        return self._join([part.violated(state) for part in self.options.of])

    def margins(self, state: StateT) -> Sequence[float] | None:
        found = [part.margins(state) for part in self.options.of]
        return self._join_margins([() if margins is None else margins for margins in found]) or None

    @abc.abstractmethod
    def _join(self, answers: list[bool]) -> bool: ...

    @abc.abstractmethod
    def _join_margins(self, margins: list[Sequence[float]]) -> list[float]: ...


class AnyOf(_Composed[StateT]):
    """Violated if any of its conditions is. Its margins are all of theirs."""

    name = "any-of"

    def _join(self, answers: list[bool]) -> bool:
        return any(answers)

    def _join_margins(self, margins: list[Sequence[float]]) -> list[float]:
        return [margin for each in margins for margin in each]


class AllOf(_Composed[StateT]):
    """Violated if all of its conditions are. Its margin is the largest of theirs, if all declare any."""

    name = "all-of"

    def _join(self, answers: list[bool]) -> bool:
        return all(answers)

    def _join_margins(self, margins: list[Sequence[float]]) -> list[float]:
        return [max(min(each) for each in margins)] if all(map(len, margins)) else []


class Not(Condition[StateT]):
    """Violated where another condition is not."""

    name = "not"

    class Options(part.Options):
        """Which condition."""

        of: Part[Condition[Any]] = Field(description="the condition to turn round")

    @property
    def label(self) -> str:
        return f"not({self.options.of.label})"

    def violated(self, state: StateT) -> bool:
        return not self.options.of.violated(state)


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the shipped conditions."""
    return [Bumped, Near, AnyOf, AllOf, Not]
