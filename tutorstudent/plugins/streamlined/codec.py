"""The codec of the streamlined algorithm: level and ampbit, no kind (Thesis 5.2.1)."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tutorstudent.core.roles.leaves import Codec, Vector
from tutorstudent.core.words.proposals import LevelProposal
from tutorstudent.core.words.records import GradedAction
from tutorstudent.plugins.level_codes import GradeCode, GradeOptions, require_finite


class LevelAmpbit(Codec[LevelProposal]):
    """The level, then the ampbit: 3 + 1 outputs. What a lesson says of the kind is not learned."""

    name = "level-ampbit"
    proposal: ClassVar[type[Any]] = LevelProposal
    Options = GradeOptions

    def setup(self) -> None:
        self._grade = GradeCode(self.options)
        self._proposals: dict[tuple[int, bool], LevelProposal] = {}

    @property
    def width(self) -> int:
        return self._grade.width

    def encode(self, target: GradedAction[Any]) -> Vector:
        return np.array(self._grade.encode(target))

    def decode(self, outputs: Vector) -> LevelProposal:
        grade = self._grade.decode(require_finite(outputs, self.width))
        if grade not in self._proposals:
            level, ampbit = grade
            self._proposals[grade] = LevelProposal(level=level, ampbit=ampbit)
        return self._proposals[grade]
