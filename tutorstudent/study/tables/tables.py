"""The tables of a study: for each environment, a row for every variant and control."""

from __future__ import annotations

from collections.abc import Sequence

from tutorstudent.study.numbers.measures import Measure
from tutorstudent.study.numbers.pairs import make_pairs
from tutorstudent.study.plans.plan import Environment, Variant
from tutorstudent.study.runs.results import Run, Study
from tutorstudent.study.tables.cells import NOTHING, difference
from tutorstudent.study.tables.columns import (
    Column,
    make_conduct_columns,
    make_cost_columns,
    make_digest_columns,
    make_found_columns,
    make_rate_columns,
)
from tutorstudent.study.tables.difference_tables import make_difference_tables, make_verdict_tables
from tutorstudent.study.tables.table import Row, Table

CONTROLS = (
    "A control learns nothing or is told nothing. Amplifying alone may achieve more, whether or not anything was "
    "learned, so a variant has shown what learning is worth only where it beats its controls, not the tutor alone."
)
INTERVALS = (
    "Cells are mean ± standard deviation over runs (median; IQM: mean of the middle half). Differences are taken run "
    "by run on the same seed, with a 95 % BCa bootstrap interval over pairs (10,000 resamples); such an interval is "
    "too narrow for fewer than about ten pairs, and there is none for fewer than three. Rates are taken run by run, "
    "then over runs."
)


def make_tables(study: Study, environment: Environment) -> list[Table]:
    """Return what was found, what it cost and what the parts did, then what is compared to what."""
    counters = environment.counters()
    described = [
        _make_table(study, environment, "What was found", make_found_columns(counters)),
        _make_table(study, environment, "What it cost", make_cost_columns()),
        _make_table(study, environment, "By way and by time", make_rate_columns(counters)),
        _make_table(study, environment, "What the parts did", make_conduct_columns()),
    ]
    compared = [*make_verdict_tables(study, environment), *make_difference_tables(study, environment)]
    return [table for table in described if len(table.header) > 1] + compared


def make_digest_table(study: Study, environment: Environment) -> Table:
    """Return the one table that a terminal shows; the others stand in the page and in table.md."""
    title = f"{len(study.plan.seeds)} runs each, mean ± standard deviation"
    table = _make_table(study, environment, title, make_digest_columns(environment.counters()))
    return Table(title, table.header[1:], tuple(row._replace(cells=row.cells[1:]) for row in table.rows))


def make_runs_table(study: Study, environment: Environment) -> Table:
    """Return every run, a row each."""
    counters = environment.counters()
    columns = [
        *make_found_columns(counters),
        *make_cost_columns(),
        *make_rate_columns(counters),
        *make_conduct_columns(),
    ]
    there = [run for run in study.runs if run.environment == environment.name]
    shown = [column.measure for column in columns if column.measure.is_known(there)]
    rows = [
        Row(variant.name, variant.control, (str(run.seed), *(_make_run_cell(run, measure) for measure in shown)))
        for variant in environment.variants
        for run in study.of(environment.name, variant.name)
    ]
    header = ("seed", *(measure.title.partition(" (")[0] for measure in shown))
    return Table("Every run", header, tuple(rows))


def _make_table(study: Study, environment: Environment, title: str, columns: Sequence[Column]) -> Table:
    there = [run for run in study.runs if run.environment == environment.name]
    shown = [column for column in columns if column.measure.is_known(there)]
    header = ["runs"]
    for column in shown:
        is_compared = column.compared and environment.reference
        header += [column.measure.title, "difference"] if is_compared else [column.measure.title]
    rows = [_make_row(study, environment, variant, shown) for variant in environment.variants]
    return Table(title, tuple(header), tuple(rows))


def _make_row(study: Study, environment: Environment, variant: Variant, columns: Sequence[Column]) -> Row:
    runs, cells = study.of(environment.name, variant.name), [_count_runs(study, environment, variant.name)]
    reference = study.of(environment.name, environment.reference)
    for column in columns:
        cells.append(_make_cell(runs, column))
        if column.compared and environment.reference:
            itself = variant.name == environment.reference
            cells.append(NOTHING if itself else _make_difference(runs, reference, column.measure))
    return Row(variant.name, variant.control, tuple(cells))


def _count_runs(study: Study, environment: Environment, variant: str) -> str:
    place = (environment.name, variant)
    told = {"failed": study.failures, "not run yet": study.waiting}
    counts = {word: sum(item[:2] == place for item in found) for word, found in told.items()}
    lacking = ", ".join(f"{number} {word}" for word, number in counts.items() if number)
    return f"{len(study.of(*place))}" + (f" ({lacking})" if lacking else "")


def _make_cell(runs: Sequence[Run], column: Column) -> str:
    values = column.measure.read_by_seed(runs)
    missing = f" ({len(values)} of {len(runs)} runs)" if 0 < len(values) < len(runs) else ""
    return column.cell(list(values.values())) + missing if values else NOTHING


def _make_difference(runs: Sequence[Run], reference: Sequence[Run], measure: Measure) -> str:
    pairs = make_pairs(measure.read_by_seed(runs), measure.read_by_seed(reference))
    return difference(pairs.difference() if pairs else None)


def _make_run_cell(run: Run, measure: Measure) -> str:
    value = measure.read(run.summary)
    return NOTHING if value is None else f"{value:.6g}"
