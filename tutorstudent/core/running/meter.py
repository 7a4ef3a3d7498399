"""Shows decisions to observers and sums up what they and the world measure."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import chain, count
from typing import Any

from tutorstudent.core.roles.world import Step
from tutorstudent.core.running.observers import TALLIED, Begin, Observer, Tally
from tutorstudent.core.words.errors import ContractError, list_names, suggest
from tutorstudent.core.words.measures import Measure
from tutorstudent.core.words.proposals import require_number
from tutorstudent.core.words.turn import Turn


class Totals:
    """Sums up the numbers of decisions, each measure in its own way.

    A decision without a number adds nothing. Without any number a sum is 0, and everything else is unknown.

    >>> totals = Totals([Measure("falls"), Measure("speed", summed="mean")])
    >>> totals.add({"falls": 1.0, "speed": 2.0}), totals.add({"speed": 4.0})
    (None, None)
    >>> totals.summary()
    {'falls': 1.0, 'speed': 3.0}
    """

    def __init__(self, measures: Iterable[Measure]) -> None:
        self._how = {measure.name: measure.summed for measure in measures}
        self._values = {name: 0.0 for name, how in self._how.items() if how == "sum"}
        self._counts: Counter[str] = Counter()

    def add(self, values: Mapping[str, float]) -> None:
        """Add the numbers of one decision, by the names of the measures."""
        for name, value in values.items():
            how = self._how[name]
            self._counts[name] += 1
            if how == "last":
                self._values[name] = value
            elif how == "max":
                self._values[name] = max(self._values.get(name, value), value)
            else:
                self._values[name] = self._values.get(name, 0.0) + value

    def summary(self) -> dict[str, float]:
        """Return what all decisions together come to."""
        return {
            name: value / self._counts[name] if self._how[name] == "mean" else value
            for name, value in self._values.items()
        }


class WorldEvents(Observer):
    """Sums up the world's events, each as the world says; what is missing in a decision is 0."""

    name = "world-events"

    def begin(self, begin: Begin) -> None:
        self._nothing = dict.fromkeys(begin.world.event_names, 0.0)
        self._totals = Totals(begin.world.measures)

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> None:
        events = step.events
        self._totals.add({name: events.get(name, nothing) for name, nothing in self._nothing.items()})

    def summary(self) -> Mapping[str, float]:
        return self._totals.summary()


class Meter:
    """Begins observers, shows them every decision, and sums up what they measure.

    Where a name is taken, by the world, by every run's own numbers or by an earlier observer, the later one gets a
    number: ``dockings#2``.
    """

    def __init__(self, observers: Sequence[Observer]) -> None:
        self.observers = tuple(observers)
        self.measures: list[Measure] = []
        """What the observers measure, by the names that stand in the summary; known once they have begun."""

    def begin(self, begin: Begin) -> None:
        """Begin all observers."""
        taken = {*Tally().summary(), *(measure.name for measure in TALLIED), *begin.world.event_names}
        self.measures, self._names = [], []
        for observer in self.observers:
            observer.begin(begin)
            names: dict[str, str] = {}
            for measure in observer.measures:
                name = names[measure.name] = find_free_key(measure.name, taken)
                taken.add(name)
                self.measures.append(replace(measure, name=name, title=measure.title + name[len(measure.name) :]))
            self._names.append(names)
        self._totals = Totals(self.measures)

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> dict[str, float]:
        """Show a decision to all observers and return what they measured of it.

        Raises:
            ContractError: if an observer returns what it does not declare, or what is no number.
        """
        found: dict[str, float] = {}
        for observer, names in zip(self.observers, self._names, strict=True):
            values = observer.observe(turn, step)
            if values:
                found |= _check(observer, values, names)
        self._totals.add(found)
        return found

    def summary(self) -> dict[str, float]:
        """Return the sums, and what the observers counted by themselves; NaN for what is no number.

        What an observer says of a measure of its own stands for the sum.
        """
        found = self._totals.summary()
        for observer, names in zip(self.observers, self._names, strict=True):
            mine = {key: _make_number(value) for key, value in observer.summary().items()}
            found |= {names.get(key) or find_free_key(key, found): value for key, value in mine.items()}
        return found


def find_free_key(key: str, taken: Container[str]) -> str:
    """Return the key, with a number where it is taken.

    >>> find_free_key("hits", []), find_free_key("hits", ["hits", "hits#2"])
    ('hits', 'hits#3')
    """
    numbered = (f"{key}#{number}" for number in count(2))
    return next(name for name in chain([key], numbered) if name not in taken)


def _check(observer: Observer, values: Any, names: Mapping[str, str]) -> dict[str, float]:
    if not isinstance(values, Mapping):
        raise ContractError(
            f"observer '{observer.name}': observe() returned {values!r}; return {{name: number}} for its measures, "
            "or None."
        )
    for name, value in values.items():
        if name not in names:
            raise ContractError(
                f"observer '{observer.name}': observe() returned '{name}', which is none of its measures"
                f"{suggest(name, names)}. Measures: {list_names(names)}. Declare it: measures = [ts.Measure('{name}')]."
            )
        if math.isnan(_make_number(value)):
            raise ContractError(
                f"observer '{observer.name}': observe() returned {value!r} for '{name}'; return a number, or leave the "
                "name out where there is none."
            )
    return {names[name]: require_number(value) for name, value in values.items()}


def _make_number(value: Any) -> float:
    try:
        return require_number(value)
    except (TypeError, ValueError, OverflowError):
        return math.nan
