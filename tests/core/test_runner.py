"""The loop: trials end, last states are judged, cut-off decisions are dropped."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import pytest

from tests.core.toys import PIPELINE, Push, Pusher, Rail, toy_registry
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.core.roles.binding import Binding
from tutorstudent.core.roles.world import Step
from tutorstudent.core.running.meter import WorldEvents
from tutorstudent.core.running.observers import Begin, Entries, Observer, Tally
from tutorstudent.core.running.runner import check_world, make_trial_seed, run
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.turn import Turn

REGISTRY = toy_registry()


class Witness(Observer):
    name = "witness"

    def __init__(self) -> None:
        super().__init__()
        self.seen: list[tuple[Turn[Any, Any], Step[Any]]] = []

    def observe(self, turn: Turn[Any, Any], step: Step[Any]) -> None:
        self.seen.append((turn, step))


def ran(decisions: int, **world: Any) -> tuple[Any, list[tuple[Turn[Any, Any], Step[Any]]]]:
    pipeline = Pipeline(parse_yaml(PIPELINE, "p.yaml"), REGISTRY)
    engine, witness = pipeline.engine(), Witness()
    rail = Rail(**world)
    rail.bind(Binding(1, "world", Push))
    run(engine, rail, decisions, seed=1, observers=[witness])
    return engine, witness.seen


def test_a_crash_in_the_last_state_of_an_episode_is_taught() -> None:
    _, seen = ran(60, length_m=5.0)
    ends = [turn for turn, step in seen if step.done]
    assert ends
    for turn in ends:
        assert ("crashed",) == turn.outcome.violated
        assert turn.lesson is not None
        assert turn.lesson.target.ampbit is False
        assert turn.lesson.outcome.state > 5.0


def test_a_decision_that_was_cut_off_teaches_nothing() -> None:
    _, seen = ran(20, patience=4)
    cut = [turn for turn, step in seen if step.truncated]
    assert 5 == len(cut)
    assert all(turn.lesson is None and turn.outcome is None and turn.void == "dropped" for turn in cut)


def test_no_lesson_crosses_a_trial() -> None:
    _, seen = ran(60, length_m=2.0)
    firsts = [after for (_, before), (after, _) in pairwise(seen) if before.done]
    assert firsts
    for turn in firsts:
        assert turn.decision.moment.state < 1.0
        assert turn.outcome.margins_before is None


def test_every_decision_is_seen_once_and_in_order() -> None:
    engine, seen = ran(30, length_m=2.0)
    assert list(range(30)) == [turn.decision.moment.number for turn, _ in seen]
    assert 30 == engine.decisions


def test_trials_differ_and_runs_repeat() -> None:
    starts = {make_trial_seed(7, trial) for trial in range(50)}
    assert 50 == len(starts)
    one, other = ran(40, length_m=2.0)[1], ran(40, length_m=2.0)[1]
    assert [turn.decision.executed for turn, _ in one] == [turn.decision.executed for turn, _ in other]


def test_a_world_of_other_actions_is_refused() -> None:
    pipeline = Pipeline(parse_yaml(PIPELINE, "p.yaml"), REGISTRY)
    rail = Rail()
    rail.action = type("Other", (Push,), {})
    with pytest.raises(ContractError, match="world 'rail' executes Other but tutor 'pusher' returns Push"):
        run(pipeline.engine(), rail, 1)


def test_observers_count_what_the_loop_did() -> None:
    pipeline = Pipeline(parse_yaml(PIPELINE, "p.yaml"), REGISTRY)
    engine, rail, tally, events, witness = pipeline.engine(), Rail(), Tally(), WorldEvents(), Witness()
    run(engine, rail, 60, seed=1, observers=[tally, events, witness])
    turns = [turn for turn, _ in witness.seen]
    summary = dict(tally.summary())
    assert 60 == summary["decisions"]
    assert sum(turn.decision.amplified for turn in turns) == summary["amplified"]
    assert sum(turn.decision.resulting.level for turn in turns) / 60 == summary["mean_level"]
    assert sum("crashed" in turn.outcome.violated for turn in turns) == summary["violated:crashed"]
    assert 1.0 == summary["share:pushing"]
    values = dict(events.summary())
    assert sum(step.events["distance_m"] for _, step in witness.seen) == pytest.approx(values["distance_m"])
    assert max(step.events["speed"] for _, step in witness.seen) == values["speed"]
    assert sum(step.events["force"] for _, step in witness.seen) / 60 == pytest.approx(values["force"])
    assert witness.seen[-1][1].events["x_m"] == values["x_m"]


def test_entries_count_each_time_a_situation_begins() -> None:
    class Spins(Entries):
        name = "spins"
        situation = "spin"
        counted = "spins"

    spins = Spins()
    spins.begin(Begin(None, None, 0))  # type: ignore[arg-type]
    _, seen = ran(1)
    turn, _ = seen[0]
    counts = []
    for situation, done in [("spin", 0), ("spin", 0), ("", 0), ("spin", 1), ("spin", 0)]:
        moment = turn.decision.moment._replace(situation=situation)
        seen_now = Turn(turn.decision._replace(moment=moment))
        counts.append(spins.observe(seen_now, Step(0.0, {}, bool(done)))["spins"])
    assert [1, 0, 0, 1, 1] == counts
    assert {"spins": 3.0} == dict(spins.summary())


def test_a_second_run_begins_a_new_trial_and_keeps_what_was_learned() -> None:
    resets = []

    class Remembering(Pusher):
        def reset(self) -> None:
            resets.append(1)

    pipeline = Pipeline(parse_yaml(PIPELINE, "p.yaml"), REGISTRY)
    engine = pipeline.engine(tutor=Remembering())
    run(engine, Rail(), 5, seed=1)
    learned = dict(engine.state_dict())
    run(engine, Rail(), 5, seed=1)
    assert 2 == len(resets)
    assert 10 == engine.decisions
    assert learned.keys() <= engine.state_dict().keys()


def test_a_world_whose_goal_is_none_of_its_events_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Rail, "goal_event", "distance")
    with pytest.raises(
        ContractError,
        match=r"world 'rail': goal_event is 'distance', which is none of its events \(did you mean 'distance_m'\?\)\. "
        r"Events: collided, distance_m, .*leave goal_event empty",
    ):
        check_world(Pipeline(parse_yaml(PIPELINE, "p.yaml"), toy_registry()).engine(), Rail())
