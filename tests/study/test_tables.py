"""Tables against numbers worked out by hand."""

from __future__ import annotations

import re
from html import unescape

import pytest
from rich.console import Console

from tests.study.made import made
from tutorstudent.study.runs.results import Failure, Study
from tutorstudent.study.tables.cells import mean_sd_median, mean_sd_median_worst, number, probability
from tutorstudent.study.tables.media import make_html, make_markdown, make_terminal_table
from tutorstudent.study.tables.table import Row, Table
from tutorstudent.study.tables.tables import make_digest_table, make_runs_table, make_tables

FOUND = {"alone": [8.0, 10.0, 12.0], "2A": [20.0, 30.0, 25.0], "ramp": [20.0, 22.0, 18.0]}
COLLIDED = {"alone": [0.0, 0.0, 0.0], "2A": [4.0, 0.0, 305.0], "ramp": [1.0, 1.0, 1.0]}


def columns(name: str) -> dict[str, list[float | None]]:
    return {
        "attractors": list(FOUND[name]),
        "collided": list(COLLIDED[name]),
        "contacts": [min(value, 3.0) for value in COLLIDED[name]],
        "violated": list(COLLIDED[name]),
        "distance_m": [10.0 * value for value in FOUND[name]],
        "longest_stall": list(COLLIDED[name]),
        "time_s": [20.0, 21.0, 22.0],
        "decisions": [10_000.0] * 3,
        "amplified_share": [0.0, 0.25, 0.5],
        "mean_level": [3.0] * 3,
        "incidents": [0.0, 1.0, 2.0],
    }


def study(reference: str = "alone", missing: tuple[str, int] | None = None) -> Study:
    whole = made({name: columns(name) for name in FOUND}, reference=reference)
    return whole._replace(runs=tuple(run for run in whole.runs if (run.variant, run.seed) != missing))


def titled(study: Study, title: str) -> Table:
    return next(table for table in make_tables(study, study.plan.environments[0]) if table.title == title)


def cell(table: Table, row: str, title: str) -> str:
    return next(item for item in table.rows if item.name == row).cells[table.header.index(title)]


def test_the_tables_of_a_whole_study() -> None:
    assert [
        "What was found",
        "What it cost",
        "What the parts did",
        "By way and by time",
        "Does it harm more than the tutor alone?",
        "Differences to the tutor alone: what was found",
        "Differences to the tutor alone: what it cost",
        "Differences to the tutor alone: what else was measured",
        "Differences to the controls: what was found",
        "Differences to the controls: what it cost",
        "Differences to the controls: what else was measured",
    ] == [table.title for table in make_tables(study(), study().plan.environments[0])]


def test_what_was_found_is_mean_sd_median_and_iqm_with_the_paired_difference() -> None:
    found = titled(study(), "What was found")
    assert ("runs", "attractors", "difference") == found.header
    assert "10.0 ± 2.0 (10; IQM 10.0)" == cell(found, "alone", "attractors")
    assert "25.0 ± 5.0 (25; IQM 25.0)" == cell(found, "2A", "attractors")  # sd of 20, 30, 25 is 5
    assert "-" == cell(found, "alone", "difference")
    # Differences of 2A are 12, 20, 13: mean 15; the interval lies between the least and the greatest of them.
    mean, low, high = map(float, re.findall(r"[-+]?\d+\.\d", cell(found, "2A", "difference")))
    assert 15.0 == mean
    assert 12.0 <= low < 15.0 < high <= 20.0
    assert "100 ± 20.0 (100)" == cell(titled(study(), "What the parts did"), "alone", "distance, m")


def test_what_it_cost_tells_the_worst_run_beside_the_mean() -> None:
    cost = titled(study(), "What it cost")
    # 4, 0 and 305: mean 103, sample sd sqrt((99^2 + 103^2 + 202^2) / 2) = 174.9...
    assert "103 ± 175 (4; max 305)" == cell(cost, "2A", "collided decisions")
    # 3, 0 and 3: mean 2, sample sd sqrt(3).
    assert "2.0 ± 1.7 (3; max 3)" == cell(cost, "2A", "contacts")
    assert "305" == cell(cost, "2A", "longest stall, decisions (max)")
    assert "+1.0 [+1.0, +1.0]" == cell(cost, "ramp", "difference")


def test_rates_are_taken_run_by_run() -> None:
    rates = titled(study(), "By way and by time")
    # A tenth of an attractor for each metre in every run, so that the runs do not differ.
    assert "10.0 ± 0" == cell(rates, "2A", "attractors per 100 m")
    # 20 / 20 s, 30 / 21 s, 25 / 22 s: 1000, 1428.6 and 1136.4 in 1,000 s.
    assert "1188 ± 219" == cell(rates, "2A", "attractors per 1,000 s")
    # 4 / 200 m, 0 / 300 m, 305 / 250 m: 2, 0 and 122 on 100 m; the sum by the whole way would be 41.2.
    assert "41.3 ± 69.9" == cell(rates, "2A", "collided decisions per 100 m")
    assert {
        f"{what} per {unit}"
        for what in ("attractors", "collided decisions", "contacts", "violated decisions")
        for unit in ("100 m", "1,000 s")
    } == set(rates.header[1:])


def test_a_run_without_way_has_no_rate_and_the_cell_says_of_how_many_it_is() -> None:
    halted = study()
    halted.runs[3].summary["distance_m"] = 0.0
    assert "10.0 ± 0 (2 of 3 runs)" == cell(titled(halted, "By way and by time"), "2A", "attractors per 100 m")
    for run in halted.runs[3:6]:
        run.summary["distance_m"] = 0.0
    assert "-" == cell(titled(halted, "By way and by time"), "2A", "attractors per 100 m")


def test_what_the_parts_did() -> None:
    whole = study()
    for run in whole.runs[3:6]:
        run.summary["match_rate"] = 0.5
    parts = titled(whole, "What the parts did")
    assert "50.0 ± 0 (50)" == cell(parts, "2A", "named the tutor's kind, %")
    assert "-" == cell(parts, "ramp", "named the tutor's kind, %")
    assert "25.0 ± 25.0 (25)" == cell(parts, "2A", "raised by the amplifier, %")
    assert "3.0 ± 0 (3)" == cell(parts, "2A", "mean level")
    assert "1.0 ± 1.0 (1)" == cell(parts, "2A", "incidents")
    assert "21.0 ± 1.0 (21)" == cell(parts, "2A", "simulated time, s")


def test_differences_to_the_tutor_alone() -> None:
    table = titled(study(), "Differences to the tutor alone: what was found")
    assert ["2A", "ramp", "2A", "ramp"] == [row.name for row in table.rows]
    learner, control, by_way, _ = (row.cells for row in table.rows)
    assert ("alone", "attractors", "3") == learner[:3]
    assert learner[3].startswith("+15.0 [")
    # Pearson of 8, 10, 12 with 20, 30, 25 is 0.5; three of three are better; 2 of 8 signs lie as far out; two tests.
    assert ("0.50", "100 % [44, 100]", "0.25", "0.50") == learner[4:]
    assert ("100 % [44, 100]", "-", "-") == control[5:]
    # Both find an attractor every ten metres: no difference, no correlation, ties, no evidence.
    assert ("attractors per 100 m", "3", "0 [0, 0]", "-", "50 % [13, 87]", "1.00", "1.00") == by_way[1:]
    assert "corrected for the 2 tests of this table" in table.note
    assert "Nothing is claimed of controls" in table.note
    assert "No p can get below 0.05 after Holm with 3 pairs; it takes 7." in table.note


def test_of_a_single_pair_there_is_no_p() -> None:
    whole = study()
    first = whole._replace(runs=tuple(run for run in whole.runs if run.seed == whole.runs[0].seed))
    note = titled(first, "Differences to the tutor alone: what was found").note
    assert "p: none, with so few pairs. Nothing is claimed of controls" in note
    assert "corrected" not in note


def test_differences_to_the_controls() -> None:
    table = titled(study(), "Differences to the controls: what was found")
    assert [("2A", "ramp", "attractors"), ("2A", "ramp", "attractors per 100 m")] == [
        (row.name, *row.cells[:2]) for row in table.rows
    ]
    assert table.rows[0].cells[3].startswith("+5.0 [")
    # 20 - 20, 30 - 22, 25 - 18: a tie and two wins.
    assert table.rows[0].cells[5].startswith("83 % [")
    assert "Nothing is claimed of controls" not in table.note


def test_enough_pairs_are_not_complained_about() -> None:
    many = made({"alone": {"attractors": [float(i) for i in range(8)]}, "2A": {"attractors": [9.0] * 8}})
    (table,) = (table for table in make_tables(many, many.plan.environments[0]) if "Differences" in table.title)
    assert "No p can get below" not in table.note
    assert ("0.008", "0.008") == table.rows[0].cells[6:]


def test_the_verdict_on_harm_states_its_margin() -> None:
    table = titled(study(), "Does it harm more than the tutor alone?")
    assert ["2A", "ramp"] == [row.name for row in table.rows]
    assert ("1.0", "+1.0 [+1.0, +1.0]", "+10", "not worse") == table.rows[1].cells
    assert "undecided" == table.rows[0].cells[-1]
    assert "margin of 10 in 10,000 decisions" in table.note


def test_without_the_tutor_alone_there_is_no_difference_to_it() -> None:
    alone_missing = study(reference="")
    found = make_tables(alone_missing, alone_missing.plan.environments[0])
    assert all("difference" not in table.header for table in found[:4])
    assert not [table for table in found if "tutor alone" in table.title]


def test_a_run_that_is_missing_is_counted_and_not_paired() -> None:
    found = titled(study(missing=("2A", 1)), "What was found")
    assert "2" == cell(found, "2A", "runs")
    assert "22.5 ± 3.5 (22.5; IQM 22.5)" == cell(found, "2A", "attractors")
    assert "+12.5 (2 pairs)" == cell(found, "2A", "difference")


def test_a_variant_with_failed_runs_says_how_many() -> None:
    failed = study(missing=("2A", 1))._replace(failures=(Failure("cave", "2A", 1, "it broke"),))
    assert "2 (1 failed)" == cell(titled(failed, "What was found"), "2A", "runs")
    assert "3" == cell(titled(failed, "What was found"), "ramp", "runs")


def test_runs_that_were_not_run_yet_are_not_said_to_have_failed() -> None:
    waiting = tuple(Failure("cave", "2A", seed, "") for seed in (1, 2))
    begun = study(missing=("2A", 1))._replace(waiting=waiting)
    assert "2 (2 not run yet)" == cell(titled(begun, "What was found"), "2A", "runs")
    both = begun._replace(failures=(Failure("cave", "2A", 0, "it broke"),))
    assert "2 (1 failed, 2 not run yet)" == cell(titled(both, "What was found"), "2A", "runs")


def test_a_number_that_the_world_counts_is_a_count_like_those_of_observers() -> None:
    whole = study()
    (environment,) = whole.plan.environments
    variants = tuple(item._replace(counters={"distance_m": ""} | item.counters) for item in environment.variants)
    asked = whole._replace(plan=whole.plan._replace(environments=(environment._replace(variants=variants),)))
    assert ("runs", "distance, m", "difference", "attractors", "difference") == titled(asked, "What was found").header
    assert "distance, m" == make_digest_table(asked, asked.plan.environments[0]).header[0]
    compared = titled(asked, "Differences to the tutor alone: what was found")
    assert ["distance, m", "distance, m", "attractors", "attractors", *["attractors per 100 m"] * 2] == sorted(
        (row.cells[1] for row in compared.rows), key=["distance, m", "attractors", "attractors per 100 m"].index
    )
    assert "distance, m per 100 m" not in titled(asked, "By way and by time").header
    assert "distance, m per 1,000 s" in titled(asked, "By way and by time").header


def test_a_variant_of_which_nothing_ran_is_a_row_of_dashes() -> None:
    failures = tuple(Failure("cave", "2A", seed, "it broke") for seed in range(3))
    failed = study()._replace(failures=failures)
    failed = failed._replace(runs=tuple(run for run in failed.runs if run.variant != "2A"))
    found = titled(failed, "What was found")
    assert ("0 (3 failed)", "-", "-") == next(row.cells for row in found.rows if row.name == "2A")


def test_a_number_that_some_runs_do_not_have_is_said_to_be_of_the_others() -> None:
    whole = study()
    del whole.runs[3].summary["attractors"]
    assert "27.5 ± 3.5 (27.5; IQM 27.5) (2 of 3 runs)" == cell(titled(whole, "What was found"), "2A", "attractors")
    whole.runs[4].summary["attractors"] = float("nan")
    assert "25.0 ± - (25; IQM 25.0) (1 of 3 runs)" == cell(titled(whole, "What was found"), "2A", "attractors")
    assert "+13.0 (one pair)" == cell(titled(whole, "What was found"), "2A", "difference")


def test_what_no_run_knows_is_no_column() -> None:
    whole = study()
    for run in whole.runs:
        del run.summary["collided"], run.summary["contacts"], run.summary["distance_m"]
    cost = titled(whole, "What it cost")
    assert "collided decisions" not in cost.header
    assert "violated decisions" in cost.header
    assert ("attractors per 1,000 s", "violated decisions per 1,000 s") == titled(whole, "By way and by time").header[
        1:
    ]
    assert "violated decisions per 10,000" in titled(whole, "Does it harm more than the tutor alone?").header


def test_a_world_without_way_and_time_has_no_table_of_rates() -> None:
    whole = study()
    for run in whole.runs:
        del run.summary["distance_m"], run.summary["time_s"]
    assert "By way and by time" not in [table.title for table in make_tables(whole, whole.plan.environments[0])]


def test_a_study_of_which_nothing_ran_has_no_table() -> None:
    nothing = study()._replace(runs=())
    assert [] == make_tables(nothing, nothing.plan.environments[0])


def test_every_run_is_a_row() -> None:
    whole = study()
    every = make_runs_table(whole, whole.plan.environments[0])
    assert [(name, str(seed)) for name in FOUND for seed in range(3)] == [
        (row.name, row.cells[0]) for row in every.rows
    ]
    assert ["8", "10", "12", "20", "30", "25", "20", "22", "18"] == [row.cells[1] for row in every.rows]
    assert {"10"} == {row.cells[every.header.index("attractors per 100 m")] for row in every.rows}


def test_the_digest_fits_a_terminal() -> None:
    digest = make_digest_table(study(), study().plan.environments[0])
    assert (
        "attractors",
        "collided decisions",
        "contacts",
        "violated decisions",
        "distance, m",
        "mean level",
    ) == digest.header
    assert [["alone", "2A", "ramp"]] == printed(digest, 80)
    assert [["alone", "2A", "ramp"]] * 3 == printed(digest, 40)


def printed(table: Table, width: int) -> list[list[str]]:
    """Return the rows of each part of a table in a terminal, none of whose lines is too long or broken."""
    console = Console(width=width)
    with console.capture() as capture:
        console.print(make_terminal_table(table, width))
    text = capture.get()
    assert max(map(len, text.splitlines())) <= width
    for row in table.rows:
        assert all(cell in text for cell in row.cells)
    first = [line.split()[0] for line in text.splitlines() if line.split()[0] in {row.name for row in table.rows}]
    size = len(table.rows)
    return [first[i : i + size] for i in range(0, len(first), size)]


@pytest.mark.parametrize(
    ("value", "text"), [(0.0, "0"), (float("nan"), "-"), (0.5, "0.50"), (-3.04, "-3.0"), (99999.9, "100000")]
)
def test_numbers_have_as_many_digits_as_a_table_needs(value: float, text: str) -> None:
    assert text == number(value)


def test_one_run_has_a_mean_and_no_spread() -> None:
    assert "4.0 ± - (4)" == mean_sd_median([4.0])
    assert "4.0 ± - (4; max 4)" == mean_sd_median_worst([4.0])


@pytest.mark.parametrize(("p", "text"), [(0.0009, "< 0.001"), (0.001, "0.001"), (0.0999, "0.100"), (0.1, "0.10")])
def test_a_p_is_never_written_as_0(p: float, text: str) -> None:
    assert text == probability(p)


HOSTILE = Table(
    "<b>|title", ("a|b", "<i>"), (Row("x<y|[red]z", False, ("1", "<2>")), Row("c", True, ("-", "[/]"))), "<p>|note"
)


def test_markdown_keeps_hostile_names_in_their_cells() -> None:
    lines = make_markdown(HOSTILE).splitlines()
    rows = [line for line in lines if line.startswith("|")]
    assert [4] * 4 == [len(re.findall(r"(?<!\\)\|", row)) for row in rows]
    assert "**x<y\\|[red]z**" in rows[2]
    assert "*c*" in rows[3]


def test_html_escapes_hostile_names() -> None:
    text = make_html(HOSTILE, {"x<y|[red]z": "red", "c": "blue"})
    assert "x&lt;y|[red]z" in text
    assert "&lt;2&gt;" in text
    assert "<b>" not in text
    assert "<p>|note" not in text
    assert "<p>|note" in unescape(text)


def test_the_terminal_shows_names_as_they_are() -> None:
    console = Console(width=100)
    with console.capture() as capture:
        console.print(make_terminal_table(HOSTILE))
    assert "x<y|[red]z" in capture.get()
    assert "[/]" in capture.get()
