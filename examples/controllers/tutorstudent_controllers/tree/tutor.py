"""A behaviour tree of the package py-trees as a tutor."""

from __future__ import annotations

import tutorstudent as ts
from tutorstudent.sims.pioneer.types import DriveAction, PioneerState
from tutorstudent_controllers.missing import explain_missing
from tutorstudent_controllers.tree.cockpit import Cockpit
from tutorstudent_controllers.tree.options import TreeOptions
from tutorstudent_controllers.tree.percept import perceive

TICKS = 3
"""A branch that has just come to its end gives no command, so that the tree is ticked again, this often at most."""


class Tree(ts.Tutor[PioneerState, DriveAction]):
    """Ticks a tree for each decision: the leaf that runs says the command, and its name is the situation."""

    name = "py-tree"
    action = DriveAction
    Options = TreeOptions
    options: TreeOptions

    def setup(self) -> None:
        self.reset()

    def reset(self) -> None:
        super().reset()
        with explain_missing("tutor 'py-tree'", "py-trees"):
            from tutorstudent_controllers.tree.planting import plant
        self._cockpit = Cockpit(self.options, self.rng)
        self._root = plant(self._cockpit)

    def act(self, state: PioneerState) -> DriveAction:
        self._cockpit.seen = perceive(state)
        for _ in range(TICKS):
            self._root.tick_once()
            if self._root.status.value == "RUNNING":
                break
        return self._cockpit.command

    @property
    def situation(self) -> str:
        tip = self._root.tip()
        return tip.name if tip else ""
