"""The conditions of prototype 2's rules that are about what it sees now (Thesis 3.3.1)."""

from __future__ import annotations

from tutorstudent.plugins.prototype2.percept import Percept
from tutorstudent.plugins.prototype2.planner_options import Tuning


class View:
    """A percept seen through the tutor's thresholds."""

    seen: Percept

    def __init__(self, tuning: Tuning) -> None:
        self.tuning = tuning

    def always(self) -> bool:
        return True

    def obstacle_ahead(self) -> bool:
        return self.seen.front_m < self.tuning.front_m

    def obstacle_beside(self) -> bool:
        return self.seen.left_m < self.tuning.side_m or self.seen.right_m < self.tuning.side_m

    def closer_than(self, part: float) -> bool:
        """Something ahead or beside is closer than this part of what makes it an obstacle."""
        seen, side_m = self.seen, part * self.tuning.side_m
        return seen.front_m < part * self.tuning.front_m or seen.left_m < side_m or seen.right_m < side_m

    def little_space_ahead(self) -> bool:
        return self.seen.front_m < self.tuning.clear_m

    def predator_near(self) -> bool:
        return self.seen.predator_m < self.tuning.predator_m

    def predator_lost(self) -> bool:
        """No predator is seen, and there is a way ahead."""
        return not self.seen.predator_seen and not self.obstacle_ahead()

    def prey_near(self) -> bool:
        return self.seen.prey_m < self.tuning.prey_m

    def prey_lost(self) -> bool:
        """No prey is seen, and there is a way ahead."""
        return not self.seen.prey_seen and not self.obstacle_ahead()

    def prey_left(self) -> bool:
        return self.seen.prey_rad > self.tuning.seek_tolerance_rad

    def prey_right(self) -> bool:
        return self.seen.prey_rad < -self.tuning.seek_tolerance_rad

    def prey_ahead(self) -> bool:
        """Any prey in view; the rule stands after those for left and right."""
        return self.seen.prey_seen

    def way_is_clear(self) -> bool:
        """Nothing that a spin from an obstacle turns away from is left."""
        return not (self.little_space_ahead() or self.obstacle_beside() or self.predator_near())

    def side_is_open(self) -> bool:
        """One side is an open area: its mean range is large."""
        return max(self.seen.left_space_m, self.seen.right_space_m) > 4 * self.tuning.open_m
