"""Reads what a study's runs left on disk."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

from tutorstudent.core.recording import Arrays, load_arrays
from tutorstudent.study.jobs import ERROR
from tutorstudent.study.plan import Job, Plan

RECORD = "run.json"
DECISIONS = "decisions.npz"


class Run(NamedTuple):
    """One run that is complete."""

    environment: str
    variant: str
    seed: int
    summary: dict[str, float]
    """Every finite number that an observer summarized, and the share of decisions that were amplified."""
    folder: Path

    def arrays(self) -> Arrays:
        """Return every decision, as `tutorstudent.core.recording.Recorder` kept it."""
        return load_arrays(self.folder / DECISIONS)


class Failure(NamedTuple):
    """One run that is not."""

    environment: str
    variant: str
    seed: int
    problem: str


class Study(NamedTuple):
    """Everything that a report is made from."""

    folder: Path
    plan: Plan
    runs: tuple[Run, ...]
    failures: tuple[Failure, ...]

    def of(self, environment: str, variant: str) -> list[Run]:
        """Return the runs of one row, by seed."""
        return [run for run in self.runs if (run.environment, run.variant) == (environment, variant)]


def read_study(folder: Path, plan: Plan) -> Study:
    """Read the runs of a plan; those that failed or never ran are failures, none is left out."""
    runs, failures = read_runs(folder, plan.jobs())
    return Study(folder, plan, tuple(runs), tuple(failures))


def read_runs(folder: Path, jobs: Iterable[Job]) -> tuple[list[Run], list[Failure]]:
    """Read what jobs left below a folder, by environment, variant and seed; those without results are failures."""
    runs, failures = [], []
    for job in sorted(jobs, key=lambda job: (job.environment, job.variant, job.seed)):
        if (folder / job.folder / RECORD).exists():
            runs.append(_run(job, folder / job.folder))
        else:
            failures.append(Failure(job.environment, job.variant, job.seed, _problem(folder / job.folder)))
    return runs, failures


def write_csv(path: Path, runs: Sequence[Run]) -> None:
    """Write a row for each run with every summary number; a number that a run does not have is empty."""
    keys = sorted({key for run in runs for key in run.summary})
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["environment", "variant", "seed", *keys])
        for run in runs:
            values = [run.summary.get(key, "") for key in keys]
            writer.writerow([run.environment, run.variant, run.seed, *values])


def _run(job: Job, place: Path) -> Run:
    data = json.loads((place / RECORD).read_text(encoding="utf-8"))
    summary: dict[str, float] = {key: value for key, value in data["summary"].items() if value is not None}
    share = {"amplified_share": summary["amplified"] / max(1.0, summary["decisions"])}
    return Run(job.environment, job.variant, job.seed, summary | share, place)


def _problem(place: Path) -> str:
    error = place / ERROR
    return error.read_text(encoding="utf-8").partition("\n")[0] if error.exists() else "it was not run."
