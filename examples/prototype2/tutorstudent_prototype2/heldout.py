"""A scene that no calibration has seen: the cave at 12 m, as an occupancy map. Everything else is unchanged."""

from __future__ import annotations

from pathlib import Path

from tutorstudent.study import Study, run_study
from tutorstudent_prototype2.contrast import contrasts
from tutorstudent_prototype2.pipelines import load_all
from tutorstudent_prototype2.running import plan_of
from tutorstudent_prototype2.sheets import Section, markdown

SCENE = Path(__file__).parent / "scenes" / "cave-12m.yaml"
NAMES = ("prototype2", "prototype2a", "streamlined")
MARKDOWN = "heldout.md"


def heldout(runs: int, decisions: int, workers: int, out: Path) -> tuple[Study, list[Section]]:
    """Run what has not been run yet, and write `MARKDOWN` beside the study's own report.

    Raises:
        PipelineError: The folder holds another study, or cannot be written.
    """
    scene = str(SCENE)
    study = run_study(plan_of(load_all(NAMES, scene), [scene], runs, decisions, controls=True), out, workers)
    found = contrasts(study)
    (out / MARKDOWN).write_text(markdown(found, "A scene that no calibration has seen"), encoding="utf-8")
    return study, found
