"""The encoder of plain numbers: which states it reads, and what it says of the others."""

from __future__ import annotations

from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest

from tests.core.toys import Push
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.core.words.records import Moment
from tutorstudent.plugins.ranges import Ranges


@dataclass(frozen=True)
class Tank:
    level_m: float
    flow: float


class Pair(NamedTuple):
    level_m: float
    flow: float


class Measured(NamedTuple):
    observation: Any
    reward: float = 0.0


def bits(state: Any, of: str = "", count: int = 2) -> list[float]:
    """Return the bits of the state's numbers, each in the range 0 to 4, three thresholds: 1, 2 and 3."""
    encoder = Ranges(ranges=[(0, 4)] * count, steps=3, of=of)
    encoder.bind(Binding(1, "student.encoder", Push))
    found = encoder.encode(Moment(0, state, Push(kind="push", force=0.2), ""))
    assert encoder.width == len(found)
    return found[3:].tolist()


CODE = [1.0, 1.0, 0.0, 0.0, 0.0, 0.0]


@pytest.mark.parametrize(
    "state",
    [[2.5, 0.5], (2.5, 0.5), np.array([[2.5], [0.5]]), Pair(2.5, 0.5), Tank(2.5, 0.5), {"level_m": 2.5, "flow": 0.5}],
)
def test_numbers_are_those_of_a_sequence_an_array_a_mapping_or_a_dataclass_in_its_order(state):
    assert bits(state) == CODE


@pytest.mark.parametrize(
    ("state", "of"),
    [
        (Measured(np.array([2.5, 0.5])), "observation"),
        (Measured(Tank(2.5, 0.5)), "observation"),
        (SimpleNamespace(pose=SimpleNamespace(position=[2.5, 0.5])), "pose.position"),
    ],
)
def test_the_numbers_may_be_those_of_a_part_of_the_state(state, of):
    assert bits(state, of) == CODE


def test_one_number_is_a_state_too():
    assert bits(2.5, count=1) == [1.0, 1.0, 0.0]


@pytest.mark.parametrize("state", [Measured(np.zeros(2)), {"level_m": [1.0, 2.0], "flow": 0.5}, object(), ["a", "b"]])
def test_a_state_without_plain_numbers_is_a_sentence_that_names_the_option(state):
    with pytest.raises(ValueError, match=rf"a {type(state).__name__} is no plain list .* with 'of', as in"):
        bits(state)


def test_another_number_of_numbers_is_a_sentence():
    with pytest.raises(ValueError, match=r"the state has 3 numbers; 2 ranges are declared\."):
        bits([1.0, 2.0, 3.0])


@pytest.mark.parametrize("of", ["observation.", ".x", "a b", "x[0]"])
def test_a_part_that_is_no_dotted_name_is_refused(of):
    with pytest.raises(PipelineError, match="of"):
        Ranges(ranges=[(0, 1)], of=of)


@pytest.mark.parametrize("of", ["", "observation", "pose.position"])
def test_its_examples_are_states_that_it_reads(of):
    encoder = Ranges(ranges=[(0, 4)], steps=3, of=of)
    encoder.bind(Binding(1, "student.encoder", Push))
    coded = [encoder.encode(Moment(0, state, Push(kind="push", force=0.2), ""))[3:] for state in encoder.examples()]
    assert [0.0, 1.0, 3.0] == [float(code.sum()) for code in coded]
