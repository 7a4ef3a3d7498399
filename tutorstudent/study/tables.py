"""The tables of a study: for each environment, a row for every variant and control."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from tutorstudent.study.columns import NOTHING, Column, conduct, cost, difference, digest, found
from tutorstudent.study.plan import Environment
from tutorstudent.study.results import Run, Study
from tutorstudent.study.statistics import paired_difference


class Row(NamedTuple):
    """A variant with its cells."""

    name: str
    control: bool
    cells: tuple[str, ...]


class Table(NamedTuple):
    """A table as text; how it is drawn is the medium's affair."""

    title: str
    header: tuple[str, ...]
    rows: tuple[Row, ...]


CONTROLS = (
    "A control learns nothing or is told nothing. Driving faster finds more attractors whether or not anything was "
    "learned, so a variant has shown what learning is worth only where it beats its controls, not the tutor alone."
)
INTERVALS = (
    "Cells are mean ± standard deviation over runs (median). Differences are to the tutor alone, run by run on the "
    "same seed, with a 95 % percentile bootstrap interval over pairs (10,000 resamples); such an interval "
    "is too narrow for fewer than about ten pairs."
)


def tables(study: Study, environment: Environment) -> list[Table]:
    """Return what was found, what it cost, and what the parts did."""
    return [
        _table(study, environment, "What was found", found(environment.counters())),
        _table(study, environment, "What it cost", cost()),
        _table(study, environment, "What the parts did", conduct()),
    ]


def digest_table(study: Study, environment: Environment) -> Table:
    """Return the one table that a terminal shows; the others stand in the page and in table.md."""
    title = f"{len(study.plan.seeds)} runs each, mean ± standard deviation"
    table = _table(study, environment, title, digest(environment.counters()))
    return Table(title, table.header[1:], tuple(row._replace(cells=row.cells[1:]) for row in table.rows))


def runs_table(study: Study, environment: Environment) -> Table:
    """Return every run, a row each."""
    columns = [*found(environment.counters()), *cost(), *conduct()]
    there = [run for run in study.runs if run.environment == environment.name]
    shown = [column for column in columns if any(column.key in run.summary for run in there)]
    rows = [
        Row(variant.name, variant.control, (str(run.seed), *(_alone(run, column.key) for column in shown)))
        for variant in environment.variants
        for run in study.of(environment.name, variant.name)
    ]
    header = ("seed", *(column.title.partition(" (")[0] for column in shown))
    return Table("Every run", header, tuple(rows))


def _table(study: Study, environment: Environment, title: str, columns: Sequence[Column]) -> Table:
    rows = {variant.name: study.of(environment.name, variant.name) for variant in environment.variants}
    shown = [column for column in columns if any(column.key in run.summary for runs in rows.values() for run in runs)]
    compared = bool(environment.reference)
    header = ["runs"]
    for column in shown:
        header += [column.title, "difference"] if column.compared and compared else [column.title]
    return Table(
        title,
        tuple(header),
        tuple(
            Row(
                variant.name,
                variant.control,
                (str(len(rows[variant.name])), *_cells(rows[variant.name], rows.get(environment.reference), shown)),
            )
            for variant in environment.variants
        ),
    )


def _cells(runs: Sequence[Run], reference: Sequence[Run] | None, columns: Sequence[Column]) -> list[str]:
    cells = []
    for column in columns:
        values = _by_seed(runs, column.key)
        missing = f" ({len(values)} of {len(runs)} runs)" if 0 < len(values) < len(runs) else ""
        cells.append(column.cell(list(values.values())) + missing if values else NOTHING)
        if column.compared and reference is not None:
            itself = runs == reference
            theirs = _by_seed(reference, column.key)
            cells.append(NOTHING if itself else difference(paired_difference(values, theirs)))
    return cells


def _by_seed(runs: Sequence[Run], key: str) -> dict[int, float]:
    return {run.seed: run.summary[key] for run in runs if key in run.summary}


def _alone(run: Run, key: str) -> str:
    return f"{run.summary[key]:.6g}" if key in run.summary else NOTHING
