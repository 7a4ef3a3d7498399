"""Observers see every decision with all that became of it. They hang on the runner, outside the algorithm."""

from __future__ import annotations

import abc
from collections import Counter
from collections.abc import Mapping
from typing import Any, ClassVar, NamedTuple

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.roles.part import Component
from tutorstudent.core.roles.world import Step, Summary, World
from tutorstudent.core.words.proposals import KindProposal
from tutorstudent.core.words.turn import Turn


class Begin(NamedTuple):
    """What an observer is told before the first decision."""

    engine: Engine[Any, Any, Any]
    world: World[Any, Any]
    decisions: int


class Observer(Component):
    """Counts, records or shows what happens. It must not change what it sees."""

    role: ClassVar[str] = "observer"

    def begin(self, begin: Begin) -> None:
        """Hear what is about to run."""

    @abc.abstractmethod
    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> None:
        """See one decision. Called once per decision, after it was judged."""

    def summary(self) -> Mapping[str, float]:
        """Return what it counted, by name."""
        return {}


class Tally(Observer):
    """Counts what every run is asked for: decisions, violations, amplification, levels, matches, incidents."""

    name = "tally"

    def __init__(self, **options: Any) -> None:
        super().__init__(**options)
        self._sums: Counter[str] = Counter()
        self._violated: Counter[str] = Counter()
        self._situations: Counter[str] = Counter()

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> None:
        decision, sums = turn.decision, self._sums
        sums["decisions"] += 1
        sums["amplified"] += decision.amplified
        sums["level"] += decision.resulting.level
        sums["taught"] += turn.lesson is not None
        sums["incidents"] += len(turn.incidents)
        if isinstance(decision.proposal, KindProposal):
            sums["naming"] += 1
            sums["matched"] += decision.proposal.kind == decision.moment.tutor_action.kind
        self._situations[decision.moment.situation] += 1
        if turn.outcome is not None:
            sums["violated"] += bool(turn.outcome.violated)
            self._violated.update(turn.outcome.violated)

    def summary(self) -> Mapping[str, float]:
        """Return counts, the mean level, and the share of decisions spent in each situation.

        ``match_rate`` is the share of decisions in which the student named the tutor's kind; a student that proposes
        levels only has none.
        """
        decisions = max(1, self._sums["decisions"])
        matched = {"match_rate": self._sums["matched"] / decisions} if self._sums["naming"] else {}
        counts = {key: float(self._sums[key]) for key in ("decisions", "violated", "amplified", "taught", "incidents")}
        return (
            counts
            | {"mean_level": self._sums["level"] / decisions}
            | matched
            | {f"violated:{name}": float(count) for name, count in sorted(self._violated.items())}
            | {f"share:{name}": count / decisions for name, count in sorted(self._situations.items()) if name}
        )


class WorldEvents(Observer):
    """Summarizes the world's events, each as the world says."""

    name = "world-events"

    def begin(self, begin: Begin) -> None:
        self._how: Mapping[str, Summary] = begin.world.event_names
        self._values: dict[str, float] = {}
        self._count = 0

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> None:
        self._count += 1
        for name, how in self._how.items():
            value = step.events.get(name, 0.0)
            if how == "last":
                self._values[name] = value
            elif how == "max":
                self._values[name] = max(self._values.get(name, value), value)
            else:
                self._values[name] = self._values.get(name, 0.0) + value

    def summary(self) -> Mapping[str, float]:
        means = [name for name, how in self._how.items() if how == "mean"]
        return self._values | {name: self._values.get(name, 0.0) / max(1, self._count) for name in means}


class Entries(Observer):
    """Counts how often the tutor enters a situation; what `tutorstudent compare` takes for the tutor's achievement.

    The end of a trial ends a stay, so that the next trial may begin with an entry.
    """

    situation: ClassVar[str] = ""
    """What `Tutor.situation` says while it is in."""
    counted: ClassVar[str] = ""
    """Name of the count in summaries."""

    def begin(self, begin: Begin) -> None:
        self._was_in = False
        self._entries = 0

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> None:
        is_in = turn.decision.moment.situation == self.situation
        self._entries += is_in and not self._was_in
        self._was_in = is_in and not (step.done or step.truncated)

    def summary(self) -> Mapping[str, float]:
        return {self.counted: float(self._entries)}
