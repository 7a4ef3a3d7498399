from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import inf, nan

import numpy as np
import pytest

from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.core.words.records import Moment
from tutorstudent.plugins.prototype2 import Bits, SituationBits, Thermometer
from tutorstudent.plugins.prototype2.encoders import BitEncoder
from tutorstudent.sims.pioneer.types import Blob, DriveAction, PioneerState

ENCODERS = [Bits, SituationBits, Thermometer]
SITUATIONS = ["Subsumption", "Forward", "Avoid Spin", "Prey Spin", "Predator Spin"]
LEFT = DriveAction(kind="left", rotation=0.38)
RIGHT = DriveAction(kind="right", rotation=-0.38)
FORWARD = DriveAction(kind="forward", translation=0.12)
FREE = 5.0


def moment(
    sonar: dict[int, float] | None = None,
    blobs: tuple[Blob, ...] = (),
    stalled: bool = False,
    situation: str = "Subsumption",
    action: DriveAction = FORWARD,
) -> Moment[PioneerState, DriveAction]:
    ranges = np.full(16, FREE)
    for index, distance in (sonar or {}).items():
        ranges[index] = distance
    ranges.setflags(write=False)
    return Moment(0, PioneerState(ranges, blobs, stalled), action, situation)


def red(range_m: float, bearing_rad: float = 0.0) -> Blob:
    return Blob("red", bearing_rad, range_m, 0.1)


def blue(range_m: float, bearing_rad: float = 0.0) -> Blob:
    return Blob("blue", bearing_rad, range_m, 0.1)


def bound(cls: type[BitEncoder], **options: object) -> BitEncoder:
    encoder = cls(**options)
    encoder.bind(Binding(seed=7, slot="student.encoder", action=DriveAction))
    return encoder


def named(encoder: BitEncoder, at: Moment[PioneerState, DriveAction]) -> set[str]:
    """Return the names of the bits that are set."""
    code = encoder.encode(at)
    assert set(code.tolist()) <= {0.0, 1.0}
    return {name for name, bit in zip(encoder.names, code, strict=True) if bit}


@pytest.mark.parametrize("cls", ENCODERS)
def test_the_code_has_the_14_inputs_of_table_1(cls: type[BitEncoder]) -> None:
    encoder = bound(cls)
    assert (encoder.width, len(set(encoder.names)), encoder.encode(moment()).shape) == (14, 14, (14,))


@pytest.mark.parametrize("cls", ENCODERS)
def test_nothing_near_and_nothing_seen_sets_no_bit(cls: type[BitEncoder]) -> None:
    assert named(bound(cls), moment()) == set()


FRONT_BITS = [({i: r}, bits) for i in (2, 3, 4, 5) for r, bits in [(0.8, set()), (0.79, {"front limited"})]]
FRONT_BITS += [({i: 0.29}, {"front limited", "front blocked"}) for i in (2, 3, 4, 5)]
PREY = [
    ((red(0.95),), {"prey centre"}),
    ((red(0.94),), {"prey centre", "prey near"}),
    ((red(3.0, 0.36),), {"prey left"}),
    ((red(3.0, 0.35),), {"prey centre"}),
    ((red(3.0, -0.35),), {"prey centre"}),
    ((red(3.0, -0.36),), {"prey right"}),
    ((red(3.0, 0.5), red(2.0, -0.5)), {"prey right"}),
    ((Blob("green", 0.0, 0.2, 0.1),), set()),
]
PREDATOR = [((blue(0.4),), {"predator seen"}), ((blue(0.39, 1.0),), {"predator seen", "predator near"})]


@pytest.mark.parametrize(
    ("sonar", "expected"),
    [
        *FRONT_BITS,
        *(({i: r}, b) for i in (0, 1) for r, b in [(0.3, set()), (0.29, {"left limited"})]),
        *(({i: r}, b) for i in (6, 7) for r, b in [(0.3, set()), (0.29, {"right limited"})]),
        *(({i: r}, b) for i in (0, 1) for r, b in [(0.1, {"left limited"}), (0.09, {"left limited", "left blocked"})]),
        *(({i: 0.09}, {"right limited", "right blocked"}) for i in (6, 7)),
        *(({i: r}, b) for i in (10, 11, 12, 13) for r, b in [(0.3, set()), (0.29, {"back blocked"})]),
        *(({i: 0.0}, set()) for i in (8, 9, 14, 15)),
    ],
)
def test_each_sonar_bit_of_bits_is_set_below_its_threshold(sonar: dict[int, float], expected: set[str]) -> None:
    assert named(bound(Bits), moment(sonar)) == expected


@pytest.mark.parametrize(("blobs", "expected"), PREY + PREDATOR)
@pytest.mark.parametrize("cls", [Bits, Thermometer])
def test_each_camera_bit_is_set_as_named(cls: type[BitEncoder], blobs: tuple[Blob, ...], expected: set[str]) -> None:
    assert named(bound(cls), moment(blobs=blobs)) == expected


@pytest.mark.parametrize("cls", ENCODERS)
def test_the_stall_flag_is_one_bit(cls: type[BitEncoder]) -> None:
    assert named(bound(cls), moment(stalled=True)) == {"stalled"}


@pytest.mark.parametrize(
    ("front", "steps"), [(3.0, 0), (2.99, 1), (1.5, 1), (1.49, 2), (0.8, 2), (0.79, 3), (0.3, 3), (0.29, 4), (0.0, 4)]
)
def test_the_thermometer_sets_one_bit_more_at_each_step(front: float, steps: int) -> None:
    expected = {f"front within step {step}" for step in range(4, 4 - steps, -1)}
    assert named(bound(Thermometer), moment({3: front})) == expected


@pytest.mark.parametrize(
    ("sonar", "expected"),
    [({0: 0.09}, {"left blocked"}), ({7: 0.09}, {"right blocked"}), ({11: 0.29}, {"back blocked"}), ({1: 0.1}, set())],
)
def test_the_thermometer_has_one_bit_for_each_other_side(sonar: dict[int, float], expected: set[str]) -> None:
    assert named(bound(Thermometer), moment(sonar)) == expected


@pytest.mark.parametrize(
    ("situation", "expected"),
    [
        ("Subsumption", set()),
        ("Forward", {"state 1"}),
        ("Avoid Spin", {"state 2"}),
        ("Prey Spin", {"state 2", "state 1"}),
        ("Predator Spin", {"state 4"}),
        ("", {"state 4", "state 2", "state 1"}),
        ("somebody else's", {"state 4", "state 2", "state 1"}),
    ],
)
def test_the_situation_is_a_binary_number(situation: str, expected: set[str]) -> None:
    assert named(bound(SituationBits), moment(situation=situation)) == expected


@pytest.mark.parametrize(("action", "expected"), [(LEFT, {"turns left"}), (RIGHT, set()), (FORWARD, set())])
def test_the_side_that_the_tutor_turns_to_is_one_bit(action: DriveAction, expected: set[str]) -> None:
    assert named(bound(SituationBits), moment(action=action)) == expected


@pytest.mark.parametrize(
    ("at", "expected"),
    [
        (moment({4: 0.79}), {"front limited"}),
        (moment({4: 0.29}), {"front limited", "front blocked"}),
        (moment({1: 0.09}), {"left blocked"}),
        (moment({6: 0.09}), {"right blocked"}),
        (moment({12: 0.0}), set()),
        (moment(blobs=(red(0.94, 0.4),)), {"prey left", "prey near"}),
        (moment(blobs=(red(2.0, -0.4),)), {"prey right"}),
        (moment(blobs=(red(2.0),)), {"prey centre"}),
        (moment(blobs=(blue(0.4),)), set()),
        (moment(blobs=(blue(0.39),)), {"predator near"}),
    ],
)
def test_situation_bits_keep_these_sensors(at: Moment[PioneerState, DriveAction], expected: set[str]) -> None:
    assert named(bound(SituationBits), at) == expected


PREY_WAYS = [(), *((red(r, b),) for r in (0.5, 3.0) for b in (-1.0, 0.0, 1.0))]


def worlds(fronts: tuple[float, ...], sides: tuple[float, ...], backs: tuple[float, ...]) -> Iterator[PioneerState]:
    predators = [(), (blue(0.2),), (blue(3.0),)]
    axes = (fronts, sides, sides, backs, (False, True), PREY_WAYS, predators)
    for front, left, right, back, stalled, prey, predator in product(*axes):
        yield moment({3: front, 0: left, 7: right, 11: back}, prey + predator, stalled).state


def codes(encoder: BitEncoder, moments: Iterator[Moment[PioneerState, DriveAction]]) -> set[bytes]:
    return {encoder.encode(at).tobytes() for at in moments}


def test_bits_tells_2268_states_apart_and_no_more() -> None:
    """3 steps ahead and on each side, 2 behind, 2 of the stall flag, 7 of prey (none, or 3 x 2), 3 of predators."""
    states = worlds((0.1, 0.5, 5.0), (0.05, 0.2, 5.0), (0.1, 5.0))
    assert len(codes(bound(Bits), (Moment(0, s, FORWARD, "") for s in states))) == 3**3 * 2 * 2 * 7 * 3


def test_thermometer_tells_1680_states_apart() -> None:
    """5 steps ahead, 2 on each side and behind, 2 of the stall flag, 7 of prey, 3 of predators."""
    states = worlds((0.1, 0.5, 1.0, 2.0, 5.0), (0.05, 5.0), (0.1, 5.0))
    assert len(codes(bound(Thermometer), (Moment(0, s, FORWARD, "") for s in states))) == 5 * 2**4 * 7 * 3


def test_situation_bits_tells_4032_moments_apart() -> None:
    """6 situations, 2 sides, 3 steps ahead, 2 on each side, 2 of the stall flag, 7 of prey, 2 of predators."""
    states = list(worlds((0.1, 0.5, 5.0), (0.05, 5.0), (5.0,)))
    said = product(states, [LEFT, RIGHT], [*SITUATIONS, ""])
    moments = (Moment(0, state, action, situation) for state, action, situation in said)
    assert len(codes(bound(SituationBits), moments)) == 6 * 2 * 3 * 2 * 2 * 2 * 7 * 2


@pytest.mark.parametrize("cls", [Bits, Thermometer])
def test_sensors_only_means_that_the_tutor_is_not_seen(cls: type[BitEncoder]) -> None:
    encoder = bound(cls)
    seen = codes(encoder, (moment(situation=s, action=a) for s in SITUATIONS for a in (LEFT, RIGHT, FORWARD)))
    assert len(seen) == 1


@pytest.mark.parametrize("cls", ENCODERS)
def test_a_reading_that_is_no_number_counts_as_something_right_there(cls: type[BitEncoder]) -> None:
    encoder = bound(cls)
    for index in range(16):
        assert named(encoder, moment({index: nan})) == named(encoder, moment({index: 0.0}))
        assert named(encoder, moment({index: inf})) == set()
    assert named(encoder, moment(blobs=(red(nan, nan),))) == {"prey centre", "prey near"}


@pytest.mark.parametrize("cls", ENCODERS)
def test_the_moment_is_not_changed(cls: type[BitEncoder]) -> None:
    at = moment({3: 0.2}, (red(0.5), blue(0.3)))
    before = at.state.sonar_m.tobytes(), at.state.blobs
    bound(cls).encode(at)
    assert (at.state.sonar_m.tobytes(), at.state.blobs) == before


def test_thresholds_are_options() -> None:
    encoder = bound(Bits, front_m=1.0, clear_m=2.0, prey_m=3.0, predator_m=3.0, centre_rad=1.0)
    at = moment({3: 0.9}, (red(2.0, 0.9), blue(2.0)))
    expected = {"front limited", "front blocked", "prey centre", "prey near", "predator seen", "predator near"}
    assert named(encoder, at) == expected


@pytest.mark.parametrize(
    ("cls", "options", "message"),
    [
        (
            Bits,
            {"front_m": 0.9},
            (
                "encoder 'prototype2-bits': option 'clear_m': must be more than front_m (0.9), "
                "or a spin would end in front of an obstacle, found 0.8."
            ),
        ),
        (
            Bits,
            {"side_m": 0.2, "side_limited_m": 0.2},
            (
                "encoder 'prototype2-bits': option 'side_limited_m': must be more than side_m (0.2), "
                "or two bits would say the same, found 0.2."
            ),
        ),
        (
            Thermometer,
            {"front_steps_m": (0.3, 0.3, 1.0, 2.0)},
            (
                "encoder 'prototype2-thermometer': option 'front_steps_m': must be positive and "
                "ascending, found (0.3, 0.3, 1.0, 2.0)."
            ),
        ),
        (
            SituationBits,
            {"center_rad": 0.3},
            (
                "encoder 'prototype2-situation-bits': unknown option 'center_rad' (did you mean 'centre_rad'?). "
                "Options: back_m, centre_rad, clear_m, front_m, predator_m, prey_m, side_limited_m, side_m."
            ),
        ),
    ],
)
def test_mistaken_options_are_refused_in_a_sentence(
    cls: type[BitEncoder], options: dict[str, object], message: str
) -> None:
    with pytest.raises(PipelineError) as error:
        cls(**options)
    assert str(error.value) == message
