"""The streamlined algorithm's codec and action modifier (Thesis 5.2.1)."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import tutorstudent as ts
from tutorstudent.core.roles.binding import Binding
from tutorstudent.plugins import streamlined
from tutorstudent.plugins.streamlined import LevelAmpbit, Modifier
from tutorstudent.sims.pioneer.types import DriveAction

KINDS = ("stop", "forward", "backward", "left", "right")


def codec_for(**options: object) -> LevelAmpbit:
    codec = LevelAmpbit(**options)
    codec.bind(Binding(seed=7, slot="student.codec", action=DriveAction))
    return codec


def action(kind: str) -> DriveAction:
    return DriveAction.model_validate({"kind": kind})


@pytest.mark.parametrize(("code", "width"), [("binary", 4), ("thermometer", 8), ("analogue", 2)])
def test_every_level_and_ampbit_comes_back_and_the_kind_is_not_said(code: str, width: int) -> None:
    codec = codec_for(level=code)
    assert width == codec.width
    for level, ampbit in itertools.product(range(8), (False, True)):
        encoded = {codec.encode(ts.GradedAction(action(kind), level, ampbit)).tobytes() for kind in KINDS}
        assert len(encoded) == 1
        decoded = codec.decode(np.frombuffer(encoded.pop()))
        assert ts.LevelProposal(level=level, ampbit=ampbit) == decoded


def test_all_sixteen_outputs_decode() -> None:
    codec = codec_for()
    for bits in itertools.product((0.0, 1.0), repeat=4):
        level = int(4 * bits[0] + 2 * bits[1] + bits[2])
        assert ts.LevelProposal(level=level, ampbit=bool(bits[3])) == codec.decode(np.array(bits))


@pytest.mark.parametrize(("overflow", "taught"), [("clip", 7), ("wrap", 0)])
def test_level_eight_is_taught_as_seven_or_wraps(overflow: str, taught: int) -> None:
    codec = codec_for(overflow=overflow)
    assert taught == codec.decode(codec.encode(ts.GradedAction(action("left"), 8, True))).level


@pytest.mark.parametrize("outputs", [[0, 0, 0, math.nan], [math.inf, 0, 0, 0], [0, 0, 0], [0] * 7])
def test_outputs_that_mean_nothing_are_refused(outputs: list[float]) -> None:
    with pytest.raises(ValueError, match=r"reads \(4,\)|reads finite numbers"):
        codec_for().decode(np.array(outputs, dtype=float))


@pytest.mark.parametrize(("kind", "level", "ampbit"), list(itertools.product(KINDS, range(8), (False, True))))
def test_the_modifier_gives_the_tutor_action_the_student_level_whatever_the_kind(
    kind: str, level: int, ampbit: bool
) -> None:
    tutor_action = action(kind)
    selected = Modifier[DriveAction]().select(tutor_action, ts.LevelProposal(level=level, ampbit=ampbit))
    assert (tutor_action, level, ampbit) == selected
    assert tutor_action is selected.action


def test_codec_and_modifier_speak_of_the_same_proposal_type() -> None:
    assert LevelAmpbit.proposal is Modifier.proposal is ts.LevelProposal


def test_the_plugin_names_its_parts() -> None:
    assert [cls.name for cls in streamlined.tutorstudent_components()] == ["level-ampbit", "modifier"]
