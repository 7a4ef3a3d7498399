"""Prototype 2 alone in the Pioneer's world: it does its tasks (Thesis 3.3.1) and nothing traps it."""

from __future__ import annotations

from itertools import groupby, pairwise
from typing import NamedTuple

import numpy as np
import pytest

from tutorstudent.core.roles.binding import Binding
from tutorstudent.plugins.prototype2 import Prototype2
from tutorstudent.sims.pioneer.types import DriveAction

pytest.importorskip("pybullet")
pytestmark = pytest.mark.simulator

METRES_PER_DECISION = 0.12 * 0.9 * 0.2


class Drive(NamedTuple):
    """What a robot did."""

    kinds: list[str]
    situations: list[str]
    stalled: list[bool]
    path: np.ndarray
    distance_m: float


def drive(scene: str, seed: int, decisions: int) -> Drive:
    from tutorstudent.sims.pioneer.pioneer_world import PioneerWorld

    world, tutor = PioneerWorld(scene=scene), Prototype2()
    for part, slot in ((world, "world"), (tutor, "tutor")):
        part.bind(Binding(seed=seed, slot=slot, action=DriveAction))
    state, kinds, situations, events = world.reset(seed), [], [], []
    for _ in range(decisions):
        action = tutor.act(state)
        kinds.append(action.kind)
        situations.append(tutor.situation)
        state, happened, *_ = world.step(action)
        events.append(happened)
    world.close()
    path = np.array([(event["x_m"], event["y_m"]) for event in events])
    stalled = [event["stalled_ticks"] > 0 for event in events]
    return Drive(kinds, situations, stalled, path, sum(event["distance_m"] for event in events))


def longest(flags: list[bool]) -> int:
    return max((len(list(run)) for value, run in groupby(flags) if value), default=0)


def longest_stay(path: np.ndarray, radius_m: float) -> int:
    """Return the most decisions, within about a tenth, that the robot spent within a radius of where it was."""
    return max(_stay(path[start:], radius_m) for start in range(0, len(path), 50))


def _stay(path: np.ndarray, radius_m: float) -> int:
    away = np.hypot(*(path - path[0]).T) > radius_m
    return int(np.argmax(away)) if away.any() else len(path)


def check_that_nothing_traps(done: Drive) -> None:
    moves = sum(kind in ("forward", "backward") for kind in done.kinds)
    assert longest(done.stalled) < 50
    assert done.distance_m > 0.6 * METRES_PER_DECISION * moves
    assert moves > 0.5 * len(done.kinds)
    assert longest_stay(done.path, 0.5) < 2000


@pytest.mark.parametrize("scene", ["chase-avoid", "cave-box"])
def test_prototype_2_finds_attractors_and_is_not_trapped(scene: str) -> None:
    done = drive(scene, seed=1, decisions=1500)
    found = sum(now == "Prey Spin" != was for was, now in pairwise(done.situations))
    check_that_nothing_traps(done)
    assert found > 0
    assert set(done.situations) >= {"Subsumption", "Forward", "Avoid Spin", "Prey Spin"}
    assert sum(done.stalled) < 0.01 * len(done.stalled)


def test_the_same_seed_drives_the_same_way() -> None:
    assert drive("chase-avoid", 3, 200).path.tolist() == drive("chase-avoid", 3, 200).path.tolist()


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("scene", ["chase-avoid", "cave-box", "cave-predator-prey", "cave-predator-prey-box"])
def test_nothing_traps_prototype_2_for_a_trial_of_the_thesis(scene: str, seed: int) -> None:
    check_that_nothing_traps(drive(scene, seed, 10_000))
