"""What a run leaves behind: arrays of every decision, and files that can be read later. No pickle, no objects."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tutorstudent.core.deciding.limiting import HIGHEST_LEVEL
from tutorstudent.core.roles.world import Step
from tutorstudent.core.running.arrays import Arrays
from tutorstudent.core.running.observers import Begin, Observer
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.core.words.records import Turn

NO_LEVEL = -1


class Recorder(Observer):
    """Keeps every decision as numbers: kinds, situations, levels, bits, components, violations, lessons, events.

    `arrays` returns one entry for each column, shape (decisions,) or (decisions, n); names that index into a column
    stand beside it (``kind_names`` for ``kind``). A level that was not taught is -1. Components that are no
    floats are left out.
    """

    name = "recorder"

    def begin(self, begin: Begin) -> None:
        specs = begin.engine.tutor.action.vocabulary.components
        self._components = [name for name, spec in specs.items() if spec.number]
        self._conditions = [condition.label for condition in begin.engine.conditions]
        self._events = list(begin.world.event_names)
        self._kinds = list(begin.engine.tutor.action.vocabulary.kinds)
        self._kind_of = {kind: i for i, kind in enumerate(self._kinds)}
        self._situation_of: dict[str, int] = {}
        self._count = 0
        try:
            self._allocate(begin.decisions)
        except MemoryError:
            raise PipelineError(
                f"there is no memory to record {begin.decisions:,} decisions; ask for fewer, as in decisions: 10000."
            ) from None

    def _allocate(self, decisions: int) -> None:
        self._heads = np.zeros((decisions, 10), dtype=np.int32)
        self._executed = np.zeros((decisions, len(self._components)))
        self._violated = np.zeros((decisions, len(self._conditions)), dtype=bool)
        self._world = np.zeros((decisions, len(self._events)))

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> None:
        i, decision, lesson = self._count, turn.decision, turn.lesson
        situation = self._situation_of.setdefault(decision.moment.situation, len(self._situation_of))
        proposed = self._kind_of.get(str(getattr(decision.proposal, "kind", None)), NO_LEVEL)
        self._heads[i] = (
            self._kind_of[decision.moment.tutor_action.kind],
            situation,
            proposed,
            decision.selected.level,
            decision.resulting.level,
            decision.resulting.ampbit,
            NO_LEVEL if lesson is None else min(lesson.target.level, HIGHEST_LEVEL),
            NO_LEVEL if lesson is None else lesson.target.ampbit,
            len(turn.incidents),
            step.done or step.truncated,
        )
        values = decision.executed.__dict__
        self._executed[i] = [values[name] for name in self._components]
        if turn.outcome is not None and turn.outcome.violated:
            self._violated[i] = [name in turn.outcome.violated for name in self._conditions]
        events = step.events
        self._world[i] = [events.get(name, 0.0) for name in self._events]
        self._count += 1

    def arrays(self) -> Arrays:
        """Return the columns, as long as there were decisions."""
        n = self._count
        names = (
            "kind",
            "situation",
            "proposed_kind",
            "selected_level",
            "resulting_level",
            "ampbit",
            "taught_level",
            "taught_ampbit",
            "incidents",
            "trial_ended",
        )
        columns: Arrays = {name: self._heads[:n, i].copy() for i, name in enumerate(names)}
        return columns | {
            "kind_names": _make_words(self._kinds),
            "situation_names": _make_words(list(self._situation_of)),
            "executed": self._executed[:n],
            "component_names": _make_words(self._components),
            "violated": self._violated[:n],
            "condition_names": _make_words(self._conditions),
            "events": self._world[:n],
            "event_names": _make_words(self._events),
        }


def _make_words(words: list[str]) -> NDArray[np.str_]:
    return np.array(words, dtype=np.str_) if words else np.zeros(0, dtype="<U1")
