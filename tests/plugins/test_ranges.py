"""The encoder of plain numbers: which states it reads, and what it says of the others."""

from __future__ import annotations

import re
from collections import defaultdict
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pytest

import tutorstudent as ts
from tests.core.toys import Push
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.words.errors import ContractError, PipelineError, UnreadableState
from tutorstudent.core.words.records import Moment
from tutorstudent.core.words.snapshots import take_snapshot
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
def test_a_state_without_plain_numbers_is_a_sentence_that_names_encoder_option_and_remedy(state):
    with pytest.raises(
        UnreadableState,
        match=rf"encoder 'ranges': a {type(state).__name__} is no plain list of numbers\. Name its numbers, "
        r"as in ranges: \{pose.x: \[0, 5\], speed: \[0, 1\]\}, or the part .* with 'of', as in of: observation\.",
    ):
        bits(state)


@pytest.mark.parametrize(
    ("state", "count", "found"),
    [
        ([1.0] * 3, 2, "the state has 3 numbers, but 2 ranges are declared in 'ranges'. Declare one for each number"),
        (0.25, 2, "the state has 1 number, but 2 ranges are declared in 'ranges'. Declare one for each number"),
        ([1.0] * 4, 1, "the state has 4 numbers, but 1 range is declared in 'ranges'. Declare one for each number"),
    ],
)
def test_another_number_of_numbers_is_a_sentence(state, count, found):
    with pytest.raises(UnreadableState, match=re.escape(found)):
        bits(state, count=count)


TWIST = SimpleNamespace(odom=SimpleNamespace(twist={"linear": SimpleNamespace(x=2.5, name="fast")}), flow=0.5)
NAMED = {"odom.twist.linear.x": (0, 4), "flow": (0, 4)}


def named(state: Any, ranges: Any, of: str = "") -> list[float]:
    encoder = Ranges(ranges=ranges, steps=3, of=of)
    encoder.bind(Binding(1, "student.encoder", Push))
    return encoder.encode(Moment(0, state, Push(kind="push", force=0.2), ""))[3:].tolist()


@pytest.mark.parametrize("show", [lambda state: state, take_snapshot], ids=["itself", "shown"])
@pytest.mark.parametrize(
    ("state", "ranges", "of"),
    [
        (TWIST, NAMED, ""),
        ({"robot": TWIST}, NAMED, "robot"),
        ({"flow": np.float32(0.5), "level_m": 2.5, "name": "boiler"}, {"level_m": (0, 4), "flow": [0, 4]}, ""),
        (Tank(2.5, 0.5), {"level_m": (0, 4), "flow": (0, 4)}, ""),
        ({"now": {"cgm": [2.5, 0.5]}}, [(0, 4), (0, 4)], "now.cgm"),
    ],
)
def test_names_are_read_as_keys_and_as_attributes(state, ranges, of, show):
    assert named(show(state), ranges, of) == CODE


def test_two_numbers_are_the_range_of_a_single_one():
    assert named(2.5, (0, 4)) == named(2.5, [0, 4]) == named(2.5, [(0, 4)]) == [1.0, 1.0, 0.0]


@pytest.mark.parametrize(
    ("state", "ranges", "of", "said"),
    [
        ({"cmg": [1.0]}, [(0, 1)], "cgm", "'cgm' is not in the state: dict has no 'cgm' (did you mean 'cmg'?); it has"),
        (TWIST, {"odom.twst": (0, 1)}, "", "'odom.twst' is not in the state: SimpleNamespace has no 'twst' (did you"),
        (
            Tank(1, 2),
            {"volume": (0, 1)},
            "",
            "Tank has no 'volume'; it has flow, level_m. Correct the name in 'ranges'",
        ),
        (2.5, {"x.y": (0, 1)}, "", "'x.y' is not in the state: float has no 'x'"),
        ([], {"x": (0, 1)}, "", "'x' is not in the state: list has no 'x'"),
        (
            TWIST,
            {"odom.twist.linear.name": (0, 1)},
            "",
            "'odom.twist.linear.name' of the state is 'fast', not a number",
        ),
    ],
)
def test_a_name_that_leads_to_no_number_is_a_sentence(state, ranges, of, said):
    for shown in (state, take_snapshot(state)):
        with pytest.raises(UnreadableState, match=rf"encoder 'ranges': .*{re.escape(said)}"):
            named(shown, ranges, of)


def test_an_object_without_members_is_a_sentence_too():
    class Bare:
        __slots__ = ()

    with pytest.raises(UnreadableState, match=r"Bare has no 'x'\. Correct the name in 'ranges' or 'of'\."):
        named(Bare(), {"x": (0, 1)})


@pytest.mark.parametrize("ranges", [{"x": (1, 0)}, [(0, 0)], (2, 1)])
def test_a_range_goes_upwards(ranges):
    with pytest.raises(ContractError, match=r"encoder 'ranges': every range is a low and a high number, low below"):
        named(0.0, ranges)


@pytest.mark.parametrize("of", ["", "robot"])
def test_its_examples_have_the_names(of):
    encoder = Ranges(ranges=NAMED, steps=3, of=of)
    encoder.bind(Binding(1, "student.encoder", Push))
    coded = [encoder.encode(Moment(0, state, Push(kind="push", force=0.2), ""))[3:] for state in encoder.examples()]
    assert [0.0, 2.0, 6.0] == [float(code.sum()) for code in coded]


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


def test_a_name_that_a_defaultdict_would_make_up_is_an_error_in_the_first_decision() -> None:
    loop = ts.wrap(lambda state: 0.5, action=ts.scalar(-1, 1), ranges={"speeed": (0, 1)})
    with pytest.raises(ts.UnreadableState, match="defaultdict has no 'speeed'.*did you mean 'speed'"):
        loop.step(defaultdict(float, speed=0.5))
