"""Conditions, changes, amplifiers and controls, each by what it says of itself."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.roles.leaves import Condition, condition, encoder
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.core.words.records import Decision, GradedAction, Moment, Outcome
from tutorstudent.plugins.amplifiers import LearningPhase, Never
from tutorstudent.plugins.changes import Additive, Multiplicative
from tutorstudent.plugins.conditions import AllOf, AnyOf, Bumped, Near, Not
from tutorstudent.plugins.controls import Blind, Constant, Ramp, Random, Silent
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.sims.pioneer.types import DriveAction, PioneerState

FORWARD = DriveAction(kind="forward", translation=0.2)


def state(nearest_m: float = 2.0, stalled: bool = False) -> PioneerState:
    sonar = np.full(16, 2.0)
    sonar[3] = nearest_m
    return PioneerState(sonar, (), stalled)


@condition("free")
def Free(sensed: PioneerState) -> bool:
    return False


def moment(action: DriveAction = FORWARD, sensed: PioneerState | None = None) -> Moment[Any, Any]:
    return Moment(0, sensed or state(), action, "")


def bound(part: Any) -> Any:
    part.bind(Binding(5, "student", DriveAction))
    return part


def test_bumped_is_what_the_robot_reports() -> None:
    assert [True, False] == [Bumped().violated(state(stalled=stalled)) for stalled in (True, False)]
    assert [2.0] * 16 == Bumped().margins(state())
    assert [2.0, 2.0, 2.0, 0.0] == Bumped().margins(state(0.06, stalled=True))[:4]  # 0 where it is violated


def test_near_has_a_margin_that_is_zero_where_it_begins_to_be_violated() -> None:
    near = Near(clearance_m=0.5)
    for metres in (0.2, 0.49, 0.5, 0.51, 2.0):
        assert near.violated(state(metres)) == (min(near.margins(state(metres))) < 0)


def test_composed_conditions_say_what_their_parts_say() -> None:
    for stalled in (True, False):
        for metres in (0.1, 1.0):
            sensed = state(metres, stalled)
            near = metres < 0.5
            parts = [Bumped(), Near(clearance_m=0.5)]
            assert (stalled or near) == AnyOf(of=parts).violated(sensed)
            assert (stalled and near) == AllOf(of=parts).violated(sensed)
            assert (not near) == Not(of=Near(clearance_m=0.5)).violated(sensed)


def test_composed_conditions_are_labelled_by_their_parts() -> None:
    assert "any-of(bumped, not(near))" == AnyOf(of=[Bumped(), Not(of=Near())]).label


def test_composed_margins() -> None:
    near, far = Near(clearance_m=0.5), Near(clearance_m=1.5)
    sensed = state(1.0)
    assert [*near.margins(sensed), *far.margins(sensed)] == AnyOf(
        of=[Near(clearance_m=0.5), Near(clearance_m=1.5)]
    ).margins(sensed)
    assert [0.5] == AllOf(of=[Near(clearance_m=0.5), Near(clearance_m=1.5)]).margins(sensed)
    assert [2.0] * 3 == AnyOf(of=[Bumped()]).margins(sensed)[:3]
    assert AnyOf(of=[Free()]).margins(sensed) is None
    assert AllOf(of=[Free(), Near()]).margins(sensed) is None


def test_all_parts_are_asked_since_conditions_may_have_a_memory() -> None:
    asked: list[str] = []

    def made(name: str) -> Condition[Any]:
        @condition(name)
        def remember(_: Any) -> bool:
            asked.append(name)
            return True

        return remember()

    AnyOf(of=[made("one"), made("two")]).violated(state())
    assert ["one", "two"] == asked


def test_a_composed_condition_needs_parts() -> None:
    with pytest.raises(PipelineError, match="condition 'any-of': option 'of': list should have at least 1 item"):
        AnyOf(of=[])
    with pytest.raises(PipelineError, match="condition 'not': option 'of' must be a part"):
        Not(of="bumped")


@pytest.mark.parametrize("magnitude", [0.0, 0.1, 0.7])
@pytest.mark.parametrize("amplification", [0.0, 0.1, 0.8])
def test_changes(amplification: float, magnitude: float) -> None:
    assert amplification == Additive().fraction(amplification, magnitude)
    assert amplification * magnitude == Multiplicative().fraction(amplification, magnitude)


@pytest.mark.parametrize("ampbit", [True, False])
@pytest.mark.parametrize("number", [0, 2499, 2500, 9999])
@pytest.mark.parametrize("kind", ["forward", "backward", "left", "right", "stop"])
def test_learning_phase_raises_by_one_within_the_phase_or_with_the_ampbit(ampbit: bool, number: int, kind: str) -> None:
    selected = GradedAction(DriveAction(kind=kind), 3, ampbit)
    raised = kind != "stop" and (ampbit or number < 2500)
    assert selected._replace(level=3 + raised) == LearningPhase().amplify(selected, number)
    assert selected is Never().amplify(selected, number)


def test_learning_phase_holds_where_it_is_told_to() -> None:
    amplifier = LearningPhase(hold_at=7)
    assert [7, 7] == [amplifier.amplify(GradedAction(FORWARD, level, True), 0).level for level in (6, 7)]


def test_silent_and_constant_always_say_the_same() -> None:
    assert [(0, True)] * 3 == [(p.level, p.ampbit) for p in (bound(Silent()).propose(moment()) for _ in range(3))]
    constant = bound(Constant(level=5))
    assert [5] * 3 == [constant.propose(moment()).level for _ in range(3)]


def test_random_draws_every_level_and_repeats_with_its_seed() -> None:
    one, other = bound(Random(max_level=4)), bound(Random(max_level=4))
    drawn = [one.propose(moment()).level for _ in range(300)]
    assert set(range(5)) == set(drawn)
    assert drawn == [other.propose(moment()).level for _ in range(300)]


def test_ramp_climbs_while_kind_and_inputs_stay_and_begins_again_at_one() -> None:
    @encoder("nearest", 1)
    def nearest(asked: Moment[Any, Any]) -> list[float]:
        return [float(asked.state.sonar_m.min())]

    ramp = bound(Ramp(encoder=nearest(), max_level=3))
    left = DriveAction(kind="left", rotation=0.2)
    asked = [moment()] * 5 + [moment(left)] * 2 + [moment(left, state(0.5))] + [moment()]
    assert [1, 2, 3, 3, 3, 1, 2, 1, 1] == [ramp.propose(item).level for item in asked]
    ramp.reset()
    assert 1 == ramp.propose(moment()).level


def test_ramp_without_an_encoder_looks_at_the_kind_only() -> None:
    ramp = bound(Ramp())
    assert [1, 2, 3] == [ramp.propose(moment(sensed=state(metres))).level for metres in (0.1, 0.5, 1.0)]


def test_blind_teaches_success_whatever_happened() -> None:
    selected, resulting = GradedAction(FORWARD, 2, True), GradedAction(FORWARD, 3, True)
    decision = Decision(moment(), selected, resulting, FORWARD, None)
    outcome = Outcome(state(stalled=True), ("bumped",), {"near": (0.1,)}, {"near": (0.0,)})
    blind, sighted = Blind().evaluate(decision, outcome), Conditions().evaluate(decision, outcome)
    assert blind is not None
    assert sighted is not None
    assert ((3, True), (2, False)) == (blind.target[1:], sighted.target[1:])
    assert ((), None, {}) == (blind.outcome.violated, blind.outcome.margins_before, dict(blind.outcome.margins))


def test_a_bump_within_the_decision_counts_though_the_newest_report_is_free() -> None:
    assert Bumped().violated(replace(state(), bumped=True))


@pytest.mark.parametrize("margins", [True, False])
def test_a_blind_evaluator_hides_violations_and_margins_unless_they_are_to_stay(margins: bool) -> None:
    decision = Decision(moment(), *(GradedAction(FORWARD, level, True) for level in (1, 2)), FORWARD, None)
    outcome = Outcome(state(), ("bumped",), {"bumped": (1.0,)}, {"bumped": (0.0,)})
    lesson = Blind(margins=margins).evaluate(decision, outcome)
    assert lesson is not None
    assert () == lesson.outcome.violated
    seen = ({"bumped": (1.0,)}, {"bumped": (0.0,)}) if margins else (None, {})
    assert seen == (lesson.outcome.margins_before, lesson.outcome.margins)
