"""The table with controls, against numbers worked out by hand."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import pytest

from tutorstudent.study import Run
from tutorstudent_prototype2.contrast import HEADER, contrasts


def run(variant: str, seed: int, attractors: float, collided: float, way_m: float) -> Run:
    summary = {"attractors": attractors, "collided": collided, "contacts": collided / 2, "distance_m": way_m}
    summary |= {"contact_speed_mps": 0.1 * collided, "longest_stall": collided, "time_s": 2000.0}
    return Run("cave-box", variant, seed, summary, Path("nowhere"))


@pytest.fixture
def study() -> SimpleNamespace:
    runs = [
        run("prototype2a", 0, 50.0, 4.0, 800.0),
        run("prototype2a", 1, 60.0, 0.0, 400.0),
        run("blind", 0, 48.0, 2.0, 200.0),
        run("blind", 1, 54.0, 0.0, 0.0),
    ]
    variants = [
        SimpleNamespace(name="prototype2a", control=False, about=""),
        SimpleNamespace(name="blind", control=True, about="Never told. More."),
        SimpleNamespace(name="ramp", control=True, about="No learning."),
    ]
    environment = SimpleNamespace(name="cave-box", variants=variants)
    return SimpleNamespace(
        plan=SimpleNamespace(environments=[environment]),
        runs=runs,
        of=lambda scene, name: [run for run in runs if (run.environment, run.variant) == (scene, name)],
    )


def test_every_variant_stands_beside_the_learner_with_its_harm_by_way_and_its_speed(study: SimpleNamespace) -> None:
    (section,) = contrasts(study)
    learner, blind, ramp = (dict(zip(HEADER, row, strict=True)) for row in section.sheet.rows)

    assert ("-", "2.0 ± 2.8", "0.250", "0.40", "600", "4") == tuple(
        learner[key] for key in ("less 2A's", "collided", "per 100 m", "m/s", "way, m", "stall")
    )
    assert blind["less 2A's"].startswith("-4.0 [")
    assert {"-"} == set(list(ramp.values())[1:])


def test_a_run_without_any_way_makes_a_rate_that_is_none(study: SimpleNamespace) -> None:
    (section,) = contrasts(study)

    assert "-" == dict(zip(HEADER, section.sheet.rows[1], strict=True))["per 100 m"]


def test_controls_and_simulated_time_are_named(study: SimpleNamespace) -> None:
    (section,) = contrasts(study)

    assert "Controls: blind (Never told); ramp (No learning)." == section.reading[0]
    assert "2000 s of simulated time" in section.reading[-1]
