"""Chapter 4 run again: four controllers in four environments, the streamlined one and the controls beside them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from tutorstudent.study import Study, run_study
from tutorstudent_prototype2.calibration.command import LOOKS
from tutorstudent_prototype2.calibration.freezing import AFTER_ROUNDS
from tutorstudent_prototype2.calibration.walks import load_looks
from tutorstudent_prototype2.contrast import contrasts
from tutorstudent_prototype2.pipelines import NAMES, load_all
from tutorstudent_prototype2.reproduction import lines, sections
from tutorstudent_prototype2.running import plan_of
from tutorstudent_prototype2.sheets import Section, Sheet, markdown, write_csv

MARKDOWN, CSV = "reproduction.md", "reproduction.csv"
HEADING = "Chapter 4, the thesis's numbers beside ours"


def reproduce(scenes: Sequence[str], runs: int, decisions: int, workers: int, out: Path) -> tuple[Study, list[Section]]:
    """Run what has not been run yet, and write `MARKDOWN` and `CSV` beside the study's own report.

    Raises:
        PipelineError: The folder holds another study, or cannot be written.
    """
    study = run_study(plan_of(load_all(NAMES, scenes[0]), scenes, runs, decisions, controls=True), out, workers)
    found = [*sections(study.runs), *contrasts(study), cost(study)]
    (out / MARKDOWN).write_text(markdown(found, HEADING), encoding="utf-8")
    write_csv(out / CSV, lines(study.runs))
    return study, found


def cost(study: Study) -> Section:
    """Return what was run, and what it took."""
    spent, plan = study.spent(), study.plan
    rows = (
        ("runs, controls and search included", f"{len(list(study.folder.rglob('run.json')))}"),
        ("runs that failed", f"{len(study.failures)}"),
        ("decisions of a run", f"{plan.decisions}"),
        ("seeds", f"{plan.seeds[0]} to {plan.seeds[-1]}"),
        ("sittings", f"{study.sittings()}"),
        ("wall time, s", f"{spent.wall_s:.0f}"),
        ("CPU time, s", f"{spent.cpu_s:.0f}"),
        ("settings tried before one was frozen", f"{settings_tried()}"),
    )
    return Section(Sheet("What it took", ("", "number"), rows), tuple(map(str, _list_failures(study))))


def settings_tried(looks: Path = LOOKS) -> int:
    """Return how many settings the calibration had looked at when it chose one; 0 where there was none."""
    return sum(look.round <= AFTER_ROUNDS for look in load_looks(looks)) if looks.exists() else 0


def _list_failures(study: Study) -> list[str]:
    return [f"failed: {run.environment}, {run.variant}, seed {run.seed}: {run.problem}" for run in study.failures]
