"""Every controller in every environment, under one setting."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import tutorstudent as ts
from tutorstudent_prototype2.pipelines import (
    ENVIRONMENTS,
    FOLDER,
    NAMES,
    SHARED,
    load,
    read_frozen_setting,
    read_setting,
)

SETTING = {
    "world": {"camera_fov_deg": 60.0, "prey": {"forward": 0.5}},
    "tutor": {"front_m": 0.25, "clear_m": 0.9, "translation": 0.2},
    "encoder": {"back_m": 0.4},
}


def values(name: str, setting: Any = None) -> Any:
    return load(name, "cave-box", setting).document.data


def test_the_pipelines_are_the_files() -> None:
    assert set(NAMES) == {path.stem for path in FOLDER.glob("*.yaml")}


@pytest.mark.parametrize("name", NAMES)
def test_every_pipeline_builds_under_the_frozen_setting(name: str) -> None:
    for scene in ENVIRONMENTS:
        engine = load(name, scene).engine()
        assert "prototype2" == engine.tutor.name
        engine.close()


def test_the_learning_phases_are_the_thesiss() -> None:
    learners = [name for name in NAMES if name not in ("prototype2", "budgeted")]
    phases = {name: values(name)["amplifier"] for name in learners}
    assert [2500, 5000, 7500, 2500] == [phases[name]["decisions"] for name in learners]
    assert {"learning-phase"} == {phase["use"] for phase in phases.values()}


@pytest.mark.parametrize("name", NAMES)
def test_a_setting_reaches_world_tutor_and_encoder(name: str) -> None:
    found = values(name, SETTING)
    assert {"use": "pioneer", "scene": "cave-box", **SETTING["world"]} == found["world"]
    assert {"use": "prototype2", **SETTING["tutor"]} == found["tutor"]
    if name not in ("prototype2", "budgeted"):
        thresholds = {"front_m": 0.25, "clear_m": 0.9, "back_m": 0.4}
        assert {"use": "prototype2-bits", **thresholds} == found["student"]["encoder"]


def test_the_tutor_alone_has_no_encoder() -> None:
    assert "silent" == values("prototype2", SETTING)["student"]


def test_the_default_student_has_no_encoder_and_the_same_changes_as_prototype_2a() -> None:
    found, network = values("budgeted", SETTING), values("prototype2a", SETTING)
    assert "budgeted" == found["student"]
    assert {"use": "never", "amount": 0.1, "change": "additive"} == found["amplifier"]
    assert all(found[key] == network[key] for key in ("world", "tutor", "conditions", "limits", "observers"))


def test_the_student_sees_what_the_tutor_reacts_to() -> None:
    engine = load("prototype2a", "chase-avoid").engine()
    for key in SHARED:
        assert getattr(engine.tutor.options, key) == getattr(engine.student.options.encoder.options, key)


def test_an_encoder_that_contradicts_the_tutor_is_refused() -> None:
    load("prototype2a", "cave-box", {"tutor": {"prey_m": 1.2}, "encoder": {"prey_m": 1.2}})
    message = r"encoder.prey_m is 1.1, but tutor.prey_m is 1.2; the encoder has the tutor's thresholds"
    with pytest.raises(ts.PipelineError, match=message):
        load("prototype2a", "cave-box", {"tutor": {"prey_m": 1.2}, "encoder": {"prey_m": 1.1}})
    with pytest.raises(ts.PipelineError, match="encoder.prey_m is 1.1, but tutor.prey_m is not given"):
        load("prototype2a", "cave-box", {"encoder": {"prey_m": 1.1}})


def test_an_empty_setting_is_the_defaults_and_not_the_frozen_one() -> None:
    assert {"use": "pioneer", "scene": "cave-box"} == values("prototype2a", {})["world"]


def test_what_is_not_there_is_told() -> None:
    with pytest.raises(
        ts.PipelineError, match="there is no pipeline 'prototype3'. Pipelines: prototype2, prototype2a,"
    ):
        load("prototype3", "cave-box")
    with pytest.raises(ts.PipelineError, match="a setting has no part 'tutr'. Parts: world, tutor, encoder."):
        load("prototype2", "cave-box", {"tutr": {}})
    with pytest.raises(ts.PipelineError, match=r"prototype2.yaml.*tutor.fronty: tutor 'prototype2': unknown option"):
        load("prototype2", "cave-box", {"tutor": {"fronty": 1}}).engine()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("world: [1]\n", "a setting is a mapping of world, tutor, encoder, each a mapping of options"),
        ("- 1\n", "a setting is a mapping of world, tutor, encoder"),
        ("", "a setting is a mapping"),
        ("world: {\n", "the setting cannot be read: "),
        (None, "the setting cannot be read: .*No such file"),
    ],
)
def test_a_setting_that_is_none(tmp_path: Path, text: str | None, message: str) -> None:
    path = tmp_path / "setting.yaml"
    if text is not None:
        path.write_text(text)
    with pytest.raises(ts.PipelineError, match=message):
        read_setting(path)


def test_the_frozen_setting_has_the_parts_of_a_setting() -> None:
    assert set(read_frozen_setting()) <= {"world", "tutor", "encoder"}
