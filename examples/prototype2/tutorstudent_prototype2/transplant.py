"""Students trained in a static environment, carried into a dynamic one (Thesis 5.2.3).

Prototype 2A is trained in Cave-Box. What its student learned goes on in Cave-Predator-Prey-Box, where the decision
count, and with it the learning phase, begins anew. The student that begins with nothing there has the same seed.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tutorstudent.study import Failure, Job
from tutorstudent_prototype2.head_start import ALONE, FRESH, TRANSPLANTED, head_start
from tutorstudent_prototype2.pipelines import load
from tutorstudent_prototype2.running import FIRST_SEED, finish
from tutorstudent_prototype2.sheets import Section, markdown

FROM, INTO = "cave-box", "cave-predator-prey-box"
DONOR_SEED = 1000
"""Donor i has this seed + i, so that nobody lives through the same random numbers twice."""
BEGINNING = 0.1
"""Part of a run that is looked at by itself: the first thousand of 10,000 decisions."""
MARKDOWN = "transplant.md"


def transplant(runs: int, decisions: int, workers: int, out: Path) -> tuple[list[Failure], list[Section]]:
    """Run what has not been run yet, and write `MARKDOWN`.

    Raises:
        PipelineError: The folder holds another study, or cannot be written.
    """
    donors = donor_jobs(runs, decisions)
    _, failures = finish(donors, out / "donors", workers, f"students trained in {FROM}")
    jobs = recipient_jobs(donors, decisions, out.absolute() / "donors")
    found, others = finish(jobs, out / "recipients", workers, f"runs in {INTO}")
    sections = [head_start(f"{FROM} -> {INTO}", found, max(1, round(BEGINNING * decisions)))]
    (out / MARKDOWN).write_text(markdown(sections, "Student transplants (5.2.3)"), encoding="utf-8")
    return [*failures, *others], sections


def donor_jobs(runs: int, decisions: int) -> list[Job]:
    """Return the training runs."""
    values = _values("prototype2a", FROM)
    return [Job(FROM, "donor", DONOR_SEED + i, decisions, values) for i in range(runs)]


def recipient_jobs(donors: Sequence[Job], decisions: int, folder: Path) -> list[Job]:
    """Return the runs after it: the tutor alone, a student from nothing, and a transplanted one, on paired seeds.

    Args:
        donors: The training runs.
        decisions: Of each run.
        folder: In which the donors ran.
    """
    alone, learner = _values("prototype2", INTO), _values("prototype2a", INTO)
    jobs = []
    for i, donor in enumerate(donors):
        learned = {"learned": str(folder / donor.folder / "learned.npz")}
        variants = {ALONE: alone, FRESH: learner, TRANSPLANTED: learner | learned}
        jobs += [Job(INTO, name, FIRST_SEED + i, decisions, values) for name, values in variants.items()]
    return jobs


def _values(name: str, scene: str) -> dict[str, Any]:
    return dict(load(name, scene).document.data)
