"""Students trained in a static environment, carried into a dynamic one (Thesis 5.2.3).

Prototype 2A is trained in Cave-Box. What its student learned goes on in Cave-Predator-Prey-Box, where the decision
count, and with it the learning phase, begins anew. The student that begins with nothing there has the same seed.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tutorstudent.study import Failure, Job, Run
from tutorstudent_prototype2.pipelines import load
from tutorstudent_prototype2.running import FIRST_SEED, finish
from tutorstudent_prototype2.sheets import NOTHING, Section, Sheet, difference, markdown, number
from tutorstudent_prototype2.summaries import Summary, paired, summarize

FROM, INTO = "cave-box", "cave-predator-prey-box"
ALONE, NOTHING_LEARNED, TRANSPLANTED = "prototype2", "from-nothing", "transplanted"
DONOR_SEED = 1000
"""Donor i has this seed + i, so that nobody lives through the same random numbers twice."""
BEGINNING = 0.1
"""Part of a run in which "more quickly" (5.2.3) would show: the first thousand of 10,000 decisions."""
PREY_SPIN = "Prey Spin"
"""The tutor's situation that counts as an attractor found when it is entered."""
MARKDOWN = "transplant.md"

Measured = dict[str, float]


def transplant(runs: int, decisions: int, workers: int, out: Path) -> tuple[list[Failure], list[Section]]:
    """Run what has not been run yet, and write `MARKDOWN`.

    Raises:
        PipelineError: The folder holds another study, or cannot be written.
    """
    donors = donor_jobs(runs, decisions)
    _, failures = finish(donors, out / "donors", workers, f"students trained in {FROM}")
    jobs = recipient_jobs(donors, decisions, out.absolute() / "donors")
    found, others = finish(jobs, out / "recipients", workers, f"runs in {INTO}")
    sections = [section(found, decisions)]
    (out / MARKDOWN).write_text(markdown(sections, "Student transplants (5.2.3)"), encoding="utf-8")
    return [*failures, *others], sections


def donor_jobs(runs: int, decisions: int) -> list[Job]:
    """Return the training runs."""
    values = _values("prototype2a", FROM)
    return [Job(FROM, "donor", DONOR_SEED + i, decisions, values) for i in range(runs)]


def recipient_jobs(donors: Sequence[Job], decisions: int, folder: Path) -> list[Job]:
    """Return the runs after it: the tutor alone, a student from nothing, and a transplanted one, on paired seeds."""
    alone, learner = _values("prototype2", INTO), _values("prototype2a", INTO)
    jobs = []
    for i, donor in enumerate(donors):
        learned = {"learned": str(folder / donor.folder / "learned.npz")}
        variants = {ALONE: alone, NOTHING_LEARNED: learner, TRANSPLANTED: learner | learned}
        jobs += [Job(INTO, name, FIRST_SEED + i, decisions, values) for name, values in variants.items()]
    return jobs


def section(runs: Sequence[Run], decisions: int) -> Section:
    """Return the one table, with what it says."""
    first = max(1, round(BEGINNING * decisions))
    found = {
        name: {run.seed: measured(run, first) for run in runs if run.variant == name}
        for name in (ALONE, NOTHING_LEARNED, TRANSPLANTED)
    }
    titles = next((list(values) for group in found.values() for values in group.values()), [])
    header = ("", *found, "transplanted less from nothing, paired")
    more = {title: _difference(found, title) for title in titles}
    rows = tuple(
        (title, *(_mean(group.values(), title) for group in found.values()), difference(more[title]))
        for title in titles
    )
    return Section(Sheet(f"{FROM} -> {INTO}", header, rows), (_reading(more),))


def measured(run: Run, first: int) -> Measured:
    """Return what is compared of one run, by title.

    Args:
        run: With its decisions on disk.
        first: How many decisions its beginning has.
    """
    arrays = run.arrays()
    entered = entries(arrays["situation"] == _index(arrays["situation_names"], PREY_SPIN))
    matched = arrays["proposed_kind"] == arrays["kind"]
    collided = arrays["events"][:, _index(arrays["event_names"], "collided")]
    return {
        f"attractors, first {first} decisions": float(entered[:first].sum()),
        "attractors": float(entered.sum()),
        f"collisions, first {first} decisions": float(collided[:first].sum()),
        "collisions, per decision": float(collided.sum()),
        f"match rate, first {first} decisions, %": 100 * float(matched[:first].mean()),
        "match rate, %": 100 * float(matched.mean()),
        f"mean level, first {first} decisions": float(arrays["resulting_level"][:first].mean()),
        "mean level": float(arrays["resulting_level"].mean()),
    }


def entries(there: np.ndarray[Any, np.dtype[np.bool_]]) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """Return where a situation begins, shape (decisions,).

    >>> entries(np.array([True, True, False, True])).tolist()
    [True, False, False, True]
    """
    return there & ~np.concatenate(([False], there[:-1]))


def _index(names: np.ndarray[Any, Any], name: str) -> int:
    found = np.flatnonzero(names == name)
    return int(found[0]) if len(found) else -1


def _mean(group: Any, title: str) -> str:
    values = [values[title] for values in group]
    return number(summarize(values).mean) if values else NOTHING


def _difference(found: dict[str, dict[int, Measured]], title: str) -> Summary | None:
    ours, theirs = (
        {seed: values[title] for seed, values in found[name].items()} for name in (TRANSPLANTED, NOTHING_LEARNED)
    )
    return paired(ours, theirs)


def _reading(more: dict[str, Summary | None]) -> str:
    title = next(iter(more), "")
    head = more.get(title)
    if head is None:
        return "There are no pairs to compare."
    if head.low > 0:
        return f"A head start shows: {title}."
    return f"{'The contrary of a' if head.high < 0 else 'No'} head start shows: {title}."


def _values(name: str, scene: str) -> dict[str, Any]:
    return dict(load(name, scene).document.data)
