"""What the leaves share: what is seen, the numbers, and the command that one of them gives."""

from __future__ import annotations

import numpy as np

from tutorstudent.sims.pioneer.types import DriveAction
from tutorstudent_controllers.tree.options import TreeOptions
from tutorstudent_controllers.tree.percept import Percept


class Cockpit:
    """The robot as the leaves see and drive it; a leaf that runs gives one command per tick.

    Args:
        options: Speeds and distances.
        rng: For wandering and for choosing sides.
    """

    seen: Percept

    def __init__(self, options: TreeOptions, rng: np.random.Generator) -> None:
        self.options = options
        self.rng = rng
        self.command = DriveAction(kind="stop")

    def forward(self) -> None:
        """Drive ahead."""
        self.command = DriveAction(kind="forward", translation=self.options.translation)

    def backward(self) -> None:
        """Drive back."""
        self.command = DriveAction(kind="backward", translation=-self.options.translation)

    def turn(self, left: bool) -> None:
        """Turn on the spot."""
        rotation = self.options.rotation if left else -self.options.rotation
        self.command = DriveAction(kind="left" if left else "right", rotation=rotation)
