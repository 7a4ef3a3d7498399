"""Tables 2 to 9 of the thesis beside ours, as sheets."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from tutorstudent.study import Run
from tutorstudent_prototype2.comparison import ATTRACTORS, MEASURES, TITLES, Cell, cells, scores
from tutorstudent_prototype2.remarks import remarks
from tutorstudent_prototype2.sheets import NOTHING, Section, Sheet, add_sign, interval, number, spread, yes
from tutorstudent_prototype2.summaries import INTERVALS
from tutorstudent_prototype2.thesis import Improvement, improvements, percent_more

COLUMNS = ("", "thesis", "ours", "median", "interval", "± 1 sd", "2 SE")
VERDICTS = (
    f"Mean ± standard deviation over runs; the interval is the {INTERVALS}. ± 1 sd: our mean lies within the thesis's "
    "mean ± its standard deviation. 2 SE: the means differ by at most 2 standard errors of their difference. "
    "Collided decisions (the robot's own motion was refused) and contacts (the first of each entanglement) both stand "
    "beside what the thesis calls collisions."
)
PERCENTAGES = ("", "thesis, %", "ours, %", "difference, points", "same sign")


def sections(runs: Sequence[Run]) -> list[Section]:
    """Return the tables of every environment of which there are runs, the score, and remarks on the thesis."""
    found = cells(runs)
    environments = dict.fromkeys(cell.row.environment for cell in found)
    tables = [section for name in environments for section in _environment(name, found)]
    return [*tables, _scores(found), _remarks()]


def _environment(environment: str, found: Sequence[Cell]) -> Iterator[Section]:
    mine = [cell for cell in found if cell.row.environment == environment]
    printed = [item for item in improvements() if item.environment == environment]
    title = f"Table {mine[0].row.table}: {environment}"
    yield Section(Sheet(title, COLUMNS, tuple(_by_measure(mine))), (VERDICTS,) if mine[0] is found[0] else ())
    rows = tuple(row for measure in MEASURES for item in printed for row in _improvement(item, measure, mine))
    yield Section(Sheet(f"Table {printed[0].table}: {environment}, 2A against 2", PERCENTAGES, rows))


def _by_measure(mine: Sequence[Cell]) -> Iterator[tuple[str, ...]]:
    for measure in MEASURES:
        yield (TITLES[measure], *[""] * (len(COLUMNS) - 1))
        yield from (_cell(cell) for cell in mine if cell.measure == measure)


def _cell(cell: Cell) -> tuple[str, ...]:
    ours = cell.ours
    return (
        _controller(cell.row.learning_phase),
        f"{cell.thesis:.1f} ± {cell.thesis_sd:.2f}",
        spread(ours.mean, ours.sd),
        number(ours.median),
        interval(ours.low, ours.high),
        yes(cell.within_sd),
        yes(cell.within_errors) if ours.runs > 1 else NOTHING,
    )


def _improvement(printed: Improvement, measure: str, mine: Sequence[Cell]) -> Iterator[tuple[str, ...]]:
    said = printed.attractors_percent if measure == ATTRACTORS else printed.collisions_percent
    if said is not None:
        ours = _percent(measure, printed.learning_phase, mine)
        sign = yes(ours * said > 0) if math.isfinite(ours) else NOTHING
        name = f"{_controller(printed.learning_phase)}, {TITLES[measure]}"
        yield (
            name,
            f"{said:+.1f}" if said == round(said, 1) else f"{said:+}",
            add_sign(ours),
            add_sign(ours - said),
            sign,
        )


def _percent(measure: str, learning_phase: int, mine: Sequence[Cell]) -> float:
    means = {cell.row.learning_phase: cell.ours.mean for cell in mine if cell.measure == measure}
    if None not in means or learning_phase not in means:
        return math.nan
    more = percent_more(means[None], means[learning_phase])
    return more if measure == ATTRACTORS else -more


def _scores(found: Sequence[Cell]) -> Section:
    header = ("within the thesis's mean ± 1 sd", *(TITLES[measure] for measure in MEASURES))
    scored = scores(found)
    names = dict.fromkeys(score.prediction for score in scored)
    hits = {(score.prediction, score.measure): f"{score.hits} of {score.cells}" for score in scored}
    rows = tuple((name, *(hits.get((name, measure), NOTHING) for measure in MEASURES)) for name in names)
    reading = "Means of prototype 2A: four environments, three learning phases; the phases are not independent."
    return Section(Sheet("How many means of prototype 2A are hit", header, rows), (reading,))


def _remarks() -> Section:
    found = remarks()
    rows = tuple((remark.section, remark.says, remark.tables) for remark in found)
    follow = not any(remark.section.startswith("Table") for remark in found)
    reading = ("All percentages of tables 3, 5, 7 and 9 follow from the printed means.",) if follow else ()
    return Section(
        Sheet("What the thesis says and its own tables do not", ("section", "says", "its tables"), rows), reading
    )


def _controller(learning_phase: int | None) -> str:
    return "2" if learning_phase is None else f"2A, {learning_phase}"


def lines(runs: Sequence[Run]) -> list[dict[str, object]]:
    """Return every cell as plain values, for a file."""
    return [
        {
            "table": cell.row.table,
            "environment": cell.row.environment,
            "pipeline": cell.row.pipeline,
            "measure": cell.measure,
            "thesis_mean": cell.thesis,
            "thesis_sd": cell.thesis_sd,
            **cell.ours._asdict(),
            "within_1_sd": cell.within_sd,
            "within_2_se": cell.within_errors,
        }
        for cell in cells(runs)
    ]
