"""From the folder of a study to its tables and its page; nothing is run."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from tutorstudent.study.numbers.comparisons import families, write_differences
from tutorstudent.study.page.document import page
from tutorstudent.study.page.remarks import goal_line, remarks
from tutorstudent.study.plans.planfile import load_plan
from tutorstudent.study.runs.results import Study, read_study, write_csv
from tutorstudent.study.tables.latex import document
from tutorstudent.study.tables.media import markdown
from tutorstudent.study.tables.table import Table
from tutorstudent.study.tables.tables import CONTROLS, INTERVALS, tables

CSV = "results.csv"
DIFFERENCES = "differences.csv"
MARKDOWN = "table.md"
LATEX = "tables.tex"
PAGE = "report.html"


def write_report(folder: Path) -> Study:
    """Write `CSV`, `DIFFERENCES`, `MARKDOWN`, `LATEX` and `PAGE` from what is on disk, and return it.

    The same folder has the same files again, to the last byte.

    Raises:
        PipelineError: if the folder holds no plan.
    """
    study = read_study(folder, load_plan(folder))
    write_csv(folder / CSV, study.runs)
    write_differences(folder / DIFFERENCES, families(study))
    made = {environment.name: tables(study, environment) for environment in study.plan.environments}
    (folder / MARKDOWN).write_text(_markdown(study, made), encoding="utf-8")
    (folder / LATEX).write_text(document(made.items()), encoding="utf-8")
    (folder / PAGE).write_text(page(study), encoding="utf-8")
    return study


def _markdown(study: Study, made: Mapping[str, Iterable[Table]]) -> str:
    said = [goal_line(study), *(f"> {text}" for text in remarks(study))]
    parts = [*filter(None, said), CONTROLS, INTERVALS]
    for title, found in made.items():
        parts += [f"## {title}", *map(markdown, found)]
    return "\n\n".join(parts)
