from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

import tutorstudent as ts
from tutorstudent_prototype2.calibration import predictive, walks
from tutorstudent_prototype2.calibration.agreement import ENVIRONMENTS, admissible, agrees, misfit
from tutorstudent_prototype2.calibration.choices import CHOICES, NARROW, START, WIDE, move, setting_of
from tutorstudent_prototype2.calibration.freezing import (
    AFTER_ROUNDS,
    Candidate,
    freeze,
    load_candidates,
    most_promising,
    save_candidates,
)
from tutorstudent_prototype2.calibration.places import APART_M, WALL_M, Floor, inside, to_outline_m
from tutorstudent_prototype2.calibration.predictive import (
    PHASES,
    Doubts,
    Prediction,
    cells,
    interval,
    keep_predictions,
    load_predictions,
    predict,
    run_look,
    save_predictions,
)
from tutorstudent_prototype2.calibration.trials import Counts, Limits, run_under
from tutorstudent_prototype2.calibration.walks import (
    Look,
    keep_looks,
    load_looks,
    neighbour,
    save_looks,
    start,
    stays,
    walk_on,
)
from tutorstudent_prototype2.pipelines import load, read_setting
from tutorstudent_prototype2.thesis import prototype2

FREE = Counts(10.0, 0.0, 0.0, 100.0, 0.9, 0.0, True)


def like_the_thesis(scene: str) -> Counts:
    row = prototype2(scene)
    return FREE._replace(attractors=row.attractors, collided=row.collisions)


@pytest.mark.parametrize("stride", [WIDE, NARROW])
def test_every_step_stays_within_the_bounds(stride):
    rng = np.random.default_rng(1)
    choices = dict(START)
    for _ in range(2000):
        choices = move(choices, stride, rng)

        assert all(CHOICES[name].low <= value <= CHOICES[name].high for name, value in choices.items())


def test_walks_reach_all_of_a_range_and_favour_no_part_of_it():
    rng = np.random.default_rng(2)
    choices, seen = dict(START), []
    for _ in range(20_000):
        choices = move(choices, WIDE, rng)
        seen.append(choices["tutor.rotation"])
    low, high = CHOICES["tutor.rotation"].low, CHOICES["tutor.rotation"].high
    share, _ = np.histogram(seen, bins=5, range=(low, high))

    assert share / len(seen) == pytest.approx(np.full(5, 0.2), abs=0.03)


def test_the_start_lies_within_the_bounds_and_names_every_choice():
    assert list(CHOICES) == list(START)
    assert all(CHOICES[name].low <= value <= CHOICES[name].high for name, value in START.items())


@pytest.mark.parametrize("scene", ENVIRONMENTS)
def test_a_setting_is_one_that_tutor_encoder_and_world_take(scene):
    look = neighbour(start(0), 1)

    with load("prototype2a", scene, look.setting()).built() as (engine, world, _):
        assert look.choices["tutor.front_m"] == engine.tutor.options.front_m
        assert look.choices["tutor.prey_m"] == engine.student.options.encoder.options.prey_m
        assert look.choices["world.camera_fov_deg"] == world.options.camera_fov_deg
        assert look.choices["tutor.prey_m"] == world.options.encounter_radius_m


def test_a_stall_report_is_believed_as_soon_as_it_can_be_about_the_present_action():
    delays = {
        (ticks, latency): setting_of({**START, "world.ticks_per_decision": ticks, "world.latency_ticks": latency}, [])[
            "tutor"
        ]["stall_delay"]
        for ticks in (1, 2)
        for latency in (1, 2, 3, 4)
    }

    assert {(1, 1): 2, (1, 2): 3, (1, 3): 4, (1, 4): 5, (2, 1): 1, (2, 2): 2, (2, 3): 2, (2, 4): 3} == delays


SQUARE = [(0.0, 0.0), (15.0, 0.0), (15.0, 15.0), (0.0, 15.0)]
ISLAND = [(5.0, 5.0), (10.0, 5.0), (10.0, 10.0), (5.0, 10.0)]


def test_boxes_stand_on_free_floor_apart_from_each_other():
    floor = Floor([SQUARE, ISLAND], [(1.0, 1.0)], 15.0)
    rng = np.random.default_rng(3)
    places = [(50.0, 20.0), (20.0, 80.0), (80.0, 80.0)]
    for _ in range(50):
        places = floor.move(places, 1 / 6, rng)
        metres = [(x * 0.15, y * 0.15) for x, y in places]

        assert all(min(x, y, 15 - x, 15 - y) > WALL_M - 1e-9 for x, y in metres)
        assert not any(5 - WALL_M < x < 10 + WALL_M and 5 <= y <= 10 for x, y in metres)
        assert all(math.dist(a, b) > APART_M for i, a in enumerate(metres) for b in metres[:i])


def test_inside_and_distance_of_an_island_with_a_bay():
    bay = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 1.0), (0.0, 4.0)]

    assert [True, False, False] == [inside(place, bay) for place in ((0.5, 0.5), (2.0, 3.0), (5.0, 1.0))]
    assert 1.0 == to_outline_m((5.0, 2.0), bay)


@pytest.mark.parametrize("scene", ENVIRONMENTS)
def test_a_run_agrees_within_two_standard_deviations_of_the_thesis_s_runs(scene):
    row = prototype2(scene)
    sd = row.collisions_sd or 1.0
    around = like_the_thesis(scene)

    assert agrees(scene, around)
    assert agrees(scene, around._replace(attractors=row.attractors + 1.99 * row.attractors_sd))
    assert not agrees(scene, around._replace(attractors=row.attractors + 2.01 * row.attractors_sd))
    assert not agrees(scene, around._replace(attractors=row.attractors - 2.01 * row.attractors_sd))
    assert agrees(scene, around._replace(collided=row.collisions + 1.99 * sd))
    assert not agrees(scene, around._replace(collided=row.collisions + 2.01 * sd))


@pytest.mark.parametrize("trapped", [{"way_share": 0.29}, {"longest_stall": 51.0}, {"complete": False}])
def test_a_trapped_robot_is_not_admissible_whatever_it_counted(trapped):
    counts = like_the_thesis("cave-box")._replace(**trapped)

    assert not admissible(counts)
    assert not agrees("cave-box", counts)


def test_misfit_is_zero_for_the_thesis_s_own_means_and_one_for_a_deviation_off():
    rows = {scene: prototype2(scene) for scene in ENVIRONMENTS}
    own = {scene: (row.attractors, row.collisions) for scene, row in rows.items()}
    off = own | {"cave-box": (rows["cave-box"].attractors + rows["cave-box"].attractors_sd, 0.0)}

    assert 0.0 == misfit(own)
    assert 1.0 == pytest.approx(misfit(off))


def test_a_run_is_given_up_once_it_cannot_agree_any_more():
    setting = start(0).setting()
    whole = run_under(setting, "chase-avoid", 5, decisions=400)
    given_up = run_under(setting, "chase-avoid", 5, decisions=400, limits=Limits(attractors=-1.0))

    assert (True, False) == (whole.complete, given_up.complete)
    assert given_up.distance_m < whole.distance_m
    assert 0.0 < whole.way_share <= 1.0


def fake_run(setting, scene, seed, limits):
    """Agree where the forward speed is below 0.1."""
    return like_the_thesis(scene) if setting["tutor"]["translation"] < 0.1 else FREE._replace(complete=False)


def test_an_interrupted_walk_goes_on_as_if_nothing_had_happened(tmp_path, monkeypatch):
    monkeypatch.setattr(walks, "run_under", fake_run)
    whole = [look for round_ in walk_on(tmp_path / "whole", 2, 12, 1) for look in round_]
    list(walk_on(tmp_path / "parts", 2, 5, 1))
    resumed = [look for round_ in walk_on(tmp_path / "parts", 2, 12, 1) for look in round_]

    assert whole == resumed
    assert sorted(whole) == sorted(walks.read_looks(tmp_path / "parts"))
    assert {True, False} == {look.agrees for look in whole}


def test_a_walk_goes_on_from_a_table_of_earlier_days(tmp_path, monkeypatch):
    monkeypatch.setattr(walks, "run_under", fake_run)
    whole = [look for round_ in walk_on(tmp_path / "whole", 2, 6, 1) for look in round_]
    monkeypatch.setattr(walks, "run_under", None)
    keep_looks(tmp_path / "again", whole)

    assert whole == [look for round_ in walk_on(tmp_path / "again", 2, 6, 1) for look in round_]


def test_only_rounds_before_the_freezing_are_candidates():
    looks = [look_at(AFTER_ROUNDS, True), look_at(AFTER_ROUNDS + 1, True), look_at(1, False)]

    assert looks[:1] == most_promising(looks)


def test_a_walk_goes_only_where_prototype_2_agrees(tmp_path, monkeypatch):
    monkeypatch.setattr(walks, "run_under", fake_run)
    here = start(0)
    for (look,) in walk_on(tmp_path, 1, 20, 1):
        assert neighbour(here, look.round).choices == look.choices
        here = look if look.agrees else here


def look_at(round_: int, agreeing: bool) -> Look:
    counts = {scene: like_the_thesis(scene) for scene in ENVIRONMENTS} if agreeing else {"cave-box": FREE}
    return Look(0, round_, dict(START), [(1.0, 2.0)], counts)


def test_a_setting_weighs_as_many_rounds_as_a_walk_stood_on_it():
    looks = [look_at(number, agreeing) for number, agreeing in enumerate([False, True, False, False, True, True], 1)]

    assert [(2, 3), (5, 1), (6, 1)] == [(look.round, rounds) for look, rounds in stays(looks)]


def test_looks_candidates_and_predictions_are_read_as_they_were_written(tmp_path):
    looks = [look_at(1, True), look_at(2, False)]
    candidates = [Candidate(looks[0], {"cave-box": [FREE, FREE]})]
    predictions = [
        Prediction(0, 1, "cave-box", {2500: FREE, 5000: FREE, 7500: FREE._replace(attractors=1.0)}, [2500, 7500])
    ]
    save_looks(tmp_path / "looks", looks)
    save_candidates(tmp_path / "candidates", candidates)
    save_predictions(tmp_path / "predictions", predictions)

    assert looks == load_looks(tmp_path / "looks")
    assert candidates == load_candidates(tmp_path / "candidates")
    assert predictions == load_predictions(tmp_path / "predictions")


def test_a_candidate_that_trapped_a_robot_once_fits_worst():
    free = {scene: [like_the_thesis(scene)] for scene in ENVIRONMENTS}
    trapped = free | {"cave-box": [like_the_thesis("cave-box")._replace(longest_stall=200.0)]}

    assert 0.0 == Candidate(look_at(1, True), free).misfit
    assert math.inf == Candidate(look_at(1, True), trapped).misfit


def test_a_frozen_setting_is_read_as_the_one_that_was_looked_at(tmp_path):
    look = look_at(1, True)
    freeze(Candidate(look, {}), tmp_path / "setting.yaml", 7)

    assert look.setting() == read_setting(tmp_path / "setting.yaml")
    assert "best of 7 settings" in (tmp_path / "setting.yaml").read_text()


def test_predictions_of_earlier_days_are_not_run_again(tmp_path, monkeypatch):
    monkeypatch.setattr(predictive, "run_under", lambda *_, **__: FREE)
    first = sorted(predict(tmp_path / "first", [look_at(1, True)], 1))
    monkeypatch.setattr(predictive, "run_under", None)
    keep_predictions(tmp_path / "second", first)

    assert [(scene, FREE) for scene in sorted(ENVIRONMENTS)] == [(item.scene, item.counts[5000]) for item in first]
    assert first == sorted(predict(tmp_path / "second", [look_at(1, True)], 1))


@pytest.mark.parametrize(
    ("doubted", "run"),
    [([], [2500]), ([2499], [2500]), ([2500], [2500, 5000, 7500]), ([5000, 6000], [2500, 7500]), ([7500], [2500])],
)
def test_a_longer_learning_phase_is_run_where_it_would_have_overruled_an_ampbit(monkeypatch, doubted, run):
    def run_under(setting, scene, seed, pipeline, observers=()):
        for observer in observers:
            for number in range(10_000):
                observer.observe(turn_with(number, ampbit=number not in doubted), None)
        return FREE._replace(attractors=float(pipeline.partition("-")[2] or 2500))

    monkeypatch.setattr(predictive, "run_under", run_under)
    prediction = run_look(look_at(1, True), "cave-box")

    assert run == prediction.run
    assert {phase: float(phase if phase in run else 2500) for phase in PHASES} == {
        phase: counts.attractors for phase, counts in prediction.counts.items()
    }


def turn_with(number: int, ampbit: bool) -> SimpleNamespace:
    decision = SimpleNamespace(moment=SimpleNamespace(number=number), selected=SimpleNamespace(ampbit=ampbit))
    return SimpleNamespace(decision=decision)


class Executed(ts.Observer):
    name = "executed"

    def __init__(self) -> None:
        super().__init__()
        self.actions: list[str] = []

    def observe(self, turn, step) -> None:
        self.actions.append(repr(turn.decision.executed))


def test_where_no_ampbit_was_overruled_a_longer_learning_phase_is_the_same_run():
    doubts = Doubts(500)
    short = executed_with(500, doubts)

    assert not doubts.before(1500)
    assert 1500 == len(short)
    assert short == executed_with(1500)
    assert len(set(short)) > 10


def executed_with(phase: int, *observers: ts.Observer) -> list[str]:
    pipeline = load("prototype2a", "cave-box").replaced({"amplifier.decisions": phase})
    with pipeline.built() as (engine, world, _):
        executed = Executed()
        ts.run(engine, world, 1500, seed=3, observers=[executed, *observers])
        return executed.actions


def test_an_interval_holds_nine_tenths_of_the_weight():
    assert (5.0, 50.0, 95.0) == interval(list(np.arange(1.0, 101.0)), [1.0] * 100)
    assert (7.0, 7.0, 7.0) == interval([1.0, 7.0, 9.0], [0.01, 10.0, 0.01])


def test_cells_are_by_environment_and_learning_phase_and_weighted():
    predictions = [
        Prediction(0, round_, scene, dict.fromkeys(PHASES, FREE._replace(attractors=attractors)), [2500])
        for round_, scene, attractors in ((1, "cave-box", 40.0), (2, "cave-box", 60.0), (2, "chase-avoid", 90.0))
    ]
    found = cells(predictions, {(0, 1): 1, (0, 2): 99}, "attractors")

    assert 60.0 == found["cave-box", 2500].low
    assert 90.0 == found["chase-avoid", 7500].median
