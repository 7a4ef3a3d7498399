"""The thesis's student: an incremental backpropagation network (Thesis 3.3.2, Table 1, Appendix C)."""

from __future__ import annotations

from typing import Generic

import numpy as np

from tutorstudent.core.roles.leaves import Vector
from tutorstudent.core.roles.part import Field, Learned
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.proposals import ProposalT
from tutorstudent.core.words.records import StateT
from tutorstudent.plugins.backprop.network import Network
from tutorstudent.plugins.coded_student import CodedStudent
from tutorstudent.plugins.learned import take_arrays


class BackpropStudent(CodedStudent[StateT, ActionT, ProposalT], Generic[StateT, ActionT, ProposalT]):
    """One hidden layer of logistic neurons, taught each lesson several times at once. The defaults are Table 1's.

    What it learned are the weights and, for the momentum, their last changes.
    """

    name = "backprop"

    class Options(CodedStudent.Options):
        """Table 1; the initial weights are a choice, see docs/fidelity.md."""

        hidden: int = Field(30, ge=1, le=10_000, description="hidden neurons")
        learning_rate: float = Field(0.3, gt=0, le=10, description="step along the error")
        momentum: float = Field(0.9, ge=0, lt=1, description="part of the last change that is made again")
        teaching_rate: int = Field(3, ge=1, le=1000, description="iterations for each lesson")
        initial_weight: float = Field(0.1, gt=0, le=10, description="largest size of a weight at the start")

    def setup(self) -> None:
        super().setup()
        options = self.options
        self._network = Network(
            self.encoder.width,
            options.hidden,
            self.codec.width,
            learning_rate=options.learning_rate,
            momentum=options.momentum,
        )
        self._network.randomize(self.rng, options.initial_weight)
        self._teaching_rate: int = options.teaching_rate

    def answer(self, inputs: Vector) -> ProposalT:
        return self.codec.decode(self._network.forward(inputs))

    def learn(self, inputs: Vector, targets: Vector) -> None:
        self._network.teach(inputs, targets, self._teaching_rate)

    def export(self) -> Learned:
        return {name: array.copy() for name, array in self._network.arrays().items()}

    def restore(self, learned: Learned) -> None:
        arrays = self._network.arrays()
        taken = take_arrays(f"student '{self.name}'", learned, {name: array.shape for name, array in arrays.items()})
        for name, array in arrays.items():
            np.copyto(array, taken[name])
