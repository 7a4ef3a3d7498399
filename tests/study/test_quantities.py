"""Numbers of a run by the way travelled and by time, and what happens to runs that have none."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import tutorstudent as ts
from tutorstudent.study.numbers.quantities import DECISIONS, TIME, WAY, Quantity
from tutorstudent.study.runs.results import Run

HITS = ts.Measure("hits")


def run(seed: int = 0, **summary: float) -> Run:
    return Run("cave", "2A", seed, summary, Path("nowhere"))


def test_rates_have_the_unit_of_their_title() -> None:
    summary = {"hits": 6.0, "distance_m": 400.0, "time_s": 2000.0, "decisions": 5000.0}
    assert [("hits per 100 m", 1.5), ("hits per 1,000 s", 3.0), ("hits per 10,000", 12.0)] == [
        (quantity.title, quantity.of(summary)) for quantity in (Quantity(HITS, unit) for unit in (WAY, TIME, DECISIONS))
    ]


def test_shares_are_told_in_percent() -> None:
    share = Quantity(ts.Measure("match_rate", "named the kind", unit="%", summed="mean"))
    assert ("named the kind, %", 25.0) == (share.title, share.of({"match_rate": 0.25}))


def test_a_run_without_way_has_no_rate_and_the_others_have() -> None:
    runs = [run(0, hits=2.0, distance_m=0.0), run(1, hits=2.0, distance_m=50.0), run(2, hits=2.0)]
    assert {1: 4.0} == Quantity(HITS, WAY).read_by_seed(runs)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_what_is_no_number_is_left_out(value: float) -> None:
    assert {1: 3.0} == Quantity(HITS).read_by_seed([run(0, hits=value), run(1, hits=3.0)])
    assert Quantity(HITS, WAY).of({"hits": 1.0, "distance_m": value}) is None


def test_a_rate_is_known_where_both_its_parts_are() -> None:
    assert Quantity(HITS, WAY).is_known([run(hits=1.0, distance_m=0.0)])
    assert not Quantity(HITS, WAY).is_known([run(hits=1.0), run(distance_m=1.0)])
    assert not Quantity(HITS).is_known([])
