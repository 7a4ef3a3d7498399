"""What a run leaves behind: arrays of every decision, and files that can be read later. No pickle, no objects."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.deciding.ladder import HIGHEST_LEVEL
from tutorstudent.core.roles.world import Step
from tutorstudent.core.running.arrays import Arrays
from tutorstudent.core.running.meter import Meter
from tutorstudent.core.running.observers import Begin, Observer
from tutorstudent.core.running.ratios import measure_ratio
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.core.words.measures import Measure
from tutorstudent.core.words.turn import Turn

NO_LEVEL = -1


HEADS = (
    "kind",
    "situation",
    "proposed_kind",
    "proposed_level",
    "selected_level",
    "resulting_level",
    "ampbit",
    "limited_by",
    "void",
    "taught_level",
    "taught_ampbit",
    "incidents",
    "incident_part",
    "trial_ended",
)
"""The whole numbers of a decision."""
NAMES = "_names"
"""Ends the columns that hold names; all others have an entry for each decision."""


class Recorder(Observer):
    """Keeps every decision as numbers: kinds, situations, levels, bits, components, violations, lessons, events.

    It shows decisions to the other observers and keeps what they measure too, NaN where they measured nothing.

    `arrays` returns one entry for each column, shape (decisions,) or (decisions, n); names that index into a column
    stand beside it (``kind_names`` for ``kind``). ``said`` is the tutor's own action, ``executed`` what was executed,
    ``executed_ratio`` how many times as much (see `measure_ratio`; NaN at neutral); ``limited_by`` and ``void`` say
    why, with an empty name for nothing; ``incident_part`` is the first that failed. A level that was not proposed or
    not taught is -1. Components that are no floats are left out.
    """

    name = "recorder"

    def __init__(self, observers: Sequence[Observer] = ()) -> None:
        super().__init__()
        self._meter = Meter(observers)

    @property
    def measured(self) -> list[Measure]:
        """What the other observers measure; known once they have begun."""
        return self._meter.measures

    def begin(self, begin: Begin) -> None:
        self._meter.begin(begin)
        specs = begin.engine.tutor.action.vocabulary.components
        self._components = [name for name, spec in specs.items() if spec.number]
        self._conditions = [condition.label for condition in begin.engine.conditions]
        self._events = list(begin.world.event_names)
        self._kinds = list(begin.engine.tutor.action.vocabulary.kinds)
        self._kind_of = {kind: i for i, kind in enumerate(self._kinds)}
        self._situations, self._limits, self._voids, self._parts = _Words(), _Words(""), _Words(""), _Words("")
        self._count = 0
        try:
            self._allocate(begin.decisions)
        except MemoryError:
            raise PipelineError(
                f"there is no memory to record {begin.decisions:,} decisions; ask for fewer, as in decisions: 10000."
            ) from None

    def _allocate(self, decisions: int) -> None:
        self._heads = np.zeros((decisions, len(HEADS)), dtype=np.int32)
        self._said = np.zeros((decisions, len(self._components)))
        self._executed = np.zeros((decisions, len(self._components)))
        self._ratio = np.zeros(decisions)
        self._violated = np.zeros((decisions, len(self._conditions)), dtype=bool)
        self._world = np.zeros((decisions, len(self._events)))
        self._measured = np.zeros((decisions, len(self.measured)))

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> None:
        i, decision = self._count, turn.decision
        self._heads[i] = self._make_head(turn, ended=step.done or step.truncated)
        said, values = decision.moment.tutor_action.__dict__, decision.executed.__dict__
        self._said[i] = [said[name] for name in self._components]
        self._executed[i] = [values[name] for name in self._components]
        if turn.outcome is not None and turn.outcome.violated:
            self._violated[i] = [name in turn.outcome.violated for name in self._conditions]
        events = step.events
        self._world[i] = [events.get(name, 0.0) for name in self._events]
        numbers = self._meter.observe(turn, step)
        ratio = measure_ratio(decision)
        self._ratio[i] = np.nan if ratio is None else ratio
        self._measured[i] = [numbers.get(measure.name, np.nan) for measure in self.measured]
        self._count += 1

    def _make_head(self, turn: Turn[Any, Any], *, ended: bool) -> tuple[int, ...]:
        decision, lesson, incidents = turn.decision, turn.lesson, turn.incidents
        return (
            self._kind_of[decision.moment.tutor_action.kind],
            self._situations.number(decision.moment.situation),
            self._kind_of.get(str(getattr(decision.proposal, "kind", None)), NO_LEVEL),
            min(getattr(decision.proposal, "level", NO_LEVEL), HIGHEST_LEVEL),
            decision.selected.level,
            decision.resulting.level,
            decision.resulting.ampbit,
            self._limits.number(turn.limited_by),
            self._voids.number(turn.void),
            NO_LEVEL if lesson is None else min(lesson.target.level, HIGHEST_LEVEL),
            NO_LEVEL if lesson is None else lesson.target.ampbit,
            len(incidents),
            self._parts.number(incidents[0].part if incidents else ""),
            ended,
        )

    def summary(self) -> Mapping[str, float]:
        """Return what the other observers measured and counted."""
        return self._meter.summary()

    @property
    def count(self) -> int:
        """How many decisions it has seen."""
        return self._count

    def arrays(self, first: int = 0) -> Arrays:
        """Return the columns from a decision on, as long as there were decisions."""
        rows = slice(first, self._count)
        columns: Arrays = {name: self._heads[rows, i].copy() for i, name in enumerate(HEADS)}
        return columns | {
            "kind_names": _make_array(self._kinds),
            "situation_names": _make_array(list(self._situations)),
            "limited_by_names": _make_array(list(self._limits)),
            "void_names": _make_array(list(self._voids)),
            "incident_part_names": _make_array(list(self._parts)),
            "said": self._said[rows],
            "executed": self._executed[rows],
            "executed_ratio": self._ratio[rows],
            "component_names": _make_array(self._components),
            "violated": self._violated[rows],
            "condition_names": _make_array(self._conditions),
            "events": self._world[rows],
            "event_names": _make_array(self._events),
            "measures": self._measured[rows],
            "measure_names": _make_array([measure.name for measure in self.measured]),
        }


class _Words(dict[str, int]):
    """Words, numbered in the order in which they come."""

    def __init__(self, *first: str) -> None:
        super().__init__({word: i for i, word in enumerate(first)})

    def number(self, word: str) -> int:
        return self.setdefault(word, len(self))


def _make_array(words: list[str]) -> NDArray[np.str_]:
    return np.array(words, dtype=np.str_) if words else np.zeros(0, dtype="<U1")
