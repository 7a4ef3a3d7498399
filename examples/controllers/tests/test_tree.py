"""The behaviour tree: which leaf decides in which state, and what it says."""

from __future__ import annotations

import math
import sys

import numpy as np
import pytest

import tutorstudent as ts
from tutorstudent.core.roles.binding import Binding
from tutorstudent.sims.pioneer.types import Blob, DriveAction, PioneerState
from tutorstudent_controllers.tree.tutor import Tree

AHEAD = slice(2, 6)


def tree(**options: float) -> Tree:
    made = Tree(**{"stroll": 10_000, **options})  # it hardly ever turns while it wanders
    made.bind(Binding(seed=7, slot="tutor", action=DriveAction))
    return made


def sensed(ahead_m: float = 5.0, left_m: float = 5.0, stalled: bool = False, **bearings: float) -> PioneerState:
    """Return a state; a colour's bearing in rad puts a thing 0.5 m away, with '_far' at its name's end 3 m."""
    sonar_m = np.full(16, 5.0)
    sonar_m[:4] = left_m
    sonar_m[AHEAD] = ahead_m
    blobs = [
        Blob(name.removesuffix("_far"), bearing, 3.0 if name.endswith("_far") else 0.5, 0.2)
        for name, bearing in bearings.items()
    ]
    return PioneerState(sonar_m, tuple(blobs), stalled)


@pytest.mark.parametrize(
    ("state", "kind", "leaf"),
    [
        (sensed(), "forward", "Wander"),
        (sensed(red_far=0.1), "forward", "Approach"),
        (sensed(red_far=0.5), "left", "Face"),
        (sensed(red_far=-0.5), "right", "Face"),
        (sensed(ahead_m=0.3, left_m=0.2), "right", "Turn from obstacle"),
        (sensed(red=0.3), "right", "Turn from red"),
        (sensed(red=-0.3), "left", "Turn from red"),
        (sensed(blue=0.3), "right", "Turn from blue"),
        (sensed(blue_far=0.3), "forward", "Wander"),
        (sensed(stalled=True), "backward", "Back off"),
        (sensed(stalled=True, red=0.3), "backward", "Back off"),
        (sensed(ahead_m=0.3, red=0.3), "right", "Turn from red"),
        (sensed(ahead_m=math.nan, left_m=0.2), "right", "Turn from obstacle"),
    ],
)
def test_the_leaf_that_runs_decides_the_kind_and_names_the_situation(state: PioneerState, kind: str, leaf: str) -> None:
    pilot = tree()
    action = pilot.act(state)
    assert (kind, leaf) == (action.kind, pilot.situation)


def test_after_a_stall_it_backs_off_and_swings_round_whatever_the_sensors_say() -> None:
    pilot = tree(back_off=2, swing=3)
    said = [pilot.act(sensed(stalled=i == 0, red_far=0.0)).kind for i in range(6)]
    assert ["backward"] * 2 == said[:2]
    assert {"left", "right"} > set(said[2:5])
    assert "forward" == said[5]


def test_a_turn_from_red_lasts_until_nothing_red_is_in_view() -> None:
    pilot = tree()
    assert ["right"] * 3 == [pilot.act(sensed(red=0.3)).kind for _ in range(3)]
    assert "forward" == pilot.act(sensed()).kind
    assert "Wander" == pilot.situation


def test_a_turn_that_follows_a_turn_keeps_its_side() -> None:
    pilot = tree()
    pilot.act(sensed(red=0.3))
    after = pilot.act(sensed(ahead_m=0.3))
    assert ("right", "Turn from obstacle") == (after.kind, pilot.situation)


def test_two_trees_of_one_seed_do_the_same() -> None:
    one, other = tree(stroll=3), tree(stroll=3)
    assert [one.act(sensed()) for _ in range(60)] == [other.act(sensed()) for _ in range(60)]


def test_without_the_package_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "tutorstudent_controllers.tree.planting", None)
    with pytest.raises(ts.PipelineError, match=r"tutor 'py-tree' needs py-trees; install it with: pip install"):
        tree()
