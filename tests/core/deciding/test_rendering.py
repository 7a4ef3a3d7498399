"""From a level to an action: closed forms, bounds and directions (the behaviour contract, 2 and 3)."""

from __future__ import annotations

import math
from typing import Any, ClassVar

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from pydantic import field_validator, model_validator

from tests.core.oracle.scripted import ScriptedTutor, engine, level
from tests.core.oracle.shapes import Flight, Oven, Valve
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.words.actions import Action, AmplificationMap, component
from tutorstudent.plugins.amplifiers import Never
from tutorstudent.plugins.changes import Multiplicative
from tutorstudent.sims.pioneer.types import DriveAction

WIDE = Limits(cap=1e6)


def rendered(action: Any, number: int, amount: float = 0.1, change: Any = None) -> Any:
    """Return what is executed for a tutor's action at a level."""
    tutor = ScriptedTutor(act=lambda state: action)
    tutor.action = type(action)
    amplifier = Never(amount=amount, change=change) if change else Never(amount=amount)
    wrapped = engine(len, level(number), tutor=tutor, amplifier=amplifier, limits=WIDE, on_incident="raise")
    return wrapped.step(None)


DIRECTIONS = [("forward", "translation", 1), ("backward", "translation", -1), ("left", "rotation", 1)]
DIRECTIONS += [("right", "rotation", -1)]


@pytest.mark.parametrize(("kind", "name", "sign"), DIRECTIONS)
@pytest.mark.parametrize("number", range(1, 13))
def test_a_level_adds_its_tenths_in_the_kinds_direction_up_to_the_bound(
    kind: str, name: str, sign: int, number: int
) -> None:
    said = DriveAction(kind=kind, translation=0.05, rotation=-0.15, duration_s=0.7)
    own = getattr(said, name)
    expected = {**said.model_dump(), name: max(-1.0, min(1.0, own + sign * number / 10))}
    assert pytest.approx(expected["translation"]) == rendered(said, number).translation
    assert pytest.approx(expected["rotation"]) == rendered(said, number).rotation
    assert (kind, 0.7) == (rendered(said, number).kind, rendered(said, number).duration_s)


def test_level_zero_and_kinds_with_nothing_to_amplify_execute_the_tutors_own_object() -> None:
    for said in (DriveAction(kind="forward", translation=0.3), Valve(opening=0.4)):
        assert rendered(said, 0) is said
    stop = DriveAction(kind="stop", duration_s=1.0)
    assert rendered(stop, 7) is stop


@pytest.mark.parametrize(("opening", "expected"), [(0.5, 1.1), (-0.2, -0.8), (0.0, 0.0), (-0.9, -1.0), (1.9, 2.0)])
def test_outward_is_away_from_neutral_and_nothing_at_neutral(opening: float, expected: float) -> None:
    """Three tenths of a scale of 2.0, the larger bound's distance from zero."""
    assert pytest.approx(expected) == rendered(Valve(opening=opening), 3).opening


@pytest.mark.parametrize(("power", "expected"), [(50.0, 59.0), (30.0, 21.0), (40.0, 40.0), (95.0, 100.0), (12.0, 10.0)])
def test_outward_counts_from_a_neutral_that_is_not_zero(power: float, expected: float) -> None:
    assert pytest.approx(expected) == rendered(Oven(kind="hold", power=power, fan=2.0), 3).power


def test_all_components_of_a_kind_move_together() -> None:
    heated = rendered(Oven(kind="heat", power=40.0, fan=2.0, label="mine"), 2)
    assert (round(heated.power, 9), round(heated.fan, 9), heated.label) == (46.0, 4.0, "mine")


def test_a_multiplicative_change_multiplies_the_distance_from_neutral() -> None:
    change = Multiplicative
    assert pytest.approx(0.5 * 1.3) == rendered(Valve(opening=0.5), 3, change=change()).opening
    assert pytest.approx(40 + 10 * 1.3) == rendered(Oven(kind="hold", power=50.0, fan=2.0), 3, change=change()).power
    still = DriveAction(kind="forward", translation=0.0)
    assert rendered(still, 3, change=change()).translation == 0.0


def test_a_vector_grows_along_its_direction_by_the_groups_scale() -> None:
    grown = rendered(Flight(kind="cruise", forward_mps=0.3, left_mps=0.4, up_mps=0.0, yaw_rps=1.5), 4)
    length = 0.5 + 4 * 0.1 * 0.5  # the group's scale is that of its smallest component
    assert pytest.approx((0.6 * length, 0.8 * length, 0.0)) == (grown.forward_mps, grown.left_mps, grown.up_mps)
    assert grown.yaw_rps == 1.5


def test_a_vector_stops_as_a_whole_where_one_component_meets_its_bound() -> None:
    grown = rendered(Flight(kind="cruise", forward_mps=-0.2, left_mps=0.0, up_mps=-0.2), 10)
    assert pytest.approx((-0.25, 0.0, -0.25)) == (grown.forward_mps, grown.left_mps, grown.up_mps)


def test_a_vector_at_its_bound_stays_there() -> None:
    said = Flight(kind="cruise", forward_mps=0.0, left_mps=1.0, up_mps=0.1)
    grown = rendered(said, 5)
    assert (grown.forward_mps, grown.left_mps, grown.up_mps) == (0.0, 1.0, 0.1)


FAINT = [5e-324, -5e-324, 1e-310, -1e-308, 1e-300, -1e-200, 1e-30]


@pytest.mark.parametrize("faint", FAINT)
@pytest.mark.parametrize("others", [(0.0, 0.0), (0.0, 1e-310), (5e-324, 0.0)])
def test_the_faintest_vector_moves_no_further_than_its_level(faint: float, others: tuple[float, float]) -> None:
    said = Flight(kind="cruise", forward_mps=others[0], left_mps=faint, up_mps=others[1])
    grown = rendered(said, 2)
    distance = math.hypot(grown.forward_mps, grown.left_mps, grown.up_mps)
    assert distance <= 2 * 0.1 * 0.5 + 1e-9
    assert math.copysign(1, faint) == math.copysign(1, grown.left_mps)


velocities = st.tuples(st.floats(-0.5, 2.0), st.floats(-1.0, 1.0), st.floats(-0.25, 0.5))


@settings(deadline=None, derandomize=True)
@given(velocities, st.integers(0, 30), st.floats(0.01, 1.0))
def test_a_vector_keeps_its_direction_its_bounds_and_never_shrinks(
    velocity: tuple[float, float, float], number: int, amount: float
) -> None:
    before = math.hypot(*velocity)
    assume(before == 0 or before > 1e-290)  # fainter ones have tests of their own
    said = Flight(kind="cruise", forward_mps=velocity[0], left_mps=velocity[1], up_mps=velocity[2])
    grown = rendered(said, number, amount)
    after = (grown.forward_mps, grown.left_mps, grown.up_mps)
    assert -0.5 <= after[0] <= 2.0
    assert -1.0 <= after[1] <= 1.0
    assert -0.25 <= after[2] <= 0.5
    assert math.hypot(*after) >= before * (1 - 1e-12)
    assert math.hypot(*after) - before <= number * amount * 0.5 + 1e-9
    if before:
        along = sum(a * b / before for a, b in zip(after, velocity, strict=True))
        assert along == pytest.approx(math.hypot(*after), abs=1e-9)


@settings(deadline=None, derandomize=True)
@given(st.sampled_from(DIRECTIONS), st.floats(-1.0, 1.0), st.integers(0, 10**9), st.floats(1e-3, 1e3))
def test_a_component_never_leaves_its_bounds_and_never_goes_backwards(
    declared: tuple[str, str, int], own: float, number: int, amount: float
) -> None:
    kind, name, sign = declared
    said = DriveAction(kind=kind, **{name: own})
    executed = getattr(rendered(said, number, amount), name)
    assert -1.0 <= executed <= 1.0
    assert sign * (executed - own) >= 0
    assert {**said.model_dump(), name: executed} == rendered(said, number, amount).model_dump()


def test_an_action_is_made_by_its_class_and_not_by_a_part() -> None:
    said = DriveAction(kind="left", rotation=0.1)
    executed: Action = rendered(said, 2)
    assert type(executed) is DriveAction
    assert executed is not said
    assert DriveAction.model_validate(executed.model_dump()) == executed


class Shared(Action):
    """Two wheels that share one battery: a rule about both, which bounds cannot say."""

    left: float = component(-1.0, 1.0)
    right: float = component(-1.0, 1.0)
    amplification: ClassVar[AmplificationMap] = {"command": {"left": "+"}}

    @model_validator(mode="after")
    def _battery(self) -> Shared:
        if abs(self.left) + abs(self.right) > 1:
            raise ValueError("more than the battery gives")
        return self


class Unbounded(Action):
    """A component whose sum with its scale is no number any more."""

    force: float = component(scale=1e308)
    amplification: ClassVar[AmplificationMap] = {"command": {"force": "+"}}


@pytest.mark.parametrize("said", [Shared(left=0.5, right=0.4), Unbounded(force=1.7e308)], ids=["rule", "overflow"])
def test_where_the_class_refuses_the_amplified_action_the_tutors_own_executes(said: Action) -> None:
    tutor = ScriptedTutor(act=lambda state: said)
    tutor.action = type(said)
    wrapped = engine(len, level(4), tutor=tutor)
    assert wrapped.step(None) is said
    assert wrapped.pending.resulting.level == 0
    assert len(wrapped.incidents) == 1


class Sums(Action):
    """A class that keeps a sum of its own: the second number follows the first."""

    left: float = component(-1.0, 1.0)
    both: float = component(-9.0, 9.0)
    amplification: ClassVar[AmplificationMap] = {"command": {"left": "outward"}}

    @model_validator(mode="before")
    @classmethod
    def _add_up(cls, values: dict[str, Any]) -> dict[str, Any]:
        return values | {"both": values["left"] * 2}


def test_a_class_that_changes_what_is_not_amplified_is_refused() -> None:
    said = Sums(left=0.25, both=0.5)
    tutor = ScriptedTutor(act=lambda state: said)
    tutor.action = Sums
    wrapped = engine(len, level(3), tutor=tutor, limits=WIDE)
    assert wrapped.step(None) is said
    assert {("action", "mutated"): 1} == wrapped.incident_counts


class Copying(Action):
    """A class whose validator makes a new object of every value, and leaves the value alone."""

    speed: float = component(-1.0, 1.0)
    other: float = component(-1.0, 1.0, default=0.3)
    amplification: ClassVar[AmplificationMap] = {"command": {"speed": "outward"}}

    @field_validator("speed", "other")
    @classmethod
    def _copy(cls, value: float) -> float:
        return float(repr(value))


def test_a_class_that_copies_its_values_is_rendered_like_any_other() -> None:
    assert pytest.approx(0.5) == rendered(Copying(speed=0.2), 3).speed
