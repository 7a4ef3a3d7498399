"""The loop that joins an engine and a world: the only one in the package."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.roles.world import World
from tutorstudent.core.running.meter import Meter
from tutorstudent.core.running.observers import Begin, Observer
from tutorstudent.core.running.whereabouts import BEGIN, DECIDE, OBSERVE, Whereabouts
from tutorstudent.core.running.world_seat import WorldSeat, check_methods
from tutorstudent.core.words.actions import Action
from tutorstudent.core.words.errors import ContractError, list_names, suggest


def make_trial_seed(seed: int, trial: int) -> int:
    """Return the seed of a trial: another one for each trial of a run, the same whenever the run is repeated.

    >>> make_trial_seed(7, 0) == make_trial_seed(7, 0), make_trial_seed(7, 0) == make_trial_seed(7, 1)
    (True, False)
    """
    return int(np.random.SeedSequence([seed, trial]).generate_state(1)[0])


def run(
    engine: Engine[Any, Any, Any],
    world: World[Any, Any],
    decisions: int,
    *,
    seed: int = 0,
    observers: Sequence[Observer] = (),
) -> dict[str, float]:
    """Run the loop for `decisions` decisions, over as many trials as it takes.

    The engine keeps what it has learned before and begins a new trial. When a trial is done, its last state is judged
    too (a crash often shows only there); when it was cut off, it is not.

    Returns:
        What the observers measured, summed up, and what they counted by themselves, by name.

    Raises:
        ContractError: if the world does not execute the tutor's actions, or an observer measures what is no number or
            not declared.
    """
    check_world(engine, world)
    meter = Meter(observers)
    run_loop(engine, world, decisions, seed, meter, Whereabouts())
    return meter.summary()


def run_loop(
    engine: Engine[Any, Any, Any], world: World[Any, Any], decisions: int, seed: int, meter: Meter, at: Whereabouts
) -> None:
    """Run the loop, show every decision to the meter, and note down where it is.

    Whatever ends it, the meter has seen every decision that is complete.
    """
    at.begin_decision(0)
    at.enter(BEGIN)
    meter.begin(Begin(engine, world, decisions))
    trial, seat = 0, WorldSeat(world, at)
    at.enter(DECIDE)
    engine.reset()
    state = seat.reset(make_trial_seed(seed, trial))
    for number in range(decisions):
        at.begin_decision(number)
        at.enter(DECIDE)
        step = seat.step(engine.propagate(state))
        at.enter(DECIDE)
        if step.truncated and not step.done:
            engine.drop()
        else:
            engine.evaluate(step.state)
        turn = engine.last
        if turn is None:
            raise ContractError("run(): the engine has no turn to show; it was reset from inside the loop.")
        at.enter(OBSERVE)
        meter.observe(turn, step)
        state = step.state
        if step.done or step.truncated:
            trial += 1
            at.begin_decision(number + 1)
            at.enter(DECIDE)
            engine.reset()
            state = seat.reset(make_trial_seed(seed, trial))


def _describe_class(action: type[Action]) -> tuple[object, ...]:
    vocabulary = action.vocabulary
    return action.__name__, vocabulary.kinds, dict(vocabulary.components), dict(vocabulary.groups)


def check_world(engine: Engine[Any, Any, Any], world: World[Any, Any]) -> None:
    """Refuse a world that does not execute the tutor's actions, or whose goal is none of its events."""
    check_methods(world)
    ours, theirs = engine.tutor.action, world.action
    if not issubclass(ours, theirs):
        if _describe_class(ours) == _describe_class(theirs):
            raise ContractError(
                f"world '{world.name}' and tutor '{engine.tutor.name}' have two action classes of the same form, both "
                f"called {theirs.__name__}. Each call of ts.scalar() or ts.vector() makes a class of its own: "
                "make it once, and use that one in both."
            )
        raise ContractError(
            f"world '{world.name}' executes {theirs.__name__} but tutor '{engine.tutor.name}' "
            f"returns {ours.__name__}. Use a tutor and a world of one action class."
        )
    if world.goal_event and world.goal_event not in world.event_names:
        near = suggest(world.goal_event, world.event_names)
        raise ContractError(
            f"world '{world.name}': goal_event is '{world.goal_event}', which is none of its events{near}. "
            f"Events: {list_names(world.event_names)}. Name one of them, or leave goal_event empty."
        )
