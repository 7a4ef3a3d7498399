"""Controls fit any pipeline: whatever its world, action, student, selector, amplifier, evaluator and limits."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.rundir import run_pipeline
from tutorstudent.study import Plan, Variant
from tutorstudent.study.plans.resolving import reread

Planned = Callable[..., Plan]


def variants(plan: Plan) -> dict[str, Variant]:
    candidates = plan.search.plan.environments[0].variants if plan.search else ()
    return {variant.name: variant for variant in (*candidates, *plan.environments[0].variants)}


@pytest.mark.parametrize(("name", "highest"), [("full", 4), ("streamlined", 4), ("plant", 8)])
def test_every_control_of_any_pipeline_runs_without_an_incident(
    planned: Planned, registry: Registry, name: str, highest: int
) -> None:
    found = variants(planned(name))
    assert {"tutor-alone", "blind", "ramp", "random", name} | {f"level-{i}" for i in range(1, highest + 1)} == set(
        found
    )
    for control in found.values():
        pipeline = reread(control.name, control.pipeline | {"decisions": 30, "on_incident": "raise"}, registry)
        assert 0 == run_pipeline(pipeline).summary["incidents"]


@pytest.mark.parametrize("name", ["full", "plant"])
def test_a_control_keeps_whatever_it_does_not_replace(planned: Planned, name: str) -> None:
    found = variants(planned(name))
    kept = ("world", "tutor", "evaluator", "conditions", "observers", "limits", "on_tutor_failure")
    for control in found.keys() - {name, "blind"}:
        assert {key: found[name].pipeline[key] for key in kept} == {key: found[control].pipeline[key] for key in kept}
        assert "modifier" == found[control].pipeline["selector"]["use"]
        assert "never" == found[control].pipeline["amplifier"]["use"]


def test_a_control_moves_as_far_as_the_pipelines_own_amplifier(planned: Planned) -> None:
    amplifier = variants(planned("plant"))["level-3"].pipeline["amplifier"]
    assert {"use": "never", "amount": 0.05, "change": {"use": "rooted"}} == amplifier


def test_a_constant_level_is_executed_within_the_pipelines_limits(planned: Planned, registry: Registry) -> None:
    values = variants(planned("plant"))["level-8"].pipeline
    levels = run_pipeline(reread("level-8", values | {"decisions": 30}, registry)).decisions["resulting_level"]
    # The slew lets it rise by two levels in each decision, and half as much again is little where little is heated.
    assert [2, 4, 6, 8] == levels[:4].tolist()
    assert levels[-1] < 8


def test_a_ramp_looks_at_what_the_student_looks_at(planned: Planned) -> None:
    assert {"use": "metre"} == variants(planned("full"))["ramp"].pipeline["student"]["encoder"]
    assert variants(planned("plant"))["ramp"].pipeline["student"]["encoder"] is None


PROGRAM = """\
import sys
from pathlib import Path
from tutorstudent.core.files.registry import Registry
from tutorstudent.study import Request, make_plan, read_pipelines, run_plan
registry = Registry.discover()
plan = make_plan(Request(read_pipelines([Path(sys.argv[1])], registry), 1, decisions=20, search_runs=1), registry)
study = run_plan(plan, Path(sys.argv[2]))
print(len(study.runs), len(study.failures), plan.environments[0].name, "pybullet" in sys.modules)
"""


@pytest.mark.process
def test_a_pipeline_without_a_simulator_is_compared_in_its_own_world(
    files: dict[str, Path], corridor_distribution: Path, tmp_path: Path
) -> None:
    environment: dict[str, Any] = os.environ | {"PYTHONPATH": str(corridor_distribution)}
    arguments = [sys.executable, "-c", PROGRAM, files["plant"], tmp_path / "out"]
    done = subprocess.run(arguments, env=environment, capture_output=True, text=True, check=True)
    assert "6 0 kettle False" == done.stdout.strip()
