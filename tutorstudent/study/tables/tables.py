"""The tables of a study: for each environment, a row for every variant and control."""

from __future__ import annotations

from collections.abc import Sequence

from tutorstudent.study.numbers.declared import find_measures
from tutorstudent.study.numbers.pairs import make_pairs
from tutorstudent.study.numbers.quantities import Quantity
from tutorstudent.study.plans.plan import Environment, Variant
from tutorstudent.study.runs.results import Run, Study
from tutorstudent.study.tables.cells import NOTHING, difference
from tutorstudent.study.tables.columns import RATES, Column, explain, make_columns, make_digest_columns
from tutorstudent.study.tables.difference_tables import make_difference_tables, make_verdict_tables
from tutorstudent.study.tables.table import Row, Table

CONTROLS = (
    "A control learns nothing or is told nothing. Amplifying alone may achieve more, whether or not anything was "
    "learned, so a variant has quantities what learning is worth only where it beats its controls, not the tutor alone."
)
INTERVALS = (
    "Cells are mean ± standard deviation over runs (median; IQM: mean of the middle half). Differences are taken run "
    "by run on the same seed, with a 95 % BCa bootstrap interval over pairs (10,000 resamples); such an interval is "
    "too narrow for fewer than about ten pairs, and there is none for fewer than three. Rates are taken run by run, "
    "then over runs."
)


def make_tables(study: Study, environment: Environment) -> list[Table]:
    """Return what was found, what it cost and what the parts did, then what is compared to what."""
    described = [
        _make_table(study, environment, title, columns, note="" if title == RATES else explain(columns))
        for title, columns in _make_columns(study, environment).items()
        if columns
    ]
    return [*described, *make_verdict_tables(study, environment), *make_difference_tables(study, environment)]


def make_digest_table(study: Study, environment: Environment) -> Table:
    """Return the one table that a terminal shows; the others stand in the page and in table.md."""
    columns = make_digest_columns(find_measures(environment, study.runs))
    title = f"{len(study.plan.seeds)} runs each, mean ± standard deviation"
    plain = environment._replace(reference="")  # differences stand in the other tables
    table = _make_table(study, plain, title, columns, explain(columns))
    return table._replace(header=table.header[1:], rows=tuple(row._replace(cells=row.cells[1:]) for row in table.rows))


def make_runs_table(study: Study, environment: Environment) -> Table:
    """Return every run, a row each."""
    quantities = [column.quantity for columns in _make_columns(study, environment).values() for column in columns]
    rows = [
        Row(variant.name, variant.control, (str(run.seed), *(_make_number(run, quantity) for quantity in quantities)))
        for variant in environment.variants
        for run in study.of(environment.name, variant.name)
    ]
    return Table("Every run", ("seed", *(quantity.title for quantity in quantities)), tuple(rows))


def _make_columns(study: Study, environment: Environment) -> dict[str, list[Column]]:
    """Return the columns of each table, without those that no run has."""
    there = [run for run in study.runs if run.environment == environment.name]
    found = make_columns(find_measures(environment, there))
    return {title: [item for item in columns if item.quantity.is_known(there)] for title, columns in found.items()}


def _make_table(study: Study, environment: Environment, title: str, columns: Sequence[Column], note: str) -> Table:
    header = ["runs"]
    for column in columns:
        header += [column.title, "difference"] if column.is_compared and environment.reference else [column.title]
    rows = [_make_row(study, environment, variant, columns) for variant in environment.variants]
    return Table(title, tuple(header), tuple(rows), note)


def _make_row(study: Study, environment: Environment, variant: Variant, columns: Sequence[Column]) -> Row:
    runs, cells = study.of(environment.name, variant.name), [_count_runs(study, environment, variant.name)]
    reference = study.of(environment.name, environment.reference)
    for column in columns:
        cells.append(_make_cell(runs, column))
        if column.is_compared and environment.reference:
            itself = variant.name == environment.reference
            cells.append(NOTHING if itself else _make_difference(runs, reference, column.quantity))
    return Row(variant.name, variant.control, tuple(cells))


def _count_runs(study: Study, environment: Environment, variant: str) -> str:
    key = (environment.name, variant)
    told = {"failed": study.failures, "not run yet": study.waiting}
    counts = {word: sum(item[:2] == key for item in found) for word, found in told.items()}
    lacking = ", ".join(f"{number} {word}" for word, number in counts.items() if number)
    return f"{len(study.of(*key))}" + (f" ({lacking})" if lacking else "")


def _make_cell(runs: Sequence[Run], column: Column) -> str:
    values = column.quantity.read_by_seed(runs)
    missing = f" ({len(values)} of {len(runs)} runs)" if 0 < len(values) < len(runs) else ""
    return column.cell(list(values.values())) + missing if values else NOTHING


def _make_difference(runs: Sequence[Run], reference: Sequence[Run], quantity: Quantity) -> str:
    pairs = make_pairs(quantity.read_by_seed(runs), quantity.read_by_seed(reference))
    return difference(pairs.difference() if pairs else None)


def _make_number(run: Run, quantity: Quantity) -> str:
    value = quantity.of(run.summary)
    return NOTHING if value is None else f"{value:.6g}"
