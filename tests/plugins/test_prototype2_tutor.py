from __future__ import annotations

from collections.abc import Iterator
from itertools import cycle, islice, pairwise
from math import inf, nan
from typing import Any

import numpy as np
import pytest

from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.words.errors import ContractError, PipelineError
from tutorstudent.plugins.prototype2 import Prototype2, tutorstudent_components
from tutorstudent.plugins.prototype2.percept import perceive
from tutorstudent.plugins.prototype2.planner_options import Tuning
from tutorstudent.plugins.prototype2.rules import RULES
from tutorstudent.sims.pioneer.types import Blob, DriveAction, PioneerState


def state(sonar: dict[int, float] | None = None, *blobs: Blob, stalled: bool = False) -> PioneerState:
    ranges = np.full(16, 5.0)
    for index, distance in (sonar or {}).items():
        ranges[index] = distance
    ranges.setflags(write=False)
    return PioneerState(ranges, blobs, stalled)


def red(range_m: float, bearing_rad: float = 0.0) -> Blob:
    return Blob("red", bearing_rad, range_m, 0.1)


def blue(range_m: float, bearing_rad: float = 0.0) -> Blob:
    return Blob("blue", bearing_rad, range_m, 0.1)


FREE = state()
STALL = state(stalled=True)


def bound(seed: int = 7, **options: Any) -> Prototype2:
    tutor = Prototype2(**{"wander_turn": 0.0, **options})
    tutor.bind(Binding(seed=seed, slot="tutor", action=DriveAction))
    tutor.reset()
    return tutor


def noise(seed: int, decisions: int) -> Iterator[PioneerState]:
    """Yield states with anything anywhere."""
    rng = np.random.default_rng(seed)
    for _ in range(decisions):
        ranges = rng.uniform(0, 1.5, 16)
        ranges.setflags(write=False)
        blobs = [Blob(c, rng.uniform(-1, 1), rng.uniform(0, 2), 0.1) for c in rng.choice(["red", "blue"], 3)]
        yield PioneerState(ranges, tuple(blobs[: rng.integers(4)]), bool(rng.random() < 0.2))


def act(tutor: Prototype2, states: Iterator[PioneerState]) -> list[tuple[DriveAction, str]]:
    return [(tutor.act(seen), tutor.situation) for seen in states]


def test_the_hook_offers_the_tutor_and_three_encoders() -> None:
    names = {component.name for component in tutorstudent_components()}
    assert names >= {"prototype2", "prototype2-bits", "prototype2-situation-bits", "prototype2-thermometer"}


def test_the_planner_has_the_five_states_of_the_thesis() -> None:
    assert list(RULES) == ["Subsumption", "Forward", "Avoid Spin", "Prey Spin", "Predator Spin"]


def test_actions_are_few_frozen_objects_of_the_four_kinds_in_motion() -> None:
    made = [action for action, _ in act(bound(), noise(1, 3000))]
    assert sorted({action.kind for action in made}) == ["backward", "forward", "left", "right"]
    assert len({id(action) for action in made}) == 4


def test_speeds_and_duration_are_the_options() -> None:
    tutor = bound(translation=0.2, rotation=0.5, duration_s=0.4)
    assert tutor.act(FREE) == DriveAction(kind="forward", translation=0.2, duration_s=0.4)
    assert tutor.act(state({3: 0.2})) == DriveAction(kind="right", rotation=-0.5, duration_s=0.4)


def test_the_same_seed_gives_the_same_actions_and_another_seed_others() -> None:
    first, again, other = (act(bound(seed, wander_turn=0.1), noise(2, 2000)) for seed in (7, 7, 8))
    assert first == again
    assert first != other


def test_reset_forgets_the_episode() -> None:
    tutor = bound(recover_random=0.0, recover_more=0)
    act(tutor, noise(3, 500))
    tutor.reset()
    assert (tutor.situation, tutor.rule) == ("Subsumption", "")
    fresh = bound(recover_random=0.0, recover_more=0)
    calm = [state(dict.fromkeys(range(16), float(r))) for r in np.random.default_rng(4).uniform(0.05, 2, 300)]
    assert act(tutor, iter(calm)) == act(fresh, iter(calm))


def test_states_are_not_changed() -> None:
    tutor = bound()
    for seen in noise(5, 500):
        ranges = seen.sonar_m.copy()
        writable = PioneerState(ranges, seen.blobs, seen.stalled)
        tutor.act(writable)
        assert (ranges.tobytes(), writable.blobs) == (seen.sonar_m.tobytes(), seen.blobs)


# Spins do not dither

TRIGGERS = [
    state({3: 0.2, 0: 0.5}),
    state({3: 0.2, 7: 0.5}),
    state({0: 0.05}),
    state({7: 0.05}),
    state({3: 0.5}, blue(0.3, 0.5)),
    state({3: 0.5}, blue(0.3, -0.5)),
    state({3: 0.5}, red(0.5, 0.5)),
    state({3: 0.5}, red(0.5, -0.5)),
]


def test_alternating_triggers_do_not_flip_a_spin() -> None:
    tutor = bound(spin_limit=10_000)
    kinds = {tutor.act(seen).kind for seen in islice(cycle(TRIGGERS), 1000)}
    assert kinds == {"right"} or kinds == {"left"}


def test_a_clear_way_for_a_moment_does_not_flip_a_spin() -> None:
    tutor = bound()
    turns = []
    for trigger in islice(cycle(TRIGGERS[:6]), 200):
        turns.append(tutor.act(trigger).kind)
        tutor.act(FREE)
        tutor.act(FREE)
    assert len(set(turns) - {"forward"}) == 1


def test_random_triggers_do_not_flip_a_spin_before_the_robot_moves_freely() -> None:
    for seed in range(20):
        tutor, side = bound(seed, spin_limit=10_000), ""
        for choice in np.random.default_rng(seed).integers(len(TRIGGERS), size=200):
            kind = tutor.act(TRIGGERS[choice]).kind
            side = side or (kind if kind in ("left", "right") else "")
            assert kind in (side, "forward")


def test_after_moving_freely_a_spin_chooses_its_side_anew() -> None:
    tutor = bound()
    assert tutor.act(state({7: 0.05})).kind == "left"
    for _ in range(12):
        tutor.act(FREE)
    assert tutor.act(state({0: 0.05})).kind == "right"


# Attractors found: one entry into Prey Spin for one encounter


def entries(tutor: Prototype2, states: list[PioneerState]) -> int:
    situations = [tutor.situation, *(situation for _, situation in act(tutor, iter(states)))]
    return sum(now == "Prey Spin" != was for was, now in pairwise(situations))


NEAR = state({}, red(0.9))


@pytest.mark.parametrize(
    ("encounter", "expected"),
    [
        ([state({}, red(1.0)), FREE], 0),
        ([NEAR, FREE], 1),
        ([NEAR] * 100 + [FREE], 1),
        ([NEAR, state({}, red(3.0)), NEAR, FREE], 1),
        ([NEAR, state({}, red(0.9), stalled=True), *[NEAR] * 20, FREE], 1),
        ([NEAR, state({3: 0.2}), NEAR, state({0: 0.05}, red(0.5)), FREE], 1),
        ([NEAR, FREE, NEAR, NEAR, NEAR], 2),
    ],
    ids=["just not near", "short", "long", "prey comes and goes in view", "stall", "obstacle", "comes after the robot"],
)
def test_one_encounter_is_one_entry_into_prey_spin(encounter: list[PioneerState], expected: int) -> None:
    assert entries(bound(), [FREE, *encounter]) == expected


# Recovery from stalls


@pytest.mark.parametrize("seed", range(5))
def test_a_recovery_never_repeats_the_refused_action(seed: int) -> None:
    tutor = bound(seed)
    last, recoveries = tutor.act(FREE), 0
    for sees in noise(seed, 2000):
        action = tutor.act(PioneerState(sees.sonar_m, sees.blobs, stalled=True))
        if tutor.rule.endswith("recover from a stall"):
            recoveries += 1
            assert action is not last
        last = action
    assert recoveries > 500


def test_a_robot_that_stalls_for_ever_tries_everything() -> None:
    tutor = bound()
    assert {tutor.act(STALL).kind for _ in range(200)} == {"forward", "backward", "left", "right"}


def test_a_report_that_is_older_than_the_recovery_does_not_end_it() -> None:
    tutor = bound(stall_delay=4, recover_min=6)
    tutor.act(FREE)
    kinds, rules = [], []
    for _ in range(5):
        kinds.append(tutor.act(STALL).kind)
        rules.append(tutor.rule.removeprefix("avoid: "))
    assert len(set(kinds[:4])) == 1
    assert rules == ["recover from a stall", *["keep recovering"] * 3, "recover from a stall"]


def test_a_recovery_lasts_from_three_to_eight_decisions() -> None:
    lengths = set()
    for seed in range(60):
        tutor = bound(seed)
        tutor.act(STALL)
        rules = [(tutor.act(FREE), tutor.rule)[1] for _ in range(10)]
        lengths.add(1 + rules.count("keep recovering"))
    assert lengths == {3, 4, 5, 6, 7, 8}


# Broken sensors


def test_a_reading_that_is_no_number_counts_as_an_obstacle_and_an_infinite_one_as_free() -> None:
    assert bound().act(state({3: nan})).kind in ("left", "right")
    assert bound().act(state(dict.fromkeys(range(16), inf))).kind == "forward"
    assert bound().act(state({3: -inf})).kind in ("left", "right")


def test_an_infinite_reading_is_as_far_as_the_sonar_reaches() -> None:
    assert perceive(state(dict.fromkeys(range(16), inf))) == perceive(FREE)


def test_unreadable_things_count_as_near_and_ahead() -> None:
    seen = perceive(state({}, red(nan, nan), blue(nan, 0.5), red(2.0)))
    assert (seen.prey_m, seen.prey_rad, seen.predator_m, seen.predator_rad) == (0.0, 0.0, 0.0, 0.5)


def test_things_of_other_colours_are_not_looked_at() -> None:
    seen = perceive(state({}, Blob("green", 0.0, 0.1, 0.1)))
    assert not (seen.prey_seen)
    assert not (seen.predator_seen)


@pytest.mark.parametrize("sonars", [0, 8, 17])
def test_a_state_of_another_robot_is_refused(sonars: int) -> None:
    with pytest.raises(ContractError) as error:
        bound().act(PioneerState(np.ones(sonars), (), False))
    assert str(error.value) == f"prototype 2 reads 16 sonar ranges; the state has {sonars}."


# Options


def extremes() -> Iterator[dict[str, Any]]:
    """Yield each option at its bounds, and all of them at once."""
    every: dict[str, dict[str, Any]] = {"low": {}, "high": {}}
    for name, info in Tuning.model_fields.items():
        bounds = {type(item).__name__: item for item in info.metadata}
        low = bounds["Ge"].ge if "Ge" in bounds else bounds["Gt"].gt + 1e-6
        for side, value in (("low", low), ("high", bounds["Le"].le)):
            every[side][name] = value
            yield {name: value}
    yield every["low"] | {"clear_m": 2e-6}
    yield every["high"] | {"front_m": 4.9}


@pytest.mark.parametrize("options", list(extremes()), ids=lambda options: str(options)[:40])
def test_actions_are_in_bounds_for_all_extremes_of_the_options(options: dict[str, Any]) -> None:
    if options == {"front_m": 5}:
        options = options | {"front_m": 4.9, "clear_m": 5.0}
    if options == {"clear_m": 1e-6}:
        options = {"clear_m": 1e-6, "front_m": 1e-7}
    for action, situation in act(bound(**options), noise(6, 400)):
        assert (action.kind in ("forward", "backward")) == (action.rotation == 0.0)
        assert (action.kind in ("left", "right")) == (action.translation == 0.0)
        assert abs(action.translation) + abs(action.rotation) <= 1
        assert situation in RULES


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            {"translation": 0.0},
            "tutor 'prototype2': option 'translation': input should be greater than 0, found 0.0.",
        ),
        (
            {"clear_m": 0.2},
            (
                "tutor 'prototype2': option 'clear_m': must be more than front_m (0.3), "
                "or a spin would end in front of an obstacle, found 0.2."
            ),
        ),
    ],
)
def test_mistaken_options_are_refused_in_a_sentence(options: dict[str, float], message: str) -> None:
    with pytest.raises(PipelineError) as error:
        Prototype2(**options)
    assert str(error.value) == message


def test_every_option_has_a_description_with_its_unit() -> None:
    for name, info in Tuning.model_fields.items():
        assert info.description, name
        assert any(unit in info.description for unit in (", m", ", s", "rad", "fraction", "decisions", "probability"))
