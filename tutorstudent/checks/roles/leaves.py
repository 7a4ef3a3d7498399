"""How encoders, codecs, changes and conditions are used."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product
from typing import Any

import numpy as np

from tutorstudent.checks.outcome import expect
from tutorstudent.checks.roles.engine import BITS, LEVELS, make_moments
from tutorstudent.checks.roles.sound import expect_number, expect_numbers, expect_proposal, expect_vector
from tutorstudent.checks.usage import Question, Usage
from tutorstudent.core.words.records import GradedAction


class EncoderUsage(Usage):
    """Given one moment for each state."""

    reads_states = True

    def make_questions(self, states: Sequence[Any]) -> list[Question]:
        return [(moment,) for moment in make_moments(self.subject.actions, states)]

    def ask(self, part: Any, question: Question) -> Any:
        vector = part.encode(*question)
        return vector.copy() if isinstance(vector, np.ndarray) else vector  # it may reuse its buffer

    def judge(self, part: Any, question: Question, answer: Any) -> None:
        expect_vector(answer, part.width, "encode()")


class CodecUsage(Usage):
    """Given every action at several levels to encode; asked what the numbers say."""

    def make_questions(self, states: Sequence[Any]) -> list[Question]:
        cases = product(self.subject.actions, LEVELS, BITS)
        return [(GradedAction(action, level, bit),) for action, level, bit in cases]

    def ask(self, part: Any, question: Question) -> Any:
        numbers = part.encode(*question)
        return (numbers.copy() if isinstance(numbers, np.ndarray) else numbers), part.decode(numbers)

    def judge(self, part: Any, question: Question, answer: Any) -> None:
        numbers, proposal = answer
        expect_vector(numbers, part.width, "encode()")
        expect(
            bool(((numbers >= 0) & (numbers <= 1)).all()),
            "encode() returns numbers in [0, 1], which a logistic neuron can learn",
            f"{numbers}",
            "scale them into [0, 1]",
        )
        expect_proposal(proposal, part.proposal, self.subject.action, "decode()")


class ChangeUsage(Usage):
    """Asked for the distance of several amplifications of several magnitudes."""

    def make_questions(self, states: Sequence[Any]) -> list[Question]:
        return list(product((0.0, 0.1, 0.3, 0.8, 5.0), (0.0, 0.12, 0.5, 1.0)))

    def ask(self, part: Any, question: Question) -> Any:
        return part.fraction(*question)

    def judge(self, part: Any, question: Question, answer: Any) -> None:
        distance = expect_number(answer, "fraction()")
        expect(
            0 <= distance < math.inf,
            "fraction() is 0 or more",
            f"fraction{question} = {distance}",
            "say how far to move; the direction comes from the action class",
        )


class ConditionUsage(Usage):
    """Asked whether each state is a violation, and how far from one it is."""

    reads_states = True

    def make_questions(self, states: Sequence[Any]) -> list[Question]:
        return [(state,) for state in states]

    def ask(self, part: Any, question: Question) -> Any:
        violated, margins = part.violated(*question), part.margins(*question)
        return violated, margins if margins is None or isinstance(margins, str) else list(margins)

    def judge(self, part: Any, question: Question, answer: Any) -> None:
        violated, margins = answer
        expect(
            isinstance(violated, bool | np.bool_),
            "violated() returns True or False",
            f"{violated!r}",
            "return bool(...)",
        )
        if margins is not None:
            expect_numbers(margins, "margins()")
        label = part.label
        expect(bool(label) and isinstance(label, str), "label is a word", f"{label!r}", "return a string")
