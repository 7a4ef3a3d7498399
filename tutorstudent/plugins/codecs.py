"""The codec of the full algorithm: action kind, level and ampbit (Thesis 3.3.2)."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.leaves import Codec, Vector
from tutorstudent.core.roles.part import Component
from tutorstudent.core.words.errors import ContractError, list_names, suggest
from tutorstudent.core.words.proposals import KindProposal
from tutorstudent.core.words.records import GradedAction
from tutorstudent.plugins.level_codes import GradeCode, GradeOptions, from_bits, require_finite, to_bits


class KindLevelAmpbit(Codec[KindProposal]):
    """Binary digits of the kind, then the level, then the ampbit: 3 + 3 + 1 outputs for the Pioneer (Table 1).

    A kind's number is its place in the action class's vocabulary; a number without a kind is read as no kind
    (Choice, see docs/fidelity.md).
    """

    name = "kind-level-ampbit"
    proposal: ClassVar[type[Any]] = KindProposal
    Options = GradeOptions

    def setup(self) -> None:
        self._kinds = self.action_class.vocabulary.kinds
        self._kind_width = (len(self._kinds) - 1).bit_length()
        self._bits = {kind: to_bits(number, self._kind_width) for number, kind in enumerate(self._kinds)}
        self._grade = GradeCode(self.options)

    @property
    def width(self) -> int:
        return self._kind_width + self._grade.width

    def encode(self, target: GradedAction[Any]) -> Vector:
        kind = target.action.kind
        if kind not in self._bits:
            raise ContractError(
                f"codec '{self.name}': no code for the kind '{kind}'{suggest(kind, self._kinds)}; "
                f"the tutor's {self.action_class.__name__} has {list_names(self._kinds)}."
            )
        return np.array(self._bits[kind] + self._grade.encode(target))

    def decode(self, outputs: Vector) -> KindProposal:
        values = require_finite(outputs, self.width)
        number = from_bits(values[: self._kind_width])
        level, ampbit = self._grade.decode(values[self._kind_width :])
        kind = self._kinds[number] if number < len(self._kinds) else None
        return KindProposal(kind=kind, level=level, ampbit=ampbit)


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the codec of the full algorithm."""
    return [KindLevelAmpbit]
