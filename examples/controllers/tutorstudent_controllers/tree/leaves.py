"""The leaves: questions that succeed or fail at once, and behaviours that run for some ticks and drive."""

from __future__ import annotations

import math
from collections.abc import Callable

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tutorstudent_controllers.tree.cockpit import Cockpit
from tutorstudent_controllers.tree.percept import Percept

Question = Callable[[Percept], bool]


class Asks(Behaviour):
    """Succeeds where something holds in what is seen."""

    def __init__(self, name: str, cockpit: Cockpit, question: Question) -> None:
        super().__init__(name)
        self._cockpit, self._question = cockpit, question

    def update(self) -> Status:
        return Status.SUCCESS if self._question(self._cockpit.seen) else Status.FAILURE


class Drives(Behaviour):
    """Drives for a number of ticks, or until a question is answered with yes."""

    def __init__(self, name: str, cockpit: Cockpit, ticks: int, until: Question) -> None:
        super().__init__(name)
        self.cockpit, self._ticks, self._until = cockpit, ticks, until

    def initialise(self) -> None:
        self._left = self._ticks

    def update(self) -> Status:
        if self._left == 0 or self._until(self.cockpit.seen):
            return Status.SUCCESS
        self._left -= 1
        self.drive()
        return Status.RUNNING

    def drive(self) -> None:
        """Give the command."""
        self.cockpit.forward()


class BacksOff(Drives):
    """Drives the other way than the command that was refused; ahead where the way back is not free."""

    def initialise(self) -> None:
        super().initialise()
        refused = self.cockpit.command.kind
        self._ahead = refused == "backward" or self.cockpit.seen.behind_m < self.cockpit.options.obstacle_m

    def drive(self) -> None:
        if self._ahead:
            self.cockpit.forward()
        else:
            self.cockpit.backward()


class Turns(Drives):
    """Turns on the spot, to the side with more room when it began.

    A turn that follows another turn goes on to the same side, whatever it is from: two reasons to turn would else send
    the robot to and fro.
    """

    def initialise(self) -> None:
        super().initialise()
        before = self.cockpit.command.kind
        self._to_left = before == "left" if before in ("left", "right") else self.leftwards(self.cockpit.seen)

    def drive(self) -> None:
        self.cockpit.turn(self._to_left)

    def leftwards(self, seen: Percept) -> bool:
        """Return whether to turn left."""
        return seen.left_m > seen.right_m


class TurnsFromRed(Turns):
    """Turns away from the nearest red thing."""

    def leftwards(self, seen: Percept) -> bool:
        return seen.red_rad < 0


class TurnsFromBlue(Turns):
    """Turns away from the nearest blue thing."""

    def leftwards(self, seen: Percept) -> bool:
        return seen.blue_rad < 0


class Faces(Drives):
    """Turns towards the nearest red thing, wherever it is by now."""

    def drive(self) -> None:
        self.cockpit.turn(self.cockpit.seen.red_rad > 0)


class Wanders(Behaviour):
    """Drives ahead for a while, then turns for a while, and so on; it never ends by itself."""

    def __init__(self, name: str, cockpit: Cockpit) -> None:
        super().__init__(name)
        self._cockpit = cockpit
        self._turning = 0
        self._to_left = False

    def update(self) -> Status:
        cockpit = self._cockpit
        if self._turning == 0 and cockpit.rng.random() < 1 / cockpit.options.stroll:
            self._turning = int(cockpit.rng.integers(1, 16))
            self._to_left = cockpit.seen.left_m > cockpit.seen.right_m
        if self._turning:
            self._turning -= 1
            cockpit.turn(self._to_left)
        else:
            cockpit.forward()
        return Status.RUNNING


def sees_red(seen: Percept) -> bool:
    """Return whether anything red is in view."""
    return seen.red_m < math.inf


def sees_no_blue(seen: Percept) -> bool:
    """Return whether nothing blue is in view."""
    return seen.blue_m == math.inf
