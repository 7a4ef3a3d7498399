"""What a person writes on the command line becomes plain values, or a sentence about the mistake."""

from __future__ import annotations

from pathlib import Path

import pytest

from tutorstudent.core.files.registry import Registry
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.study.plans.planning import make_plan
from tutorstudent.study.plans.requests import Request, make_slug, read_pipelines, read_setting, read_variation


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("a.b=3", 3),
        ("a.b=0.5", 0.5),
        ("a.b=cave-box", "cave-box"),
        ("a.b=true", True),
        ("a.b=", None),
        ("a.b=[near, bumped]", ["near", "bumped"]),
        ("a.b={use: never, amount: 0.2}", {"use": "never", "amount": 0.2}),
        ("a.b=x=y", "x=y"),
    ],
)
def test_the_value_of_a_setting_is_yaml(text: str, value: object) -> None:
    setting = read_setting("--set", text)
    assert ("a.b", value) == (setting.key, setting.value)


@pytest.mark.parametrize("text", ["", "scene", "=3", " =3"])
def test_a_setting_without_key_or_equals_sign_is_refused(text: str) -> None:
    with pytest.raises(PipelineError, match=r"--set .*: write key=value, as in --set world.scene=cave-box"):
        read_setting("--set", text)


def test_a_setting_that_is_no_yaml_says_so() -> None:
    with pytest.raises(PipelineError, match=r"--set a=\[1:1:\d+: not valid YAML"):
        read_setting("--set", "a=[1")


@pytest.mark.parametrize(
    ("text", "labels"),
    [
        ("world.scene=chase-avoid,cave-box", ["chase-avoid", "cave-box"]),
        ("world.scene=scenes/my hall.yaml", ["my-hall"]),
        ("world.stall_latency=0,3", ["stall_latency-0", "stall_latency-3"]),
    ],
)
def test_each_value_of_a_variation_is_an_environment_with_a_name(text: str, labels: list[str]) -> None:
    assert labels == [setting.label for setting in read_variation("--vary", text)]


def test_a_variation_without_values_is_refused() -> None:
    with pytest.raises(PipelineError, match="there are no values"):
        read_variation("--vary", "world.scene=")


def test_a_variation_that_names_one_environment_twice_is_refused() -> None:
    with pytest.raises(PipelineError, match="two environments would be named 'a'"):
        read_variation("--vary", "world.scene=a,b,a")


def test_pipelines_are_named_after_their_files(files: dict[str, Path], registry: Registry) -> None:
    assert ["alone", "full"] == list(read_pipelines([files["alone"], files["full"]], registry))


def test_no_pipeline_is_refused(registry: Registry) -> None:
    with pytest.raises(PipelineError, match="there is no pipeline; give at least one YAML file"):
        read_pipelines([], registry)


def test_two_files_of_one_name_are_refused(files: dict[str, Path], tmp_path: Path, registry: Registry) -> None:
    other = tmp_path / "full.yml"
    other.write_text(files["full"].read_text())
    with pytest.raises(PipelineError, match=r"full.yaml and .*full.yml would both be named 'full'; rename one"):
        read_pipelines([files["full"], other], registry)


def test_a_file_called_pipeline_is_named_after_its_folder(
    files: dict[str, Path], tmp_path: Path, registry: Registry, monkeypatch: pytest.MonkeyPatch
) -> None:
    mine = tmp_path / "my tutor" / "pipeline.yaml"
    mine.parent.mkdir()
    mine.write_text(files["full"].read_text())
    monkeypatch.chdir(mine.parent)
    given = read_pipelines([Path("pipeline.yaml")], registry)
    assert ["my-tutor"] == list(given)
    plan = make_plan(Request(given, 1, controls=False), registry)
    assert ["The pipeline my tutor/pipeline.yaml."] == [variant.about for variant in plan.variants()]
    with pytest.raises(PipelineError, match=r"would both be named 'my-tutor'; rename one of the files"):
        read_pipelines([mine, Path("pipeline.yml")], registry)


def test_a_file_that_is_not_there_is_refused(tmp_path: Path, registry: Registry) -> None:
    with pytest.raises(PipelineError, match=r"nowhere.yaml: there is no such file"):
        read_pipelines([tmp_path / "nowhere.yaml"], registry)


def test_a_key_that_leads_through_a_number_is_refused(files: dict[str, Path], registry: Registry) -> None:
    pipeline = read_pipelines([files["full"]], registry)["full"]
    with pytest.raises(PipelineError, match=r"full.yaml: decisions.x: 'decisions' is 60, not a mapping"):
        read_setting("--set", "decisions.x=3").apply(pipeline)


def test_a_setting_reaches_into_a_part_that_is_named_by_a_word(files: dict[str, Path], registry: Registry) -> None:
    pipeline = read_pipelines([files["alone"]], registry)["alone"]
    changed = read_setting("--set", "world.scene=long").apply(pipeline)
    assert {"use": "corridor", "scene": "long"} == changed.document.data["world"]
    assert "corridor" == pipeline.document.data["world"]


@pytest.mark.parametrize("text", ["..", "../..", "/", "", "...", "a/../b", "\x00"])
def test_a_slug_never_leads_out_of_its_folder(text: str) -> None:
    name = make_slug(text)
    assert name
    assert not name.startswith(".")
    assert not set("/\\\x00") & set(name)
