"""The base of students that consist of an encoder, something that learns, and a codec."""

from __future__ import annotations

import abc
import math
from typing import TYPE_CHECKING, Any, Generic, cast

import numpy as np

from tutorstudent.core.roles import part
from tutorstudent.core.roles.interfaces import Student
from tutorstudent.core.roles.leaves import Codec, Encoder, Vector
from tutorstudent.core.roles.part import Field, Learned
from tutorstudent.core.roles.part_options import Part
from tutorstudent.core.words.actions import ActionT
from tutorstudent.core.words.errors import ContractError, PipelineError, list_names
from tutorstudent.core.words.proposals import KindProposal, LevelProposal, Proposal, ProposalT
from tutorstudent.core.words.records import Lesson, Moment, StateT
from tutorstudent.plugins.codecs import KindLevelAmpbit


class CodedStudent(Student[StateT, ActionT, ProposalT], Generic[StateT, ActionT, ProposalT]):
    """Encode the moment, answer, decode; and learn what the codec makes of a lesson (Thesis 3.3.2, 3.3.5).

    The numbers of the last moment are kept, copied, under its decision number, so that the lesson about it is not
    encoded again. A subclass says how it answers and learns in terms of numbers, and what it learned as arrays.
    """

    class Options(part.Options):
        """The parts of every coded student."""

        encoder: Part[Encoder[Any, Any]] = Field(description="what the student sees")
        codec: Part[Codec[Any]] = Field(default_factory=KindLevelAmpbit, description="what its outputs mean")

    encoder: Encoder[StateT, ActionT]
    """What it sees; known after binding."""
    codec: Codec[ProposalT]
    """What its outputs mean; known after binding."""

    if TYPE_CHECKING:  # The codec has a default in YAML; in Python it tells a type checker what is proposed.

        def __init__(self, *, encoder: Encoder[StateT, ActionT], codec: Codec[ProposalT], **options: Any) -> None: ...

    @property
    def proposal(self) -> type[Any]:
        return cast(Codec[ProposalT], self.options.codec).proposal

    @abc.abstractmethod
    def answer(self, inputs: Vector) -> ProposalT:
        """Return the proposal for the inputs, shape (encoder.width,), which the next decision overwrites."""

    @abc.abstractmethod
    def learn(self, inputs: Vector, targets: Vector) -> None:
        """Learn the targets, shape (codec.width,), for the inputs, shape (encoder.width,)."""

    @abc.abstractmethod
    def export(self) -> Learned:
        """Return what was learned, without the parts: new arrays and plain values, by name."""

    @abc.abstractmethod
    def restore(self, learned: Learned) -> None:
        """Take back what `export` returned.

        Raises:
            ContractError: It does not fit; nothing was changed.
        """

    def setup(self) -> None:
        self.encoder, self.codec = self.options.encoder, self.options.codec
        self._inputs = np.empty(self.encoder.width)
        self._number: int | None = None

    def reset(self) -> None:
        super().reset()
        self._number = None

    def propose(self, moment: Moment[StateT, ActionT]) -> ProposalT:
        self._encode(moment)
        self._number = moment.number
        return self.answer(self._inputs)

    def teach(self, lesson: Lesson[StateT, ActionT]) -> None:
        if lesson.moment.number != self._number:
            self._encode(lesson.moment)
        self.learn(self._inputs, _check(self.codec, self.codec.encode(lesson.target), self.codec.width))

    def state_dict(self) -> Learned:
        return {**super().state_dict(), **self.export()}

    def load_state_dict(self, state: Learned) -> None:
        parts = dict(self.parts())
        self.restore({name: value for name, value in state.items() if name not in parts})
        super().load_state_dict({name: value for name, value in state.items() if name in parts})

    def _encode(self, moment: Moment[StateT, ActionT]) -> None:
        self._number = None  # only what was proposed for is known again
        np.copyto(self._inputs, _check(self.encoder, self.encoder.encode(moment), self.encoder.width))


def _check(part: Encoder[Any, Any] | Codec[Any], numbers: Vector, width: int) -> Vector:
    # One NaN that reaches a network's weights stays there, and one number is broadcast to all.
    if numbers.shape != (width,):
        raise ContractError(f"{part.role} '{part.name}' returned the shape {numbers.shape}; its width says ({width},).")
    if not math.isfinite(sum(numbers.tolist())):
        raise ContractError(f"{part.role} '{part.name}' returned numbers that are not finite: {numbers}.")
    return numbers


_UNTAUGHT: dict[type[Any], Proposal] = {
    KindProposal: KindProposal(kind=None, level=0, ampbit=True),
    LevelProposal: LevelProposal(level=0, ampbit=True),
}


def propose_untaught(codec: Codec[ProposalT]) -> ProposalT:
    """Return what a student proposes before it was taught anything: no kind, level 0, ampbit 1.

    It leaves the tutor's action to the amplifier, as a student with another kind would (Thesis 3.3.3). Choice, see
    docs/fidelity.md.

    Raises:
        PipelineError: The codec's proposals are of a type that is not known here.
    """
    if codec.proposal not in _UNTAUGHT:
        known = list_names(proposal.__name__ for proposal in _UNTAUGHT)
        raise PipelineError(f"codec '{codec.name}' proposes {codec.proposal.__name__}; this student can say {known}.")
    return cast(ProposalT, _UNTAUGHT[codec.proposal])
