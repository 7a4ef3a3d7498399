"""Verdicts, against ones worked out by hand."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import pytest

from tutorstudent.study import Run
from tutorstudent_prototype2.comparison import Cell, cells, scores
from tutorstudent_prototype2.summaries import pair_up, standard_error_of_difference, summarize
from tutorstudent_prototype2.thesis import rows


def run(environment: str, variant: str, seed: int, attractors: float, collided: float = 0.0) -> Run:
    summary = {"attractors": attractors, "collided": collided, "contacts": collided / 2}
    return Run(environment, variant, seed, summary, Path("nowhere"))


def cave_box(attractors: Sequence[float], collided: Sequence[float]) -> dict[str, Cell]:
    """Cells of prototype 2A 2500 in Cave-Box, where the thesis has 41.6 ± 4.22 and 4.4 ± 4.14."""
    runs = [
        run("cave-box", "prototype2a", seed, *counts)
        for seed, counts in enumerate(zip(attractors, collided, strict=True))
    ]
    return {cell.measure: cell for cell in cells(runs)}


def test_the_interval_of_a_mean_is_students() -> None:
    found = summarize([10.0, 12.0, 14.0, 16.0])
    assert (4, 13.0, 13.0) == (found.runs, found.mean, found.median)
    assert math.sqrt(20 / 3) == pytest.approx(found.sd)
    half = 3.1824463 * math.sqrt(20 / 3) / 2  # t(3) at 97.5 %
    assert (13 - half, 13 + half) == pytest.approx((found.low, found.high))


def test_a_single_run_has_no_interval_and_equal_runs_have_an_empty_one() -> None:
    alone = summarize([7.0])
    assert [True] * 3 == [math.isnan(value) for value in (alone.sd, alone.low, alone.high)]
    assert (3, 2.0, 0.0, 2.0, 2.0, 2.0) == summarize([2.0, 2.0, 2.0])


def test_differences_are_paired_by_seed() -> None:
    found = pair_up({0: 3.0, 1: 9.0, 5: 100.0}, {0: 1.0, 1: 5.0, 7: 0.0})
    assert found is not None
    assert (2, 3.0) == found[:2]
    assert None is pair_up({0: 1.0}, {1: 1.0})


def test_within_one_standard_deviation_of_the_thesis() -> None:
    assert cave_box([45.81, 45.83], [0, 0])["attractors"].within_sd  # 45.82 is 41.6 + 4.22
    assert not cave_box([45.82, 45.84], [0, 0])["attractors"].within_sd
    assert cave_box([37.38, 37.38], [0, 0])["attractors"].within_sd
    assert not cave_box([37.37, 37.37], [0, 0])["attractors"].within_sd


def test_within_two_standard_errors_of_the_difference() -> None:
    # Ours has no spread: the error is 4.22 / sqrt(10) = 1.3345, twice that 2.669.
    assert cave_box([44.26, 44.26], [0, 0])["attractors"].within_errors
    assert not cave_box([44.28, 44.28], [0, 0])["attractors"].within_errors
    # Ours has sd 4: the error is sqrt(4.22² / 10 + 4² / 9) = 1.8864, twice that 3.7729.
    spread = [45.3 + offset for offset in (-4, -4, -4, -4, 0, 4, 4, 4, 4)]
    assert 4.0 == pytest.approx(summarize(spread).sd)
    assert cave_box(spread, [0] * 9)["attractors"].within_errors
    assert not cave_box([value + 0.1 for value in spread], [0] * 9)["attractors"].within_errors
    assert 1.8864 == pytest.approx(standard_error_of_difference(4.0, 9, 4.22, 10), abs=1e-4)


def test_a_single_run_is_never_within_errors_that_are_not_known() -> None:
    assert not cave_box([41.6], [4])["attractors"].within_errors


def test_collisions_are_judged_by_both_ways_of_counting() -> None:
    found = cave_box([41, 41], [10, 12])  # 11 decisions, 5.5 contacts; the thesis 4.4 ± 4.14
    assert [(11.0, False), (5.5, True)] == [
        (found[measure].ours.mean, found[measure].within_sd) for measure in ("collided", "contacts")
    ]


def test_what_has_no_row_in_the_thesis_is_left_out_and_what_did_not_run_too() -> None:
    runs = [run("cave-box", "streamlined", 0, 1.0), run("elsewhere", "prototype2", 0, 1.0)]
    assert [] == cells(runs)
    assert [None] * 3 == [cell.row.learning_phase for cell in cells([*runs, run("cave-box", "prototype2", 0, 1.0)])]


def test_the_yardsticks_hit_what_was_counted_by_hand() -> None:
    exact = [
        run(row.environment, row.pipeline, seed, row.attractors, row.collisions) for row in rows() for seed in range(2)
    ]
    found = {(score.prediction, score.measure): (score.hits, score.cells) for score in scores(cells(exact))}
    assert (12, 12) == found["ours", "attractors"]
    assert (12, 12) == found["ours", "collided"]
    assert (2, 12) == found["the thesis's prototype 2 x 3", "attractors"]
    assert (0, 12) == found["2A = the thesis's prototype 2", "attractors"]
    assert (8, 12) == found["always 6 collisions", "collided"]


def test_prototype_2_is_no_cell_of_the_score() -> None:
    only = [run("cave-box", "prototype2", seed, 8.1) for seed in range(2)]
    assert {0} == {score.cells for score in scores(cells(only))}
