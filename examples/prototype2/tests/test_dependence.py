from __future__ import annotations

import math

import pytest

from tutorstudent_prototype2.calibration.agreement import ENVIRONMENTS
from tutorstudent_prototype2.calibration.choices import CHOICES, START
from tutorstudent_prototype2.calibration.dependence import Case, correlations, learner_cases, tutor_cases
from tutorstudent_prototype2.calibration.freezing import Candidate, save_candidates
from tutorstudent_prototype2.calibration.predictive import PHASES, Prediction, save_predictions
from tutorstudent_prototype2.calibration.summary import describe
from tutorstudent_prototype2.calibration.trials import Counts
from tutorstudent_prototype2.calibration.walks import Look, save_looks
from tutorstudent_prototype2.thesis import prototype2

SCENES = tuple(f"| {scene} |" for scene in ENVIRONMENTS)


def counted(attractors: float, collided: float = 0.0) -> Counts:
    return Counts(attractors, collided, 0.0, 100.0, 0.9, 0.0, True)


def look_at(round_: int, agreeing: bool = True) -> Look:
    choices = dict(START) | {"tutor.translation": (5 + round_) / 100}
    counts = {scene: counted(prototype2(scene).attractors, prototype2(scene).collisions) for scene in ENVIRONMENTS}
    return Look(0, round_, choices, [(1.0, 2.0)], counts if agreeing else {"cave-box": counted(1000.0)})


@pytest.mark.parametrize(("power", "expected"), [(1, 1.0), (3, 1.0), (-1, -1.0)])
def test_a_monotone_dependence_has_a_rank_correlation_of_one(power, expected):
    cases = [Case(look_at(number).choices, counted((number + 1.0) ** power)) for number in range(6)]

    assert expected == pytest.approx(correlations(cases, "attractors")["tutor.translation"])


def test_what_never_varies_has_no_correlation():
    cases = [Case(look_at(number).choices, counted(float(number))) for number in range(6)]

    assert math.isnan(correlations(cases, "attractors")["prey.turn"])
    assert math.isnan(correlations(cases, "collided")["tutor.translation"])


def test_only_settings_that_agree_are_cases_and_each_prediction_finds_its_choices():
    looks = [look_at(1), look_at(2, agreeing=False), look_at(3)]
    prediction = Prediction(0, 3, "cave-box", dict.fromkeys(PHASES, counted(50.0)), [2500])

    assert [0.06, 0.08] == [case.choices["tutor.translation"] for case in tutor_cases(looks, "cave-box")]
    assert [Case(looks[2].choices, counted(50.0))] == learner_cases(looks, [prediction], "cave-box")
    assert [] == learner_cases(looks, [prediction], "chase-avoid")


@pytest.fixture
def shown(tmp_path) -> str:
    looks = [look_at(1), look_at(2, agreeing=False), look_at(3)]
    predictions = [
        Prediction(0, number, scene, dict.fromkeys(PHASES, counted(10.0 * number, 4.4)), [2500, 7500])
        for number in (1, 3)
        for scene in ENVIRONMENTS
    ]
    save_looks(tmp_path / "looks", looks)
    save_candidates(tmp_path / "candidates", [Candidate(looks[0], {scene: [counted(7)] for scene in ENVIRONMENTS})])
    save_predictions(tmp_path / "predictions", predictions)
    return "\n".join(describe(tmp_path / "looks", tmp_path / "candidates", tmp_path / "predictions"))


def test_what_is_shown_says_how_many_were_looked_at_and_which_is_frozen(shown):
    assert "3 settings looked at, 2 agree with prototype 2's rows. Spoken against by: cave-box 1." in shown
    assert "| tutor.translation | 0.05 to 0.25 | 0.06 | 0.06 to 0.08 (0.06) |" in shown


def test_every_cell_of_the_thesis_has_its_interval_with_its_width(shown):
    assert "under each of 2 settings that agree" in shown
    assert "Of the 16 with a longer learning phase 8 differ" in shown
    assert "| cave-box | 2500 | 41.6 | 10 to 30 | 20 | 10 | no |" in shown
    assert "| cave-box | 7500 | 2 | 4.4 to 4.4 | 0 | 4.4 | no |" in shown
    assert 24 == sum(line.startswith(SCENES) and 8 == line.count("|") for line in shown.splitlines())


def test_it_says_under_which_share_of_the_settings_more_is_found(shown):
    # Prototype 2A found 10 and 30, prototype 2 8.1, 30.3, 84.6 and 29.2; the walk stood there for 2 rounds and for 1.
    shares = {"cave-box": 100, "cave-predator-prey-box": 0, "chase-avoid": 0, "cave-predator-prey": 33}
    assert [f"| {scene} | {share} |" for scene, share in shares.items()] == [
        line for line in shown.splitlines() if line.startswith(SCENES) and 3 == line.count("|")
    ]


def test_every_choice_has_its_correlation_in_every_environment(shown):
    assert "| tutor.translation | - / +1.00 | - / +1.00 | - / +1.00 | - / +1.00 |" in shown
    assert "| prey.turn | - / - | - / - | - / - | - / - |" in shown
    assert 3 * len(CHOICES) == sum(
        line.startswith(tuple(f"| {name} |" for name in CHOICES)) for line in shown.splitlines()
    )


def test_without_candidates_and_predictions_the_looks_are_shown(tmp_path):
    save_looks(tmp_path / "looks", [look_at(1)])

    lines = list(describe(tmp_path / "looks", tmp_path / "none", tmp_path / "none"))

    assert "1 settings looked at" in lines[0]
    assert not any("candidate" in line or "prediction" in line for line in lines)
