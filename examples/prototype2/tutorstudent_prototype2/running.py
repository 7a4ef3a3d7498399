"""Runs what a study consists of; whatever was finished before is not run again."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import tutorstudent as ts
from tutorstudent.study import Failure, Job, Plan, Request, Run, Setting, claim_folder, finish_jobs, make_plan
from tutorstudent_prototype2.pipelines import ENVIRONMENTS

FIRST_SEED = 0
"""Of everything that is reported; the calibration begins at 100,000."""


def plan_of(
    pipelines: Mapping[str, ts.Pipeline], scenes: Sequence[str], runs: int, decisions: int, controls: bool
) -> Plan:
    """Return the plan of a study: every pipeline in every scene, run i with the seed `FIRST_SEED` + i for all alike.

    Robots start at the poses of the scene and act in its order, whatever the controller (Thesis 4.2).

    Raises:
        PipelineError: Something cannot be built.
    """
    variations = [Setting("world.scene", scene) for scene in scenes]
    request = Request(pipelines, runs, FIRST_SEED, decisions, variations, controls)
    return make_plan(request, ts.Registry.discover())


def read_scenes(text: str) -> list[str]:
    """Return the scenes of a list with commas.

    Raises:
        PipelineError: One is none of the thesis's environments, or there is none.
    """
    scenes = [word.strip() for word in text.split(",") if word.strip()]
    wrong = [scene for scene in scenes if scene not in ENVIRONMENTS]
    if wrong or not scenes:
        found = f"there is no environment '{wrong[0]}'" if wrong else "no environment is named"
        raise ts.PipelineError(f"--scenes {text}: {found}. Environments: {', '.join(ENVIRONMENTS)}.")
    return scenes


def finish(jobs: Sequence[Job], folder: Path, workers: int, title: str) -> tuple[list[Run], list[Failure]]:
    """Run the jobs that have no results yet, with progress on standard error, and read all.

    Raises:
        PipelineError: The folder belongs to other jobs.
    """
    claim_folder(jobs, folder)
    return finish_jobs(jobs, folder, workers, title)
