"""Tables against numbers worked out by hand."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from rich.console import Console

from tutorstudent.study.columns import heavy_tailed, number, typical
from tutorstudent.study.media import html, markdown, terminal
from tutorstudent.study.plan import Environment, Plan, Variant
from tutorstudent.study.results import Run, Study
from tutorstudent.study.tables import Row, Table, runs_table, tables

COUNTERS = {"attractors": "Prey Spin"}
FOUND = {"alone": [8.0, 10.0, 12.0], "2A": [20.0, 30.0, 25.0], "ramp": [20.0, 22.0, 18.0]}
COLLIDED = {"alone": [0.0, 0.0, 0.0], "2A": [4.0, 0.0, 305.0], "ramp": [1.0, 1.0, 1.0]}


def study(reference: str = "alone", missing: tuple[str, int] | None = None) -> Study:
    variants = tuple(Variant(name, "", name == "ramp", {}, COUNTERS) for name in FOUND)
    environment = Environment("cave", variants, reference)
    runs = [
        Run("cave", name, seed, summary(name, seed), Path("nowhere"))
        for name in FOUND
        for seed in range(3)
        if (name, seed) != missing
    ]
    return Study(Path("nowhere"), Plan((environment,), (0, 1, 2), 100), tuple(runs), ())


def summary(name: str, seed: int) -> dict[str, float]:
    return {
        "attractors": FOUND[name][seed],
        "collided": COLLIDED[name][seed],
        "contacts": min(COLLIDED[name][seed], 3.0),
        "violated": COLLIDED[name][seed],
        "distance_m": 10.0 * FOUND[name][seed],
        "longest_stall": COLLIDED[name][seed],
        "time_s": 20.0 + seed,
        "amplified_share": 0.25 * seed,
        "mean_level": 3.0,
        "incidents": float(seed),
    }


def cell(made: Table, row: str, title: str) -> str:
    return next(item for item in made.rows if item.name == row).cells[made.header.index(title)]


def test_what_was_found_is_mean_sd_and_median_with_the_paired_difference() -> None:
    found, _, _ = tables(study(), study().plan.environments[0])
    assert ("runs", "attractors", "difference", "distance, m") == found.header
    assert "10.0 ± 2.0 (10)" == cell(found, "alone", "attractors")
    assert "25.0 ± 5.0 (25)" == cell(found, "2A", "attractors")  # sd of 20, 30, 25 is 5
    assert "-" == cell(found, "alone", "difference")
    # Differences of 2A are 12, 20, 13: mean 15; the interval lies between the least and the greatest of them.
    mean, low, high = map(float, re.findall(r"[-+]?\d+\.\d", cell(found, "2A", "difference")))
    assert 15.0 == mean
    assert 12.0 <= low < 15.0 < high <= 20.0
    assert "100 ± 20.0 (100)" == cell(found, "alone", "distance, m")


def test_what_it_cost_tells_the_worst_run_beside_the_mean() -> None:
    _, cost, _ = tables(study(), study().plan.environments[0])
    # 4, 0 and 305: mean 103, sample sd sqrt((99^2 + 103^2 + 202^2) / 2) = 174.9...
    assert "103 ± 175 (4; max 305)" == cell(cost, "2A", "collisions, per decision")
    # 3, 0 and 3: mean 2, sample sd sqrt(3).
    assert "2.0 ± 1.7 (3; max 3)" == cell(cost, "2A", "collisions, per contact")
    assert "305" == cell(cost, "2A", "longest stall, decisions (max)")
    assert "+1.0 [+1.0, +1.0]" == cell(cost, "ramp", "difference")


def test_what_the_parts_did() -> None:
    _, _, parts = tables(study(), study().plan.environments[0])
    assert "25 %" == cell(parts, "2A", "amplified (mean)")
    assert "3.0" == cell(parts, "2A", "mean level")
    assert "3" == cell(parts, "2A", "incidents (sum)")
    assert "21.0" == cell(parts, "2A", "simulated time, s (mean)")


def test_without_the_tutor_alone_there_is_no_difference() -> None:
    made = study(reference="")
    assert all("difference" not in table.header for table in tables(made, made.plan.environments[0]))


def test_a_run_that_is_missing_is_counted_and_not_paired() -> None:
    made = study(missing=("2A", 1))
    found, _, _ = tables(made, made.plan.environments[0])
    assert "2" == cell(found, "2A", "runs")
    assert "22.5 ± 3.5 (22.5)" == cell(found, "2A", "attractors")
    assert cell(found, "2A", "difference").startswith("+12.5 ")


def test_a_number_that_some_runs_do_not_have_is_said_to_be_of_the_others() -> None:
    made = study()
    del made.runs[3].summary["attractors"]
    found, _, _ = tables(made, made.plan.environments[0])
    assert "27.5 ± 3.5 (27.5) (2 of 3 runs)" == cell(found, "2A", "attractors")


def test_what_no_run_knows_is_no_column() -> None:
    made = study()
    for run in made.runs:
        del run.summary["collided"], run.summary["contacts"]
    _, cost, _ = tables(made, made.plan.environments[0])
    assert "collisions, per decision" not in cost.header
    assert "violated, as the learner saw it" in cost.header


def test_every_run_is_a_row() -> None:
    made = study()
    every = runs_table(made, made.plan.environments[0])
    assert [(name, str(seed)) for name in FOUND for seed in range(3)] == [
        (row.name, row.cells[0]) for row in every.rows
    ]
    assert ["8", "10", "12", "20", "30", "25", "20", "22", "18"] == [row.cells[1] for row in every.rows]


@pytest.mark.parametrize(
    ("value", "text"), [(0.0, "0"), (float("nan"), "-"), (0.5, "0.50"), (-3.04, "-3.0"), (99999.9, "100000")]
)
def test_numbers_have_as_many_digits_as_a_table_needs(value: float, text: str) -> None:
    assert text == number(value)


def test_one_run_has_a_mean_and_no_spread() -> None:
    assert "4.0 ± - (4)" == typical([4.0])
    assert "4.0 ± - (4; max 4)" == heavy_tailed([4.0])


HOSTILE = Table("<b>|title", ("a|b", "<i>"), (Row("x<y|[red]z", False, ("1", "<2>")), Row("c", True, ("-", "[/]"))))


def test_markdown_keeps_hostile_names_in_their_cells() -> None:
    lines = markdown(HOSTILE).splitlines()
    rows = [line for line in lines if line.startswith("|")]
    assert [4] * 4 == [len(re.findall(r"(?<!\\)\|", row)) for row in rows]
    assert "**x<y\\|[red]z**" in rows[2]
    assert "*c*" in rows[3]


def test_html_escapes_hostile_names() -> None:
    text = html(HOSTILE, {"x<y|[red]z": "red", "c": "blue"})
    assert "x&lt;y|[red]z" in text
    assert "&lt;2&gt;" in text
    assert "<b>" not in text


def test_the_terminal_shows_names_as_they_are() -> None:
    console = Console(width=100)
    with console.capture() as capture:
        console.print(terminal(HOSTILE))
    assert "x<y|[red]z" in capture.get()
    assert "[/]" in capture.get()
