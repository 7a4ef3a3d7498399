"""A student that remembers: the last lesson for every encoding that it has seen."""

from __future__ import annotations

from typing import Generic

import numpy as np

from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.leaves import Vector
from tutorstudent.core.roles.part import Component, Learned
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.proposals import ProposalT
from tutorstudent.core.words.records import StateT
from tutorstudent.plugins.coded_student import CodedStudent, propose_untaught
from tutorstudent.plugins.learned import take_arrays


class TableStudent(CodedStudent[StateT, ActionT, ProposalT], Generic[StateT, ActionT, ProposalT]):
    """Answer with the last lesson for exactly these inputs, or as one that was taught nothing (see `propose_untaught`).

    It never generalizes and never forgets: one row for each encoding that a lesson was about, so give it an encoder
    with few of them. "Any type of function approximator" will do (Thesis 3.2.2.2); this one is the plainest.
    """

    name = "table"

    def setup(self) -> None:
        super().setup()
        self._untaught = propose_untaught(self.codec)
        self._outputs: dict[bytes, Vector] = {}

    def answer(self, inputs: Vector) -> ProposalT:
        outputs = self._outputs.get(_make_key(inputs))
        return self._untaught if outputs is None else self.codec.decode(outputs)

    def learn(self, inputs: Vector, targets: Vector) -> None:
        self._outputs[_make_key(inputs)] = targets.copy()

    def export(self) -> Learned:
        rows = len(self._outputs)
        inputs = np.frombuffer(b"".join(self._outputs), dtype=np.float64).reshape(rows, self.encoder.width)
        outputs = np.array(list(self._outputs.values())).reshape(rows, self.codec.width)
        return {"inputs": inputs.copy(), "outputs": outputs}

    def restore(self, learned: Learned) -> None:
        owner = f"student '{self.name}'"
        taken = take_arrays(owner, learned, {"inputs": (None, self.encoder.width), "outputs": (None, self.codec.width)})
        inputs, outputs = taken["inputs"], taken["outputs"]
        if len(inputs) != len(outputs):
            raise ContractError(f"{owner} cannot load {len(inputs)} inputs with {len(outputs)} outputs.")
        self._outputs = {_make_key(row): answer for row, answer in zip(inputs, outputs, strict=True)}


def _make_key(inputs: Vector) -> bytes:
    return (inputs + 0.0).tobytes()  # so that -0.0 and 0.0 are one


@hookimpl
def tutorstudent_components() -> list[type[Component]]:
    """Return the table."""
    return [TableStudent]
