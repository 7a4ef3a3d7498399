"""Where a pipeline acts: a simulator, a plant, a robot."""

from __future__ import annotations

import abc
from collections.abc import Mapping, Sequence
from typing import ClassVar, Generic, NamedTuple

from tutorstudent.core.roles.part import Component
from tutorstudent.core.words.actions import Action, ActionT
from tutorstudent.core.words.measures import Measure, Summary, as_measure
from tutorstudent.core.words.records import StateT

Point = tuple[float, float]


class Step(NamedTuple, Generic[StateT]):
    """What one action led to."""

    state: StateT
    events: Mapping[str, float] = {}
    """What really happened, which the state need not show, by the names in `World.event_names`."""
    done: bool = False
    """The trial has ended; the pending decision is still judged by this state."""
    truncated: bool = False
    """The trial was cut off; the pending decision teaches nothing."""


class Sketch(NamedTuple):
    """A drawing of a world in metres: what maps, trajectories and films are made from."""

    polygons: Sequence[tuple[Sequence[Point], str]] = ()
    """Outlines with a colour name."""
    discs: Sequence[tuple[Point, float, str]] = ()
    """Centre, radius, colour name."""
    poses: Sequence[tuple[float, float, float, str]] = ()
    """x, y, heading (rad, counter-clockwise from +x), colour name."""


class World(Component, Generic[StateT, ActionT]):
    """A simulator, a plant or a robot: it executes actions and returns states.

    Each state must be a new object with read-only arrays, so that nobody can change it afterwards.
    """

    role: ClassVar[str] = "world"
    action: type[Action]
    """The class of actions that it executes."""
    goal_event: ClassVar[str] = ""
    """The event that a run should maximise; comparisons use it where no observer counts anything."""

    @property
    def event_names(self) -> Mapping[str, Summary | Measure]:
        """The events in `Step.events`, each as a measure or, in short, with how a run sums it up."""
        return {}

    @property
    def measures(self) -> Sequence[Measure]:
        """The events as measures."""
        return [as_measure(name, how) for name, how in self.event_names.items()]

    @abc.abstractmethod
    def reset(self, seed: int) -> StateT:
        """Begin a trial and return its first state. The same seed begins the same trial."""

    @abc.abstractmethod
    def step(self, action: ActionT) -> Step[StateT]:
        """Execute the action and return what it led to."""

    def sketch(self) -> Sketch:
        """Return a drawing of the world as it is now."""
        return Sketch()
