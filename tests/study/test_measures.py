"""Numbers of a run by the way travelled and by time, and what happens to runs that have none."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from tutorstudent.study.numbers.measures import (
    Measure,
    find_harm_measure,
    measure_per_decisions,
    measure_per_time,
    measure_per_way,
)
from tutorstudent.study.runs.results import Run


def run(seed: int = 0, **summary: float) -> Run:
    return Run("cave", "2A", seed, summary, Path("nowhere"))


def test_rates_have_the_unit_of_their_title() -> None:
    summary = {"hits": 6.0, "distance_m": 400.0, "time_s": 2000.0, "decisions": 5000.0}
    assert ("hits per 100 m", 1.5) == (
        measure_per_way("hits", "hits").title,
        measure_per_way("hits", "hits").read(summary),
    )
    assert ("hits per 1,000 s", 3.0) == (
        measure_per_time("hits", "hits").title,
        measure_per_time("hits", "hits").read(summary),
    )
    assert ("hits per 10,000", 12.0) == (
        measure_per_decisions("hits", "hits").title,
        measure_per_decisions("hits", "hits").read(summary),
    )


def test_a_run_without_way_has_no_rate_and_the_others_have() -> None:
    runs = [run(0, hits=2.0, distance_m=0.0), run(1, hits=2.0, distance_m=50.0), run(2, hits=2.0)]
    assert {1: 4.0} == measure_per_way("hits", "hits").read_by_seed(runs)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_what_is_no_number_is_left_out(value: float) -> None:
    assert {1: 3.0} == Measure("hits", "hits").read_by_seed([run(0, hits=value), run(1, hits=3.0)])
    assert Measure("", "hits", "distance_m").read({"hits": 1.0, "distance_m": value}) is None


def test_a_rate_is_known_where_both_its_parts_are() -> None:
    assert measure_per_way("hits", "hits").is_known([run(hits=1.0, distance_m=0.0)])
    assert not measure_per_way("hits", "hits").is_known([run(hits=1.0), run(distance_m=1.0)])
    assert not Measure("hits", "hits").is_known([])


def test_harm_is_collisions_and_violations_where_the_world_knows_none() -> None:
    assert "collided" == find_harm_measure([run(violated=1.0), run(violated=1.0, collided=0.0)]).key
    assert "violated" == find_harm_measure([run(violated=1.0)]).key
