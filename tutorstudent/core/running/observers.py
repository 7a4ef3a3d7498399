"""Observers see every decision with all that became of it. They hang on the runner, outside the algorithm."""

from __future__ import annotations

import abc
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any, ClassVar, NamedTuple

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.roles.part import Component
from tutorstudent.core.roles.world import Step, World
from tutorstudent.core.running.ratios import measure_ratio
from tutorstudent.core.words.measures import Measure
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
    measures: Sequence[Measure] = ()
    """What `observe` returns numbers of; each gets its column, its curve and its test in comparisons."""

    def begin(self, begin: Begin) -> None:
        """Hear what is about to run. From here on `measures` are known."""

    @abc.abstractmethod
    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> Mapping[str, float] | None:
        """See one decision. Called once per decision, after it was judged.

        Returns:
            The decision's numbers by the names of `measures`, which the run records and sums up; what is missing was
            not measured in this decision, and None is nothing at all.
        """

    def summary(self) -> Mapping[str, float]:
        """Return what it counted by itself, by name: numbers that only a whole run has.

        A number of the name of one of its `measures` stands for the sum.
        """
        return {}


TALLIED = (
    Measure(
        "violated",
        "violated decisions",
        better="less",
        description="decisions after which a condition was violated, as the learner saw it, which may be late",
    ),
    Measure("mean_level", "mean level", summed="mean", description="amplification level over all decisions"),
    Measure(
        "executed_ratio",
        "executed / said",
        summed="mean",
        description="executed command as a multiple of the tutor's own, where that is not at neutral",
        detail=True,
    ),
    Measure(
        "match_rate",
        "named the tutor's kind",
        unit="%",
        summed="mean",
        description="share of decisions in which the student named the tutor's kind; only of students that name kinds",
        detail=True,
    ),
    Measure(
        "amplified_share",
        "raised by the amplifier",
        unit="%",
        summed="mean",
        description="share of decisions in which the amplifier raised the level; controls set theirs without it",
        detail=True,
    ),
    Measure("taught", "lessons", description="how often the student was taught", detail=True),
    Measure("incidents", description="what parts did against their contract", detail=True),
)
"""What every run measures, whatever its parts."""


class Tally(Observer):
    """Counts what every run is asked for: decisions, violations, amplification, levels, matches, incidents."""

    name = "tally"

    def __init__(self, **options: Any) -> None:
        super().__init__(**options)
        self._sums: Counter[str] = Counter()
        self._ratio = 0.0
        self._violated: Counter[str] = Counter()
        self._situations: Counter[str] = Counter()

    def begin(self, begin: Begin) -> None:
        # A condition that was never violated counts 0; it is not unknown.
        self._violated.update({condition.label: 0 for condition in begin.engine.conditions})

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> None:
        decision, sums = turn.decision, self._sums
        sums["decisions"] += 1
        sums["amplified"] += decision.amplified
        sums["level"] += decision.resulting.level
        if (ratio := measure_ratio(decision)) is not None:
            self._ratio += ratio
            sums["sized"] += 1
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

        ``executed_ratio`` is the mean of what was executed as a multiple of the tutor's own command; there is none
        where that was always at neutral. ``match_rate`` is the share of decisions in which the student named the
        tutor's kind; a student that proposes levels only has none.
        """
        decisions = max(1, self._sums["decisions"])
        matched = {"match_rate": self._sums["matched"] / decisions} if self._sums["naming"] else {}
        counts = {key: float(self._sums[key]) for key in ("decisions", "violated", "amplified", "taught", "incidents")}
        ratio = {"executed_ratio": self._ratio / self._sums["sized"]} if self._sums["sized"] else {}
        return (
            counts
            | {"mean_level": self._sums["level"] / decisions}
            | ratio
            | matched
            | {f"{VIOLATED}{name}": float(count) for name, count in sorted(self._violated.items())}
            | {f"share:{name}": count / decisions for name, count in sorted(self._situations.items()) if name}
        )


VIOLATED = "violated:"
"""Stands before the name of a condition in summaries."""


def make_tally_measures(engine: Engine[Any, Any, Any]) -> list[Measure]:
    """Return what `Tally` measures of an engine: of several conditions also each by itself."""
    labels = [condition.label for condition in engine.conditions]
    of_each = [
        Measure(
            f"{VIOLATED}{label}",
            f"violated {label}",
            better="less",
            description=f"decisions after which {label} was violated",
        )
        for label in labels
    ]
    return [*TALLIED, *(of_each if len(labels) > 1 else ())]


class Entries(Observer):
    """Counts how often the tutor enters a situation; what `tutorstudent compare` takes for the tutor's achievement.

    The end of a trial ends a stay, so that the next trial may begin with an entry.
    """

    situation: ClassVar[str] = ""
    """What `Tutor.situation` says while it is in."""
    counted: ClassVar[str] = ""
    """Name of the count in summaries."""

    def begin(self, begin: Begin) -> None:
        about = f"how often the tutor entered the situation '{self.situation}'"
        self.measures = [Measure(self.counted, better="more", description=about)]
        self._was_in = False
        self._entries = 0

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> Mapping[str, float]:
        is_in = turn.decision.moment.situation == self.situation
        entered = is_in and not self._was_in
        self._was_in = is_in and not (step.done or step.truncated)
        self._entries += entered
        return {self.counted: float(entered)}

    def summary(self) -> Mapping[str, float]:
        """Return the count up to now."""
        return {self.counted: float(self._entries)}
