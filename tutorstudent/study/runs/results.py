"""Reads what a study's runs left on disk."""

from __future__ import annotations

import csv
import json
import math
import zipfile
import zlib
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from tutorstudent.core.deciding.watching import Notice
from tutorstudent.core.files.durable import find_files
from tutorstudent.core.files.journal import DECISIONS, RECORD, is_complete, load_record
from tutorstudent.core.running.arrays import Arrays, load_arrays
from tutorstudent.core.words.errors import ContractError
from tutorstudent.core.words.measures import Measure
from tutorstudent.study.plans.constant_level import BEST, Searched, load_searched, settle
from tutorstudent.study.plans.constant_level import FOLDER as SEARCH
from tutorstudent.study.plans.plan import Job, Plan
from tutorstudent.study.runs.jobs import ERROR
from tutorstudent.study.runs.timing import TIMING, Spent, load_timing, read_sittings

AGAIN = "go on with 'compare --resume' to run it again."
DAMAGES = (
    OSError,
    ValueError,
    KeyError,
    TypeError,
    AttributeError,
    ContractError,
    zipfile.BadZipFile,
    zlib.error,
)
"""What reading a damaged run ends in."""


class Run(NamedTuple):
    """One run that is complete."""

    environment: str
    variant: str
    seed: int
    summary: dict[str, float]
    """Every finite number that an observer summarized, and the share of decisions that were amplified."""
    folder: Path
    measures: tuple[Measure, ...] = ()
    """What its parts declared; empty in runs of earlier versions."""
    notices: tuple[Notice, ...] = ()
    """What kept its learner from having any effect."""

    def arrays(self) -> Arrays:
        """Return every decision, as `tutorstudent.core.running.recorder.Recorder` kept it."""
        return load_arrays(self.folder / DECISIONS)

    def spent(self) -> Spent:
        """Return the seconds that it took; NaN where that is not known."""
        return load_timing(self.folder)


class Failure(NamedTuple):
    """A run without results: it failed, its files are damaged, or it was not run yet."""

    environment: str
    variant: str
    seed: int
    problem: str
    """Why; empty where it was not run yet."""


class Study(NamedTuple):
    """Everything that a report is made from."""

    folder: Path
    plan: Plan
    runs: tuple[Run, ...]
    failures: tuple[Failure, ...]
    """Runs that failed, or are damaged."""
    search: Searched | None = None
    """The table of constant levels that were tried, where one was searched for."""
    waiting: tuple[Failure, ...] = ()
    """Runs that were not run yet, because the study was interrupted."""

    def spent(self) -> Spent:
        """Return the seconds that the study took: wall of all its sittings, CPU of all complete runs, searches too."""
        cpu_s = [load_timing(path.parent).cpu_s for path in find_files(self.folder, TIMING)]
        return Spent(sum(read_sittings(self.folder)), sum(found for found in cpu_s if math.isfinite(found)))

    def sittings(self) -> int:
        """Return how often the study was begun or resumed."""
        return len(read_sittings(self.folder))

    def of(self, environment: str, variant: str) -> list[Run]:
        """Return the runs of one row, by seed."""
        return [run for run in self.runs if (run.environment, run.variant) == (environment, variant)]


def read_study(folder: Path, plan: Plan) -> Study:
    """Read the runs of a plan: the complete ones, those that failed, and those that were not run yet.

    Returns:
        The study, with the control of the level that was searched for in its plan.

    Raises:
        PipelineError: if the table of the search is damaged.
    """
    searched = load_searched(folder) if plan.search else None
    complete = settle(plan, searched)
    runs, lacking = read_runs(folder, complete.jobs())
    lacking += _find_search_failures(folder, plan, searched)
    failures = tuple(item for item in lacking if item.problem)
    waiting = tuple(item for item in lacking if not item.problem)
    return Study(folder, complete, tuple(runs), failures, searched, waiting)


def read_runs(folder: Path, jobs: Iterable[Job]) -> tuple[list[Run], list[Failure]]:
    """Read what jobs left below a folder, by environment, variant and seed; those without results are failures."""
    ordered = sorted(jobs, key=lambda job: (job.environment, job.variant, job.seed))
    found = [read_run(folder, job) for job in ordered]
    return [item for item in found if isinstance(item, Run)], [item for item in found if isinstance(item, Failure)]


def read_run(folder: Path, job: Job) -> Run | Failure:
    """Read what one job left below a folder; a failure says why there is nothing, or what is damaged."""
    own = folder / job.folder
    if not (own / RECORD).exists():
        return Failure(job.environment, job.variant, job.seed, _find_problem(own))
    record = load_record(own)
    if not is_complete(record):
        problem = _find_problem(own) or str(record.get("problem", "")) or AGAIN
        return Failure(job.environment, job.variant, job.seed, problem)
    try:
        record = json.loads((own / RECORD).read_text(encoding="utf-8"))
        summary, measures = _read_numbers(record)
        notices = tuple(Notice(**item) for item in record.get("notices", ()))
        _check_decisions(own / DECISIONS)
    except DAMAGES as error:
        problem = f"damaged: {' '.join(f'{type(error).__name__}: {error}'.split())}; {AGAIN}"
        return Failure(job.environment, job.variant, job.seed, problem)
    return Run(job.environment, job.variant, job.seed, summary, own, measures, notices)


def pending(folder: Path, jobs: Iterable[Job]) -> list[Job]:
    """Return the jobs that have no complete run below a folder, in their order; those that failed come last.

    So a run that ends the whole study whenever it is run does not keep the others from being run.
    """
    found = [(run, job) for job in jobs if isinstance(run := read_run(folder, job), Failure)]
    return [job for _, job in sorted(found, key=lambda pair: bool(pair[0].problem))]


def write_csv(path: Path, runs: Sequence[Run]) -> None:
    """Write a row for each run with every summary number; a number that a run does not have is empty."""
    keys = sorted({key for run in runs for key in run.summary})
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["environment", "variant", "seed", *keys])
        for run in runs:
            values = [run.summary.get(key, "") for key in keys]
            writer.writerow([run.environment, run.variant, run.seed, *values])


def _read_numbers(data: dict[str, Any]) -> tuple[dict[str, float], tuple[Measure, ...]]:
    summary: dict[str, float] = {key: value for key, value in data["summary"].items() if value is not None}
    amplified = {"amplified_share": summary["amplified"] / max(1.0, summary["decisions"])}
    return summary | amplified, tuple(Measure(**item) for item in data.get("measures", ()))


def _check_decisions(path: Path) -> None:
    with zipfile.ZipFile(path) as archive:
        broken = archive.testzip()
    if broken is not None:
        raise ValueError(f"{path.name}: {broken} is not what was written")


def _find_problem(folder: Path) -> str:
    error = folder / ERROR
    if not error.exists():
        return ""
    return error.read_text(encoding="utf-8").partition("\n")[0] or f"{error} is empty; {AGAIN}"


def _find_search_failures(folder: Path, plan: Plan, searched: Searched | None) -> list[Failure]:
    """Return what is not complete of a search, and the runs that wait for its level."""
    if plan.search is None or (searched and searched.complete()):
        return []
    _, failures = read_runs(folder / SEARCH, plan.search.plan.jobs())
    lacking = [item.name for item in plan.environments if searched is None or searched.chosen(item.name) is None]
    return [
        *(failure._replace(variant=f"search: {failure.variant}") for failure in failures),
        *(Failure(environment, BEST, seed, "") for environment in lacking for seed in plan.seeds),
    ]
