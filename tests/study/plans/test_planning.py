"""A plan holds every pipeline with its controls, in every environment, on paired seeds."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from tutorstudent.core.files.registry import Registry
from tutorstudent.core.words.errors import ContractError, PipelineError, TutorStudentError
from tutorstudent.study.plans.plan import Plan, Variant
from tutorstudent.study.plans.planfile import load_plan, save_plan
from tutorstudent.study.plans.planning import make_plan
from tutorstudent.study.plans.requests import Request, read_pipelines, read_setting, read_variation

CONTROLS = {"tutor-alone", "blind", "ramp", "random"}


@pytest.fixture
def plan(files: dict[str, Path], registry: Registry) -> Any:
    def make(*names: str, vary: str | None = None, settings: Sequence[str] = (), **request: Any) -> Plan:
        given = read_pipelines([files[name] for name in names], registry)
        for text in settings:
            given = {name: read_setting("--set", text).apply(pipeline) for name, pipeline in given.items()}
        variations = read_variation("--vary", vary) if vary else []
        return make_plan(Request(given, **({"runs": 2, "variations": variations} | request)), registry)

    return make


def variants(plan: Plan, environment: int = 0) -> dict[str, Variant]:
    return {variant.name: variant for variant in plan.environments[environment].variants}


@pytest.mark.parametrize("name", ["full", "streamlined"])
def test_controls_that_learn_nothing_replace_student_selector_and_amplifier(plan: Any, name: str) -> None:
    found = variants(plan(name))
    assert {name} | CONTROLS == set(found)
    students = {
        "tutor-alone": {"use": "silent"},
        "ramp": {"use": "ramp", "encoder": {"use": "metre"}, "max_level": 8},
        "random": {"use": "random", "max_level": 8},
    }
    for control, student in students.items():
        values = found[control].pipeline
        assert student == values["student"]
        assert "modifier" == values["selector"]["use"]
        assert {"use": "never", "amount": 0.2, "change": {"use": "additive"}} == values["amplifier"]
        for key in ("world", "tutor", "evaluator", "conditions", "limits", "observers"):
            assert found[name].pipeline[key] == values[key]


@pytest.mark.parametrize("name", ["full", "streamlined"])
def test_blind_replaces_the_evaluator_only(plan: Any, name: str) -> None:
    found = variants(plan(name))
    given, blind = found[name].pipeline, found["blind"].pipeline
    assert {"use": "blind", "evaluator": given["evaluator"], "margins": False} == blind["evaluator"]
    assert {key: value for key, value in given.items() if key != "evaluator"} == {
        key: value for key, value in blind.items() if key != "evaluator"
    }


def test_controls_come_from_the_first_pipeline_that_can_amplify(plan: Any) -> None:
    found = variants(plan("alone", "streamlined", "full"))
    assert "level-ampbit" == found["blind"].pipeline["student"]["codec"]["use"]
    assert "A control of streamlined." in found["blind"].about


def test_a_control_that_is_given_as_a_pipeline_does_not_run_twice(plan: Any) -> None:
    made = plan("full", "alone")
    assert {"full", "alone", "blind", "ramp", "random"} == set(variants(made))
    assert "alone" == made.environments[0].reference


def test_a_tutor_alone_with_other_conditions_is_another_pipeline(plan: Any, files: dict[str, Path]) -> None:
    files["alone"].write_text(files["alone"].read_text().replace("[at-wall]", "[]"))
    assert "tutor-alone" in variants(plan("full", "alone"))


def test_differences_are_to_the_learners_own_tutor(plan: Any, files: dict[str, Path]) -> None:
    files["alone"].write_text(files["alone"].read_text().replace("shuttle", "{use: shuttle, far_m: 1.5}"))
    assert "tutor-alone" == plan("alone", "full").environments[0].reference
    assert "" == plan("alone", "full", controls=False).environments[0].reference


def test_a_constant_level_that_is_given_does_not_run_twice(plan: Any, files: dict[str, Path]) -> None:
    text = files["full"].read_text()
    for old, new in [
        ("{use: table, encoder: metre, codec: kind-level-ampbit}", "{use: constant, level: 4}"),
        ("same-kind", "modifier"),
        ("learning-phase, decisions: 20", "never"),
    ]:
        text = text.replace(old, new)
    files["steady"] = files["full"].with_name("steady.yaml")
    files["steady"].write_text(text)
    assert "constant-4" in variants(plan("full", search_runs=0))
    assert "constant-4" not in variants(plan("full", "steady", search_runs=0))


def test_controls_can_be_left_out(plan: Any) -> None:
    made = plan("full", controls=False)
    assert {"full"} == set(variants(made))
    assert "" == made.environments[0].reference


def test_tutors_alone_have_no_controls(plan: Any) -> None:
    made = plan("alone")
    assert {"alone"} == set(variants(made))
    assert "alone" == made.environments[0].reference


def test_run_i_has_the_same_seed_for_every_variant_and_control(plan: Any) -> None:
    made = plan("full", "alone", vary="world.scene=short,long", runs=3, first_seed=11)
    jobs = made.jobs()
    assert 3 * 2 * 5 == len(jobs)
    for environment in ("short", "long"):
        for variant in variants(made):
            seeds = [job.seed for job in jobs if (job.environment, job.variant) == (environment, variant)]
            assert [11, 12, 13] == seeds


def test_jobs_go_seed_by_seed_and_have_a_folder_each(plan: Any) -> None:
    jobs = plan("full", vary="world.scene=short,long").jobs()
    assert sorted(job.seed for job in jobs) == [job.seed for job in jobs]
    assert len(jobs) == len({job.folder for job in jobs})
    assert Path("runs/short/full/0") == jobs[0].folder


def test_each_value_of_a_variation_is_an_environment(plan: Any) -> None:
    made = plan("full", vary="world.scene=short,long")
    assert ["short", "long"] == [environment.name for environment in made.environments]
    for i, scene in enumerate(("short", "long")):
        assert {scene} == {variant.pipeline["world"]["scene"] for variant in variants(made, i).values()}


def test_without_a_variation_the_environment_is_named_after_the_scene(plan: Any) -> None:
    assert ["short"] == [environment.name for environment in plan("full").environments]


def test_decisions_come_from_the_files_unless_they_are_given(plan: Any) -> None:
    assert 60 == plan("full").decisions
    assert 7 == plan("full", decisions=7).decisions


def test_files_with_different_numbers_of_decisions_need_one(plan: Any, files: dict[str, Path]) -> None:
    files["alone"].write_text(files["alone"].read_text().replace("60", "61"))
    with pytest.raises(PipelineError, match=r"different numbers of decisions \(60, 61\); give one number with --decis"):
        plan("full", "alone")
    assert 9 == plan("full", "alone", decisions=9).decisions


def test_pipelines_in_different_worlds_cannot_be_paired(plan: Any, files: dict[str, Path]) -> None:
    files["alone"].write_text(files["alone"].read_text().replace("corridor", "{use: corridor, trial: 9}"))
    with pytest.raises(PipelineError, match="'full' and 'alone' run in different worlds; their runs cannot be paired"):
        plan("full", "alone")


@pytest.mark.parametrize(
    ("vary", "message"),
    [
        (
            "world.scen=long",
            r"\(with world.scen=long\): world.scen: .*unknown option 'scen' \(did you mean 'scene'\?\)",
        ),
        ("wrold.scene=long", r"full.yaml \(with wrold.scene=long\): wrold: unknown key \(did you mean 'world'\?\)"),
        ("world.scene=short,round", r"full.yaml \(with world.scene=round\): world.scene: .*found 'round'"),
        ("world=nowhere", r"full.yaml \(with world=nowhere\): world: no world named 'nowhere'"),
        ("conditions.0=at-wall", r"'conditions' is \['at-wall'\], not a mapping; set 'conditions' itself"),
    ],
)
def test_a_variation_that_no_pipeline_understands_is_a_readable_error(plan: Any, vary: str, message: str) -> None:
    with pytest.raises(TutorStudentError, match=message):
        plan("full", vary=vary)


def test_a_pipeline_without_a_world_is_refused(plan: Any, files: dict[str, Path]) -> None:
    files["full"].write_text(files["full"].read_text().replace("world: {use: corridor, scene: short}\n", ""))
    with pytest.raises(PipelineError, match="there is no 'world'; add one"):
        plan("full")


def test_a_world_that_executes_other_actions_is_refused_before_anything_runs(
    plan: Any, files: dict[str, Path], registry: Registry
) -> None:
    corridor = registry.get("world", "corridor")
    other = type("Elsewhere", (corridor,), {"name": "elsewhere", "action": type("Other", (corridor.action,), {})})  # type: ignore[attr-defined]
    registry.add(other)
    files["full"].write_text(files["full"].read_text().replace("use: corridor", "use: elsewhere"))
    with pytest.raises(ContractError, match="world 'elsewhere' executes Other"):
        plan("full")


def test_a_pipeline_with_the_name_of_a_control_is_refused(plan: Any, files: dict[str, Path]) -> None:
    files["ramp"] = files["full"].rename(files["full"].with_name("ramp.yaml"))
    with pytest.raises(PipelineError, match="'ramp' is the name of a control; rename the file, or --no-controls"):
        plan("ramp")


def test_a_plan_can_be_read_again(plan: Any, tmp_path: Path) -> None:
    made = plan("full", "alone", vary="world.scene=short,long")
    save_plan(made, tmp_path)
    assert made == load_plan(tmp_path)


def test_a_folder_without_a_plan_is_refused(tmp_path: Path) -> None:
    with pytest.raises(PipelineError, match=r"there is no plan.json; give the folder that 'compare --out' wrote"):
        load_plan(tmp_path)
    (tmp_path / "plan.json").write_text("{")
    with pytest.raises(PipelineError, match=r"plan.json: cannot be read"):
        load_plan(tmp_path)
