"""The table with controls, against numbers worked out by hand."""

from __future__ import annotations

from pathlib import Path

import pytest

from tutorstudent.study import Environment, Plan, Run, Study, Variant
from tutorstudent_prototype2.contrast import HEADER, contrasts


def run(variant: str, seed: int, attractors: float, collided: float, way_m: float) -> Run:
    summary = {"attractors": attractors, "collided": collided, "contacts": collided / 2, "distance_m": way_m}
    summary |= {"contact_speed_mps": 0.1 * collided, "longest_stall": collided, "time_s": 2000.0}
    return Run("cave-box", variant, seed, summary, Path("nowhere"))


@pytest.fixture
def study() -> Study:
    runs = (
        run("prototype2a", 0, 50.0, 4.0, 800.0),
        run("prototype2a", 1, 60.0, 0.0, 400.0),
        run("blind", 0, 48.0, 2.0, 200.0),
        run("blind", 1, 54.0, 0.0, 0.0),
    )
    variants = (
        Variant("prototype2a", "", False, {}, {}),
        Variant("blind", "Never told. More.", True, {}, {}),
        Variant("ramp", "No learning.", True, {}, {}),
    )
    return Study(Path("nowhere"), Plan((Environment("cave-box", variants, ""),), (0, 1), 100), runs, ())


def test_every_variant_stands_beside_the_learner_with_its_harm_by_way_and_its_speed(study: Study) -> None:
    (section,) = contrasts(study)
    learner, blind, ramp = (dict(zip(HEADER, row, strict=True)) for row in section.sheet.rows)

    assert ("-", "2.0 ± 2.8", "0.250", "0.40", "600", "4") == tuple(
        learner[key] for key in ("less 2A's", "collided", "per 100 m", "m/s", "way, m", "stall")
    )
    assert blind["less 2A's"].startswith("-4.0 [")
    assert {"-"} == set(list(ramp.values())[1:])


def test_a_run_without_any_way_makes_a_rate_that_is_none(study: Study) -> None:
    (section,) = contrasts(study)

    assert "-" == dict(zip(HEADER, section.sheet.rows[1], strict=True))["per 100 m"]


def test_controls_and_simulated_time_are_named(study: Study) -> None:
    (section,) = contrasts(study)

    assert "Controls: blind (Never told); ramp (No learning)." == section.reading[0]
    assert "2000 s of simulated time" in section.reading[-1]
