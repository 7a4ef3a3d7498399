"""From the folder of a study to its tables and its page; nothing is run."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from tutorstudent.study.numbers.comparisons import make_families, write_differences
from tutorstudent.study.page.document import make_page
from tutorstudent.study.page.remarks import describe_goal, make_remarks
from tutorstudent.study.plans.planfile import load_plan
from tutorstudent.study.runs.results import Study, read_study, write_csv
from tutorstudent.study.tables.latex import make_document
from tutorstudent.study.tables.media import make_markdown
from tutorstudent.study.tables.table import Table
from tutorstudent.study.tables.tables import CONTROLS, INTERVALS, make_tables

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
    write_differences(folder / DIFFERENCES, make_families(study))
    made = {environment.name: make_tables(study, environment) for environment in study.plan.environments}
    (folder / MARKDOWN).write_text(_make_markdown(study, made), encoding="utf-8")
    (folder / LATEX).write_text(make_document(made.items()), encoding="utf-8")
    (folder / PAGE).write_text(make_page(study), encoding="utf-8")
    return study


def _make_markdown(study: Study, made: Mapping[str, Iterable[Table]]) -> str:
    said = [describe_goal(study), *(f"> {text}" for text in make_remarks(study))]
    parts = [*filter(None, said), CONTROLS, INTERVALS]
    for title, found in made.items():
        parts += [f"## {title}", *map(make_markdown, found)]
    return "\n\n".join(parts)
