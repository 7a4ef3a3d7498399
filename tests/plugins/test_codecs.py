"""The codec of the full algorithm and the level codes that it is made of (Thesis 3.3.2)."""

from __future__ import annotations

import itertools
import math
from typing import Any, Literal

import numpy as np
import pytest

import tutorstudent as ts
from tutorstudent.core.roles.binding import Binding
from tutorstudent.plugins.codecs import KindLevelAmpbit
from tutorstudent.plugins.level_codes import AnalogueLevel, BinaryLevel, LevelCode, ThermometerLevel
from tutorstudent.sims.pioneer.types import DriveAction

KINDS = ("stop", "forward", "backward", "left", "right")
CODES = [BinaryLevel, ThermometerLevel, AnalogueLevel]


class Switch(ts.Action):
    kind: Literal["off", "on"]


def codec_for(action: type[ts.Action] = DriveAction, **options: Any) -> KindLevelAmpbit:
    codec = KindLevelAmpbit(**options)
    codec.bind(Binding(seed=7, slot="student.codec", action=action))
    return codec


def target(kind: str, level: int, ampbit: bool) -> ts.GradedAction[DriveAction]:
    return ts.GradedAction(DriveAction.model_validate({"kind": kind}), level, ampbit)


@pytest.mark.parametrize("code", ["binary", "thermometer", "analogue"])
@pytest.mark.parametrize("max_level", [1, 2, 5, 7, 8])
def test_every_kind_level_and_ampbit_comes_back(code: str, max_level: int) -> None:
    codec = codec_for(level=code, max_level=max_level)
    for kind, level, ampbit in itertools.product(KINDS, range(max_level + 1), (False, True)):
        outputs = codec.encode(target(kind, level, ampbit))
        assert outputs.shape == (codec.width,)
        assert 0.0 <= outputs.min() <= outputs.max() <= 1.0
        assert ts.KindProposal(kind=kind, level=level, ampbit=ampbit) == codec.decode(outputs)


def test_the_pioneer_takes_the_seven_outputs_of_table_1() -> None:
    assert codec_for().width == 7


@pytest.mark.parametrize(
    ("code", "width"), [("binary", 3 + 3 + 1), ("thermometer", 3 + 7 + 1), ("analogue", 3 + 1 + 1)]
)
def test_the_width_follows_from_the_code_of_the_level(code: str, width: int) -> None:
    assert width == codec_for(level=code).width


def test_the_outputs_are_kind_then_level_then_ampbit_most_significant_first() -> None:
    assert codec_for().encode(target("right", 6, True)).tolist() == [1, 0, 0, 1, 1, 0, 1]


def test_all_128_outputs_decode_and_three_kind_codes_name_no_kind() -> None:
    codec = codec_for()
    for bits in itertools.product((0.0, 1.0), repeat=7):
        number = int(4 * bits[0] + 2 * bits[1] + bits[2])
        level = int(4 * bits[3] + 2 * bits[4] + bits[5])
        kind = KINDS[number] if number < 5 else None
        expected = ts.KindProposal(kind=kind, level=level, ampbit=bool(bits[6]))
        assert expected == codec.decode(np.array(bits))


@pytest.mark.parametrize(("value", "bit"), [(0.0, False), (0.5, False), (math.nextafter(0.5, 1), True), (1.0, True)])
def test_an_output_is_read_as_one_above_a_half(value: float, bit: bool) -> None:
    decoded = codec_for().decode(np.array([0, 0, value, 0, 0, value, value]))
    assert ts.KindProposal(kind="forward" if bit else "stop", level=int(bit), ampbit=bit) == decoded


def test_an_action_class_of_one_kind_needs_no_output_for_it() -> None:
    codec = codec_for(ts.Action)
    assert codec.width == 4
    assert codec.decode(np.array([1.0, 0.0, 0.0, 0.0])).kind == "command"


def test_two_kinds_need_one_output_and_every_code_names_one() -> None:
    codec = codec_for(Switch)
    assert codec.width == 1 + 3 + 1
    assert [codec.decode(np.array([bit, 0, 0, 0, 0])).kind for bit in (0.0, 1.0)] == ["off", "on"]


@pytest.mark.parametrize("code", ["binary", "thermometer", "analogue"])
@pytest.mark.parametrize(("overflow", "taught"), [("clip", [7, 7, 7]), ("wrap", [7, 0, 1])])
def test_a_level_above_the_maximum_is_clipped_or_wrapped(code: str, overflow: str, taught: list[int]) -> None:
    codec = codec_for(level=code, overflow=overflow)
    assert taught == [codec.decode(codec.encode(target("left", level, True))).level for level in (7, 8, 9)]


def test_a_binary_code_above_the_maximum_is_read_as_the_maximum() -> None:
    assert [BinaryLevel(5).decode(bits) for bits in itertools.product((0.0, 1.0), repeat=3)] == [0, 1, 2, 3, 4, 5, 5, 5]


def test_a_thermometer_counts_its_ones_wherever_they_stand() -> None:
    for bits in itertools.product((0.0, 1.0), repeat=4):
        assert ThermometerLevel(4).decode(bits) == sum(bits)


@pytest.mark.parametrize(
    ("value", "level"), [(-1e308, 0), (0.07, 0), (0.0715, 1), (0.5, 4), (0.928, 6), (0.9286, 7), (1e308, 7)]
)
def test_an_analogue_level_is_the_nearest_one(value: float, level: int) -> None:
    assert level == AnalogueLevel(7).decode([value])


@pytest.mark.parametrize("cls", CODES)
def test_any_finite_numbers_are_read_as_a_level_of_the_code(cls: type[LevelCode]) -> None:
    code, rng = cls(5), np.random.default_rng(1)
    for size in (1.0, 1e300):
        for values in rng.normal(scale=size, size=(200, code.width)).tolist():
            assert 0 <= code.decode(values) <= 5


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_an_output_that_is_not_finite_is_refused(bad: float) -> None:
    with pytest.raises(ValueError, match=rf"output 2 is {bad}; a codec reads finite numbers"):
        codec_for().decode(np.array([0, 1, bad, 0, 0, 0, 1]))


@pytest.mark.parametrize("shape", [(), (6,), (8,), (1, 7)])
def test_outputs_of_another_shape_are_refused(shape: tuple[int, ...]) -> None:
    with pytest.raises(ValueError, match=r"outputs have the shape .*; this codec reads \(7,\)"):
        codec_for().decode(np.zeros(shape))


def test_a_negative_level_cannot_be_taught() -> None:
    with pytest.raises(ValueError, match=r"level -1 cannot be taught; levels start at 0"):
        codec_for().encode(target("left", -1, True))


def test_a_kind_of_another_action_class_is_refused_with_the_kinds() -> None:
    message = r"no code for the kind 'on'; the tutor's DriveAction has backward, forward, left, right, stop"
    with pytest.raises(ts.ContractError, match=message):
        codec_for().encode(ts.GradedAction(Switch(kind="on"), 0, True))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"max_level": 0}, r"option 'max_level': input should be greater than or equal to 1, found 0"),
        ({"level": "gray"}, r"option 'level': input should be 'binary', 'thermometer' or 'analogue', found 'gray'"),
        ({"max_levl": 3}, r"unknown option 'max_levl' \(did you mean 'max_level'\?\)"),
    ],
)
def test_wrong_options_are_named(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ts.PipelineError, match=message):
        KindLevelAmpbit(**options)


def test_a_lesson_in_hand_is_not_changed_by_the_next_encoding() -> None:
    codec = codec_for()
    first = codec.encode(target("stop", 0, False))
    codec.encode(target("right", 7, True))
    assert not first.any()
