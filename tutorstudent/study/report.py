"""From the folder of a study to its table and its page; nothing is run."""

from __future__ import annotations

from pathlib import Path

from tutorstudent.study.media import markdown
from tutorstudent.study.page import page
from tutorstudent.study.planfile import load_plan
from tutorstudent.study.results import Study, read_study, write_csv
from tutorstudent.study.tables import CONTROLS, INTERVALS, tables

CSV = "results.csv"
MARKDOWN = "table.md"
PAGE = "report.html"


def write_report(folder: Path) -> Study:
    """Write `CSV`, `MARKDOWN` and `PAGE` from what is on disk, and return it.

    Raises:
        PipelineError: if the folder holds no plan.
    """
    study = read_study(folder, load_plan(folder))
    write_csv(folder / CSV, study.runs)
    parts = [CONTROLS, INTERVALS]
    for environment in study.plan.environments:
        parts += [f"## {environment.name}", *(markdown(table) for table in tables(study, environment))]
    (folder / MARKDOWN).write_text("\n\n".join(parts), encoding="utf-8")
    (folder / PAGE).write_text(page(study), encoding="utf-8")
    return study
