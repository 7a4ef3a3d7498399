"""Each rule of prototype 2 by name: a state that fires it, and one that just does not."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from tutorstudent.core.roles.binding import Binding
from tutorstudent.plugins.prototype2 import Prototype2
from tutorstudent.plugins.prototype2.rules import RULES
from tutorstudent.sims.pioneer.types import Blob, DriveAction, PioneerState


def sense(
    front: float = 5.0,
    left: float = 5.0,
    right: float = 5.0,
    back: float = 5.0,
    red: tuple[float, float] | None = None,
    blue: tuple[float, float] | None = None,
    stalled: bool = False,
) -> PioneerState:
    """Return a state with these clearances (m) and with things at (distance m, bearing rad)."""
    ranges = np.full(16, 5.0)
    ranges[[0, 1]], ranges[[2, 3, 4, 5]], ranges[[6, 7]], ranges[10:14] = left, front, right, back
    ranges.setflags(write=False)
    seen = [Blob(colour, at[1], at[0], 0.1) for colour, at in (("red", red), ("blue", blue)) if at]
    return PioneerState(ranges, tuple(seen), stalled)


FREE = sense()
STALL = sense(stalled=True)
PREY = sense(red=(0.94, 0.5))
PREDATOR = sense(blue=(0.39, 0.5))
BLOCKED = sense(front=0.29, left=1.0)

START: tuple[PioneerState, ...] = ()
AVOIDING = (BLOCKED,)
DRIVING = (BLOCKED, FREE)
FLEEING = (PREY,)
ESCAPING = (PREDATOR,)
ALWAYS = None

SUBSUMPTION, FORWARD, AVOID, PREY_SPIN, PREDATOR_SPIN = RULES


class Case(NamedTuple):
    """Where the planner stands, the rule, what fires it, what it does, and what just does not fire it."""

    state: str
    rule: str
    before: tuple[PioneerState, ...]
    fires: PioneerState
    kind: str
    situation: str
    just_not: PioneerState | None


def recovering(before: tuple[PioneerState, ...]) -> tuple[PioneerState, ...]:
    return (*before, STALL)


CASES = [
    Case(SUBSUMPTION, "avoid: recover from a stall", START, STALL, "backward", AVOID, FREE),
    Case(SUBSUMPTION, "avoid: obstacle ahead", START, BLOCKED, "right", AVOID, sense(front=0.3, left=1.0)),
    Case(SUBSUMPTION, "avoid: obstacle ahead", START, sense(front=0.29, right=1.0), "left", AVOID, sense(front=0.3)),
    Case(SUBSUMPTION, "avoid: obstacle beside", START, sense(left=0.09), "right", AVOID, sense(left=0.1)),
    Case(SUBSUMPTION, "avoid: obstacle beside", START, sense(right=0.09), "left", AVOID, sense(right=0.1)),
    Case(SUBSUMPTION, "avoid: predator near", START, PREDATOR, "right", PREDATOR_SPIN, sense(blue=(0.4, 0.5))),
    Case(SUBSUMPTION, "avoid: predator near", START, sense(blue=(0.3, -0.1)), "left", PREDATOR_SPIN, FREE),
    Case(SUBSUMPTION, "flee: prey near", START, PREY, "right", PREY_SPIN, sense(red=(0.95, 0.5))),
    Case(SUBSUMPTION, "flee: prey near", START, sense(red=(0.94, -0.1)), "left", PREY_SPIN, sense(red=(0.95, -0.1))),
    Case(SUBSUMPTION, "seek: prey to the left", START, sense(red=(3, 0.16)), "left", SUBSUMPTION, sense(red=(3, 0.15))),
    Case(
        SUBSUMPTION,
        "seek: prey to the right",
        START,
        sense(red=(3, -0.16)),
        "right",
        SUBSUMPTION,
        sense(red=(3, -0.15)),
    ),
    Case(SUBSUMPTION, "seek: prey ahead", START, sense(red=(3, 0.15)), "forward", SUBSUMPTION, FREE),
    Case(SUBSUMPTION, "wander: little space ahead", START, sense(front=0.79), "right", AVOID, sense(front=0.8)),
    Case(SUBSUMPTION, "wander: forward", START, FREE, "forward", SUBSUMPTION, ALWAYS),
    Case(FORWARD, "recover from a stall", DRIVING, STALL, "backward", AVOID, FREE),
    Case(FORWARD, "drive on", DRIVING, FREE, "forward", FORWARD, ALWAYS),
    Case(FORWARD, "drive on", DRIVING, PREY, "forward", FORWARD, ALWAYS),
    Case(FORWARD, "drive on", DRIVING, sense(front=0.3, left=0.1, right=0.1), "forward", FORWARD, BLOCKED),
    Case(AVOID, "recover from a stall", AVOIDING, STALL, "forward", AVOID, FREE),
    Case(AVOID, "recover from a stall", AVOIDING, sense(0.2, back=0.21, stalled=True), "backward", AVOID, FREE),
    Case(AVOID, "keep recovering", recovering(AVOIDING), FREE, "forward", AVOID, ALWAYS),
    Case(AVOID, "way is clear", AVOIDING, sense(front=0.8, left=0.1, right=0.1), "forward", FORWARD, sense(front=0.79)),
    Case(AVOID, "way is clear", AVOIDING, sense(blue=(0.4, 0.0)), "forward", FORWARD, PREDATOR),
    Case(AVOID, "way is clear", AVOIDING, FREE, "forward", FORWARD, sense(left=0.09)),
    Case(AVOID, "keep spinning", AVOIDING, sense(front=0.79), "right", AVOID, FREE),
    Case(PREY_SPIN, "recover from a stall", FLEEING, STALL, "forward", PREY_SPIN, FREE),
    Case(PREY_SPIN, "keep recovering", recovering(FLEEING), FREE, "forward", PREY_SPIN, ALWAYS),
    Case(PREY_SPIN, "prey lost", FLEEING, sense(front=0.3), "forward", FORWARD, sense(front=0.29)),
    Case(PREY_SPIN, "prey lost", FLEEING, PREDATOR, "forward", FORWARD, sense(red=(7.9, 1.0))),
    Case(PREY_SPIN, "keep spinning", FLEEING, sense(red=(7.9, -1.0)), "right", PREY_SPIN, FREE),
    Case(PREDATOR_SPIN, "recover from a stall", ESCAPING, STALL, "forward", PREDATOR_SPIN, FREE),
    Case(PREDATOR_SPIN, "keep recovering", recovering(ESCAPING), FREE, "forward", PREDATOR_SPIN, ALWAYS),
    Case(PREDATOR_SPIN, "predator lost", ESCAPING, sense(front=0.3), "forward", FORWARD, sense(front=0.29)),
    Case(PREDATOR_SPIN, "predator lost", ESCAPING, PREY, "forward", FORWARD, sense(blue=(7.9, 1.0))),
    Case(PREDATOR_SPIN, "keep spinning", ESCAPING, sense(blue=(7.9, -1.0)), "right", PREDATOR_SPIN, FREE),
]
TESTED_BELOW = {
    (FORWARD, "obstacle close"),
    (FORWARD, "predator near"),
    (FORWARD, "arrived"),
    (AVOID, "spun enough"),
    (PREY_SPIN, "spun enough"),
    (PREDATOR_SPIN, "spun enough"),
    (SUBSUMPTION, "wander: turn to an open area"),
    (SUBSUMPTION, "wander: turn on to an open area"),
}


def tutor(**options: object) -> Prototype2:
    """Return a tutor that does what the rules name, without chance."""
    made = Prototype2(**{"recover_random": 0.0, "wander_turn": 0.0, **options})
    made.bind(Binding(seed=7, slot="tutor", action=DriveAction))
    made.reset()
    return made


def after(before: tuple[PioneerState, ...], **options: object) -> Prototype2:
    made = tutor(**options)
    for state in before:
        made.act(state)
    return made


def test_every_rule_has_a_case() -> None:
    table = {(state, rule.name) for state, rules in RULES.items() for rule in rules}
    assert {(case.state, case.rule) for case in CASES} | TESTED_BELOW == table


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case.state}: {case.rule}")
def test_the_rule_fires_where_it_should(case: Case) -> None:
    made = after(case.before)
    assert made.situation == case.state
    action = made.act(case.fires)
    assert (made.rule, action.kind, made.situation) == (case.rule, case.kind, case.situation)


@pytest.mark.parametrize(
    "case", [case for case in CASES if case.just_not], ids=lambda case: f"{case.state}: {case.rule}"
)
def test_the_rule_does_not_fire_where_it_just_should_not(case: Case) -> None:
    made = after(case.before)
    assert case.just_not is not None
    made.act(case.just_not)
    assert made.rule != case.rule


@pytest.mark.parametrize(
    ("now", "kind", "situation", "rule"),
    [
        (BLOCKED, "right", AVOID, "avoid: obstacle ahead"),
        (sense(left=0.09), "right", AVOID, "avoid: obstacle beside"),
        (PREDATOR, "right", PREDATOR_SPIN, "avoid: predator near"),
    ],
)
def test_forward_leaves_a_danger_to_subsumption_in_the_same_decision(
    now: PioneerState, kind: str, situation: str, rule: str
) -> None:
    made = after(DRIVING)
    action = made.act(now)
    assert (action.kind, made.situation, made.rule) == (kind, situation, rule)


@pytest.mark.parametrize(("before", "decisions"), [(AVOIDING, 10), (FLEEING, 3), (ESCAPING, 3)])
def test_forward_lasts_as_many_decisions_as_its_spin_asked_for(
    before: tuple[PioneerState, ...], decisions: int
) -> None:
    made = after(before)
    situations = []
    for _ in range(decisions + 1):
        made.act(FREE)
        situations.append(made.situation)
    assert situations == [FORWARD] * decisions + [SUBSUMPTION]


@pytest.mark.parametrize(
    ("before", "forever"),
    [(AVOIDING, sense(front=0.31)), (FLEEING, sense(red=(0.5, 0.0))), (ESCAPING, sense(blue=(0.5, 0.0)))],
)
def test_a_spin_that_has_lasted_long_ends_where_there_is_any_way_ahead(
    before: tuple[PioneerState, ...], forever: PioneerState
) -> None:
    made = after(before, spin_limit=20)
    rules = []
    for _ in range(21):
        made.act(forever)
        rules.append(made.rule)
    assert rules == ["keep spinning"] * 20 + ["spun enough"]


def test_a_spin_that_has_lasted_long_goes_on_where_there_is_no_way_ahead() -> None:
    made = after(AVOIDING, spin_limit=20)
    kinds = {made.act(sense(front=0.14)).kind for _ in range(100)}
    assert (kinds, made.rule) == ({"right"}, "keep spinning")


def gap(view_m: float) -> PioneerState:
    """Return a state with a narrow way ahead through which the robot can look that far."""
    seen = sense(front=0.35)
    ranges = seen.sonar_m.copy()
    ranges[[3, 4]] = view_m
    return PioneerState(ranges, (), False)


def test_a_spin_that_has_lasted_long_ends_where_the_robot_can_look_out_farthest() -> None:
    made = after(AVOIDING, spin_limit=20)
    for view_m in [1.0] * 10 + [4.0] + [1.0] * 12:
        made.act(gap(view_m))
    assert made.rule == "keep spinning"
    assert (made.act(gap(3.9)).kind, made.rule, made.situation) == ("forward", "spun enough", FORWARD)


def test_the_longer_a_spin_lasts_the_shorter_a_view_will_do() -> None:
    made = after(AVOIDING, spin_limit=20)
    made.act(gap(4.0))
    turns = 0
    while made.situation == AVOID:
        made.act(gap(2.0))
        turns += 1
    assert turns == 2 * 20


BREAKING_OUT = (BLOCKED, *[sense(front=0.31)] * 6)


@pytest.mark.parametrize(
    ("now", "rule"),
    [
        (sense(front=0.15, left=0.05, right=0.05), "drive on"),
        (PREDATOR, "drive on"),
        (sense(front=0.149), "avoid: obstacle ahead"),
        (sense(left=0.049), "avoid: obstacle beside"),
        (STALL, "recover from a stall"),
    ],
)
def test_a_robot_that_breaks_out_passes_predators_and_keeps_half_the_clearance(now: PioneerState, rule: str) -> None:
    made = after(BREAKING_OUT, spin_limit=5)
    assert (made.situation, made.rule) == (FORWARD, "spun enough")
    made.act(now)
    assert made.rule == rule


def test_breaking_out_lasts_30_decisions_and_is_over_then() -> None:
    made = after(BREAKING_OUT, spin_limit=5)
    rules = [(made.act(FREE), made.rule)[1] for _ in range(30)]
    assert rules == ["drive on"] * 29 + ["wander: forward"]
    for state in DRIVING:
        made.act(state)
    made.act(sense(front=0.29))
    assert made.situation == AVOID


def test_a_restless_robot_turns_to_the_open_side_for_a_while_until_an_obstacle_ends_the_turn() -> None:
    made = tutor(wander_turn=1.0, turn_max=1000)
    open_left = sense(right=1.2)
    assert (made.act(open_left).kind, made.rule) == ("left", "wander: turn to an open area")
    assert (made.act(sense(left=1.2)).kind, made.rule) == ("left", "wander: turn on to an open area")
    made.act(BLOCKED)
    assert made.rule == "avoid: obstacle ahead"
    rules = [(made.act(sense(left=1.4, right=1.4)), made.rule)[1] for _ in range(11)]
    assert rules == ["way is clear", *["drive on"] * 9, "wander: turn to an open area"]


def test_a_restless_robot_does_not_turn_where_no_side_is_open() -> None:
    made = tutor(wander_turn=1.0)
    made.act(sense(front=1.4, left=1.5, right=1.5))
    assert made.rule == "wander: forward"


def test_without_restlessness_a_wandering_robot_drives_straight_on() -> None:
    made = tutor(wander_turn=0.0)
    assert {made.act(FREE).kind for _ in range(500)} == {"forward"}
