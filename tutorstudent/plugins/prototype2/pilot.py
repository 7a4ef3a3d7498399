"""What prototype 2 can do, and the short memory that keeps it from dithering."""

from __future__ import annotations

import numpy as np

from tutorstudent.plugins.prototype2.percept import Percept
from tutorstudent.plugins.prototype2.planner_options import Tuning
from tutorstudent.plugins.prototype2.view import View
from tutorstudent.sims.pioneer.types import DriveAction


class Pilot(View):
    """Conditions and actions for the rule table.

    A spin keeps its side until the robot moves on freely in the Subsumption state, whatever triggers come and go
    meanwhile; and a refused action is not repeated. Choice: see docs/fidelity.md.
    """

    def __init__(self, tuning: Tuning, rng: np.random.Generator) -> None:
        super().__init__(tuning)
        self._rng = rng
        speed, turn, held = tuning.translation, tuning.rotation, tuning.duration_s
        self._forward = DriveAction(kind="forward", translation=speed, duration_s=held)
        self._backward = DriveAction(kind="backward", translation=-speed, duration_s=held)
        self._left = DriveAction(kind="left", rotation=turn, duration_s=held)
        self._right = DriveAction(kind="right", rotation=-turn, duration_s=held)
        self.forget()

    def forget(self) -> None:
        """Forget the trial."""
        self._last = self._forward
        self._side: DriveAction | None = None
        self._spun = 0
        self._best_view_m = 0.0
        self._forward_left = 0
        self._daring = False
        self._turn_left = 0
        self._recovery_left = 0
        self._recovered = 0

    def look(self, percept: Percept) -> None:
        """Take in what is seen now."""
        self.seen = percept

    def remember(self, action: DriveAction) -> None:
        """Remember what was decided; a stall report will be about it."""
        self._last = action

    # Conditions on the memory

    def is_refused(self) -> bool:
        """The last action was refused. A report that is older than the present recovery is not believed."""
        too_early = self._recovery_left > 0 and self._recovered < self.tuning.stall_delay
        return self.seen.stalled and not too_early

    def is_recovering(self) -> bool:
        return self._recovery_left > 0

    def has_arrived(self) -> bool:
        """The way that the Forward state was to drive is driven."""
        return self._forward_left <= 0

    def has_spun_enough(self) -> bool:
        """The spin has gone all the way round, and the robot looks out about as far as it could anywhere.

        The longer it lasts the less will do, since others may have moved into the view.
        """
        limit = self.tuning.spin_limit
        if self._spun < limit or self.closer_than(self.tuning.break_out_clearance):
            return False
        return self.seen.view_m * self._spun >= self._best_view_m * limit

    def is_too_close(self) -> bool:
        """An obstacle is closer than the Forward state drives to; it drives closer when it breaks out."""
        return self.closer_than(self.tuning.break_out_clearance if self._daring else 1.0)

    def is_at_predator(self) -> bool:
        """A predator is near. A robot that breaks out passes it."""
        return self.predator_near() and not self._daring

    def is_turning(self) -> bool:
        """A turn to an open area is going on."""
        return self._turn_left > 0

    def is_restless(self) -> bool:
        """There is an open area, and chance will have it."""
        return self.side_is_open() and self._rng.random() < self.tuning.wander_turn

    # Actions: recovery

    def recover(self) -> DriveAction:
        """Begin to do something other than what was just refused, for a few decisions."""
        if self._side is None:
            self._begin_spin(self._choose_open_side())
        chance = self._recovery_left > 0 or self._rng.random() < self.tuning.recover_random
        self._recovery_left = self.tuning.recover_min - 1 + int(self._rng.integers(self.tuning.recover_more + 1))
        self._recovered = 1
        return self._choose_any_other() if chance else self._choose_opposite()

    def keep_recovering(self) -> DriveAction:
        self._recovery_left -= 1
        self._recovered += 1
        return self._last

    def _choose_any_other(self) -> DriveAction:
        others = [a for a in (self._forward, self._backward, self._left, self._right) if a is not self._last]
        return others[int(self._rng.integers(len(others)))]

    def _choose_opposite(self) -> DriveAction:
        if self._last is self._forward:
            return self._backward
        if self._last is self._backward:
            return self._choose_open_side()
        return self._backward if self.seen.back_m > self.seen.front_m else self._forward

    # Actions: spins

    def spin_to_open_side(self) -> DriveAction:
        return self._begin_spin(self._choose_open_side())

    def spin_from_near_side(self) -> DriveAction:
        return self._begin_spin(self._right if self.seen.left_m < self.seen.right_m else self._left)

    def spin_from_predator(self) -> DriveAction:
        return self._begin_spin(self._choose_away(self.seen.predator_rad))

    def spin_from_prey(self) -> DriveAction:
        return self._begin_spin(self._choose_away(self.seen.prey_rad))

    def keep_spinning(self) -> DriveAction:
        self._spun += 1
        self._best_view_m = max(self._best_view_m, self.seen.view_m)
        return self._side or self._begin_spin(self._choose_open_side())

    def _begin_spin(self, side: DriveAction) -> DriveAction:
        self._spun = 0
        self._best_view_m = 0.0
        self._turn_left = 0
        self._side = self._side or side
        return self._side

    def _choose_open_side(self) -> DriveAction:
        return self._left if self.seen.left_is_open else self._right

    def _choose_away(self, bearing_rad: float) -> DriveAction:
        return self._right if bearing_rad > 0 else self._left

    # Actions: driving

    def leave(self) -> DriveAction:
        """Drive away from an obstacle that the robot has turned from."""
        return self._begin_forward(self.tuning.avoid_forward)

    def flee(self) -> DriveAction:
        """Drive away from prey or a predator that the robot has turned from."""
        return self._begin_forward(self.tuning.flee_forward)

    def break_out(self) -> DriveAction:
        """Drive where the view is farthest, closer to things than otherwise."""
        self._begin_forward(self.tuning.break_out_forward)
        self._daring = True
        return self._forward

    def drive_on(self) -> DriveAction:
        self._forward_left -= 1
        return self._forward

    def _begin_forward(self, decisions: int) -> DriveAction:
        self._forward_left = decisions - 1
        self._daring = False
        return self._forward

    # Actions: free movement, which ends what a spin remembers

    def drive_forward(self) -> DriveAction:
        return self._move_freely(self._forward)

    def turn_left(self) -> DriveAction:
        return self._move_freely(self._left)

    def turn_right(self) -> DriveAction:
        return self._move_freely(self._right)

    def turn_to_open_area(self) -> DriveAction:
        """Begin a turn of random length towards the more open side."""
        turn = self._move_freely(self._choose_open_side())
        self._turn_left = int(self._rng.integers(self.tuning.turn_max))
        return turn

    def keep_turning(self) -> DriveAction:
        self._turn_left -= 1
        return self._last

    def _move_freely(self, action: DriveAction) -> DriveAction:
        self._side = None
        self._turn_left = 0
        return action
