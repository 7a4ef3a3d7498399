"""Every example runs, in every scene that is shipped, without an incident."""

from __future__ import annotations

from pathlib import Path

import pytest

from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.rundir import run_pipeline

ROOT = Path(__file__).parents[1]
PIPELINES = sorted((ROOT / "examples").rglob("pipelines/*.yaml"))
SCENES = sorted(path.stem for path in (ROOT / "tutorstudent" / "sims" / "pioneer" / "scenes").glob("*.yaml"))


def test_the_four_environments_of_the_thesis_are_shipped() -> None:
    assert ["cave-box", "cave-predator-prey", "cave-predator-prey-box", "chase-avoid"] == SCENES


@pytest.mark.simulator
@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("path", PIPELINES, ids=lambda path: path.stem)
def test_every_example_runs(path: Path, scene: str) -> None:
    changes = {"world.scene": scene, "decisions": 60, "on_incident": "raise"}
    finished = run_pipeline(Pipeline.read(path, Registry.discover()).replaced(changes))
    assert 60 == finished.summary["decisions"]
    assert 0 == finished.summary["incidents"]
    assert 0 < finished.summary["distance_m"]
