"""Runs every student in every cell; what was finished before is not run again."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tutorstudent.study import Failure, Job, Run, claim_folder, finish_jobs
from tutorstudent_controllers.regimes.registered import Cell, Registered

ALONE, BUDGETED, BLIND, RAMP = "tutor-alone", "budgeted", "blind", "ramp"


def list_students(cell: Cell, budget: float) -> dict[str, dict[str, Any]]:
    """Return what is laid over a cell's pipeline, by the name of the variant."""
    budgeted: dict[str, Any] = {"student": {"use": "budgeted", "budget": budget}}
    blind: dict[str, Any] = {"evaluator": {"use": "blind", "evaluator": "conditions", "margins": True}}
    constants = {name_level(level): {"student": {"use": "constant", "level": level}} for level in cell.levels}
    found: dict[str, dict[str, Any]] = {
        ALONE: {"student": {"use": "silent"}},
        BUDGETED: budgeted,
        BLIND: budgeted | blind,
        RAMP: {"student": {"use": "ramp"}},
    }
    return found | constants


def name_level(level: int) -> str:
    """Return the name of a constant level; 0 is the tutor alone."""
    return f"level-{level}" if level else ALONE


def list_jobs(registered: Registered) -> list[Job]:
    """Return every run, seed by seed, so that a study that was stopped leaves whole pairs."""
    return [
        Job(cell.name, name, seed, registered.decisions, cell.values | {"selector": "modifier"} | values)
        for seed in registered.seeds
        for cell in registered.cells
        for name, values in list_students(cell, registered.budget).items()
    ]


def run(
    registered: Registered, folder: Path, workers: int, seeds: int | None = None
) -> tuple[list[Run], list[Failure]]:
    """Run what has no results yet, with progress on standard error, and read all.

    Args:
        registered: What the folder is for.
        folder: The study's.
        workers: How many processes.
        seeds: Only the first so many of them; the folder can go on with the others later.

    Raises:
        PipelineError: The folder holds another study, or the same with other numbers.
    """
    claim_folder(list_jobs(registered), folder)
    chosen = registered._replace(seeds=registered.seeds[:seeds])
    return finish_jobs(list_jobs(chosen), folder, workers, "runs")
