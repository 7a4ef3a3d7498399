"""Which decisions are taught about, and what is said of it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from tutorstudent.study import Run
from tutorstudent_prototype2.intervals import ALONE, NEVER, WHOLE, intervals_of, pipelines, reading


def runs(**attractors: Sequence[float]) -> dict[str, list[Run]]:
    """Runs of variants, seed by seed; underscores stand for dashes."""
    return {
        name.replace("_", "-"): [
            Run("cave-box", name, seed, {"attractors": value}, Path("nowhere")) for seed, value in enumerate(values)
        ]
        for name, values in attractors.items()
    }


def test_the_intervals_are_the_first_thousand_and_the_quarters() -> None:
    assert [(0, 1000), (0, 2500), (2500, 5000), (5000, 7500), (7500, 10000)] == intervals_of(10_000)
    assert [(0, 50), (0, 125), (125, 250), (250, 375), (375, 500)] == intervals_of(500)


def test_each_learner_is_taught_in_its_interval_and_is_otherwise_prototype_2a() -> None:
    found = {name: pipeline.document.data for name, pipeline in pipelines("cave-box", 10_000).items()}
    assert 8 == len(found)
    assert "evaluator" not in found[WHOLE]
    assert {"use": "interval", "begin": 10_000} == found[NEVER]["evaluator"]
    assert {"use": "interval", "begin": 2500, "end": 5000} == found["taught-2500-5000"]["evaluator"]
    for name, values in found.items():
        if name != ALONE:
            assert found[WHOLE] == {key: value for key, value in values.items() if key != "evaluator"}


def test_an_interval_that_shows_is_given_its_part_of_the_whole() -> None:
    found = runs(
        prototype2=[5, 5, 5],
        taught_never=[10, 11, 12],
        taught_0_1000=[20, 21, 22.1],  # +10.03, hardly any spread
        taught_0_2500=[10, 30, 12],  # +6.3 ± 11
        taught_whole=[30, 31, 32],
    )
    (said,) = reading(found)
    assert (
        "Teaching throughout is worth +20.0 attractors over never. Of that (each at 95 % by itself):\n"
        "* taught-0-1000: 50 %\n"
        "* taught-0-2500: nothing that shows"
    ) == said


def test_without_anything_learned_nothing_is_divided() -> None:
    same = runs(prototype2=[1, 2], taught_never=[10, 30], taught_0_1000=[1, 2], taught_whole=[30, 10])
    expected = "Teaching throughout has not shown to differ from never teaching: there is no learning to divide."
    assert [expected] == reading(same)
    assert [expected] == reading(runs(prototype2=[], taught_never=[], taught_0_1000=[], taught_whole=[]))
