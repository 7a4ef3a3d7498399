"""Donors, recipients, and what a head start would look like."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tutorstudent.study import Run
from tutorstudent_prototype2.head_start import ALONE, FRESH, TRANSPLANTED, head_start, measure
from tutorstudent_prototype2.transplant import donor_jobs, recipient_jobs

NAMES = {
    "kind_names": ["stop", "forward"],
    "situation_names": ["Subsumption", "Prey Spin"],
    "event_names": ["distance_m", "collided"],
}


def run(
    folder: Path, variant: str, seed: int, entered: list[int], proposed: int = 1, bumps: list[int] | None = None
) -> Run:
    """A run of ten decisions that enters Prey Spin at some of them, each time for that decision only."""
    place = folder / variant / str(seed)
    place.mkdir(parents=True)
    events = np.zeros((10, 2))
    events[bumps or [], 1] = 1
    situation = np.zeros(10, dtype=np.int32)
    situation[entered] = 1
    np.savez(
        place / "decisions.npz",
        situation=situation,
        events=events,
        kind=np.array([1] * 5 + [0] * 5),
        proposed_kind=np.full(10, proposed),
        resulting_level=np.arange(10),
        **{name: np.array(words) for name, words in NAMES.items()},
    )
    return Run("cave-predator-prey-box", variant, seed, {}, place)


def test_the_beginning_and_all_are_counted(tmp_path: Path) -> None:
    found = measure(run(tmp_path, TRANSPLANTED, 0, [1, 3, 4, 8], bumps=[2, 9]), 4)
    assert {
        "attractors, first 4 decisions": 2.0,
        "attractors, all": 3.0,  # 3 and 4 are one
        "collided decisions, first 4 decisions": 1.0,
        "collided decisions, all": 2.0,
        "match rate, first 4 decisions, %": 100.0,
        "match rate, all, %": 50.0,
        "mean level, first 4 decisions": 1.5,
        "mean level, all": 4.5,
    } == found


def test_a_student_that_names_no_kinds_has_no_match_rate(tmp_path: Path) -> None:
    assert np.isnan(measure(run(tmp_path, ALONE, 0, [], proposed=-1), 4)["match rate, all, %"])


@pytest.mark.parametrize(
    ("transplanted", "said"),
    [
        (([0, 2], [0, 2]), "A head start shows: attractors, first 4 decisions."),
        (([0, 2], []), "No head start shows: attractors, first 4 decisions."),
        (([], []), "No head start shows: attractors, first 4 decisions."),
    ],
)
def test_a_head_start_shows_or_not(tmp_path: Path, transplanted: tuple[list[int], ...], said: str) -> None:
    fresh = [run(tmp_path, FRESH, seed, []) for seed in range(2)]
    others = [run(tmp_path, TRANSPLANTED, seed, entered) for seed, entered in enumerate(transplanted)]
    alone = [run(tmp_path, ALONE, seed, [0], proposed=-1) for seed in range(2)]
    section = head_start("here -> there", [*fresh, *others, *alone], 4)
    assert said == section.reading[-1]
    assert ("", ALONE, FRESH, TRANSPLANTED, "difference") == section.sheet.header
    assert ("attractors, first 4 decisions", "1.0", "0.0") == section.sheet.rows[0][:3]


def test_the_contrary_is_told_too(tmp_path: Path) -> None:
    fresh = [run(tmp_path, FRESH, seed, [0, 2]) for seed in range(2)]
    section = head_start("x", [*fresh, *(run(tmp_path, TRANSPLANTED, seed, []) for seed in range(2))], 4)
    assert "The contrary of a head start shows: attractors, first 4 decisions." == section.reading[-1]


def test_without_pairs_nothing_is_said(tmp_path: Path) -> None:
    assert "There are no pairs to compare." == head_start("x", [], 4).reading[-1]
    assert "There are no pairs to compare." == head_start("x", [run(tmp_path, FRESH, 0, [])], 4).reading[-1]


def test_each_recipient_is_given_its_own_donor_and_shares_its_seed_with_the_others(tmp_path: Path) -> None:
    donors = donor_jobs(3, 50)
    assert [1000, 1001, 1002] == [job.seed for job in donors]
    jobs = recipient_jobs(donors, 50, tmp_path)
    assert [(name, seed) for seed in range(3) for name in (ALONE, FRESH, TRANSPLANTED)] == [
        (job.variant, job.seed) for job in jobs
    ]
    learned = [job.pipeline["learned"] for job in jobs if job.variant == TRANSPLANTED]
    assert [str(tmp_path / job.folder / "learned.npz") for job in donors] == learned
    fresh, carried = jobs[1].pipeline, jobs[2].pipeline
    assert fresh == {key: value for key, value in carried.items() if key != "learned"}
