"""A pipeline says only what differs from another; every value knows the file in which it stands."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.core.toys import PIPELINE, toy_registry
from tutorstudent.core.files.extending import read_extended
from tutorstudent.core.files.pipeline import Pipeline, describe
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.core.words.errors import PipelineError, TutorStudentError

REGISTRY = toy_registry()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The working directory, with the toy pipeline in it."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "base.yaml").write_text(PIPELINE)
    return tmp_path


def child(text: str, base: str = "base.yaml") -> dict[str, Any]:
    Path("child.yaml").write_text(f"extends: {base}\n{text}")
    data: dict[str, Any] = read_extended(Path("child.yaml")).data
    return data


def built(path: str) -> dict[str, Any]:
    pipeline = Pipeline.read(path, REGISTRY)
    with pipeline.built() as (engine, world, _):
        return describe(engine, world, pipeline)


@pytest.mark.usefixtures("folder")
def test_a_file_that_only_extends_says_what_the_other_says() -> None:
    assert parse_yaml(PIPELINE, "p").data == child("")


@pytest.mark.usefixtures("folder")
def test_the_resolved_pipeline_is_the_merged_one_and_extends_nothing() -> None:
    child("student: {encoder: {steps: 4}}\nseed: 5\n")
    Path("whole.yaml").write_text(PIPELINE.replace("[[0, 5]]}", "[[0, 5]], steps: 4}").replace("seed: 3", "seed: 5"))
    assert built("whole.yaml") == built("child.yaml")
    assert "extends" not in built("child.yaml")


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("base", "own", "merged"),
    [
        ("a: 1\nb: 2", "b: 3\nc: 4", {"a": 1, "b": 3, "c": 4}),
        ("a: {b: {c: 1, d: 2}}", "a: {b: {c: 3}}", {"a": {"b": {"c": 3, "d": 2}}}),
        ("a: [1, 2]", "a: [3]", {"a": [3]}),
        ("a: {b: 1}", "a: [3]", {"a": [3]}),
        ("a: {b: 1}", "a: null", {"a": None}),
        ("a: {b: 1}", "a: {}", {"a": {"b": 1}}),
        ("a: {use: x, n: 1}", "a: {n: 2}", {"a": {"use": "x", "n": 2}}),
        ("a: {use: x, n: 1}", "a: {use: x, m: 2}", {"a": {"use": "x", "n": 1, "m": 2}}),
        ("a: {use: x, n: 1}", "a: {use: y, m: 2}", {"a": {"use": "y", "m": 2}}),
        ("a: {use: x, n: 1}", "a: y", {"a": "y"}),
        ("a: {use: x, n: 1}", "a: x", {"a": {"use": "x", "n": 1}}),
        ("a: x", "a: {n: 1}", {"a": {"use": "x", "n": 1}}),
        ("a: x", "a: y", {"a": "y"}),
        ("a: {n: 1}", "a: {use: x, m: 2}", {"a": {"use": "x", "n": 1, "m": 2}}),
        ("a: {use: x, p: {use: q, n: 1}}", "a: {p: {use: r}}", {"a": {"use": "x", "p": {"use": "r"}}}),
        ("on_tutor_failure: raise", "on_tutor_failure: {kind: rest}", {"on_tutor_failure": {"kind": "rest"}}),
        (
            "on_tutor_failure: {kind: push, force: 1}",
            "on_tutor_failure: {kind: rest}",
            {"on_tutor_failure": {"kind": "rest"}},
        ),
    ],
)
def test_mappings_are_merged_and_the_options_of_another_part_are_dropped(
    base: str, own: str, merged: dict[str, Any]
) -> None:
    Path("base.yaml").write_text(base)
    assert merged == child(own)


@pytest.mark.usefixtures("folder")
def test_a_chain_is_followed_and_the_nearest_file_wins() -> None:
    Path("middle.yaml").write_text("extends: base.yaml\nseed: 4\ndecisions: 60\n")
    data = child("seed: 5\n", "middle.yaml")
    assert (5, 60, "pusher") == (data["seed"], data["decisions"], data["tutor"])


def test_the_path_is_relative_to_the_file(folder: Path) -> None:
    (folder / "below").mkdir()
    (folder / "below" / "child.yaml").write_text("extends: ../base.yaml\n")
    assert "pusher" == read_extended(folder / "below" / "child.yaml").data["tutor"]


@pytest.mark.usefixtures("folder")
def test_every_value_has_its_place_in_its_own_file() -> None:
    Path("middle.yaml").write_text("extends: base.yaml\nseed: 4\nstudent:\n  teaching: 1\n")
    Path("child.yaml").write_text("extends: middle.yaml\n\ndecisions: 9\n")
    document = read_extended(Path("child.yaml"))
    assert "child.yaml:3:1: decisions" == document.locate(("decisions",))
    assert "middle.yaml:2:1: seed" == document.locate(("seed",))
    assert "middle.yaml:4:3: student.teaching" == document.locate(("student", "teaching"))
    assert "base.yaml:6:3: student.use" == document.locate(("student", "use"))


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("base", "own", "message"),
    [
        ("table", "seed: -1", "child.yaml:2:1: seed: pipeline: option 'seed': input should be greater"),
        ("table\n  hiden: 3", "seed: 1", "base.yaml:7:3: student.hiden: student 'table': unknown option 'hiden'"),
        ("table", "student: {hiden: 3}", "child.yaml:2:11: student.hiden: student 'table': unknown option 'hiden'"),
        ("tabel", "student: {encoder: {steps: 3}}", "base.yaml:6:3: student.use: no student named 'tabel' (did you"),
        ("table", "student: {use: tabel}", "child.yaml:2:11: student.use: no student named 'tabel' (did you mean"),
        ("table", "student: tabel", "child.yaml:2:1: student: no student named 'tabel' (did you mean 'table'?)"),
        ("table", "conditions: [crashd]", "child.yaml:2:14: conditions.0: no condition named 'crashd'"),
        ("table", "selector: modifier", "child.yaml:2:1: selector: selector 'modifier' needs LevelProposal but"),
        ("table", "tutr: pusher", "child.yaml:2:1: tutr: unknown key (did you mean 'tutor'?). Allowed: amplifier,"),
    ],
)
def test_a_mistake_is_told_in_the_file_in_which_it_stands(base: str, own: str, message: str) -> None:
    Path("base.yaml").write_text(PIPELINE.replace("use: table", f"use: {base}"))
    child(own)
    with pytest.raises(TutorStudentError) as caught:
        built("child.yaml")
    assert str(caught.value).startswith(message)


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("named", "message"),
    [
        ("bse.yaml", "child.yaml:1:1: extends: there is no file bse.yaml. The path is relative to the file"),
        ("below", "child.yaml:1:1: extends: there is no file below."),
        (f"{'x' * 999}.yaml", "child.yaml:1:1: extends: there is no file xxx"),
        ('"a\\0b"', "child.yaml:1:1: extends: there is no file a\0b."),
        ("/etc/base.yaml", "child.yaml:1:1: extends: found the absolute path /etc/base.yaml; write it relative to"),
        ("child.yaml", "child.yaml:1:1: extends: the files extend each other in a circle: child.yaml -> child.yaml;"),
        ("../FOLDER/child.yaml", "child.yaml:1:1: extends: the files extend each other in a circle: child.yaml -> ../"),
        ("turn.yaml", "turn.yaml:2:1: extends: the files extend each other in a circle: child.yaml -> turn.yaml -> ch"),
        ("[a.yaml, b.yaml]", "child.yaml:1:1: extends: found ['a.yaml', 'b.yaml']; write the path of one YAML file"),
        ("", "child.yaml:1:1: extends: found None; write the path of one YAML file, as in extends: base.yaml."),
        ("''", "child.yaml:1:1: extends: found ''; write the path"),
        ("7", "child.yaml:1:1: extends: found 7; write the path of one"),
        ("list.yaml", "child.yaml:1:1: extends: list.yaml holds no mapping; extend a pipeline."),
        ("empty.yaml", "child.yaml:1:1: extends: empty.yaml holds no mapping; extend a pipeline."),
        ("torn.yaml", "torn.yaml:2:4: not valid YAML:"),
        ("bytes.yaml", "bytes.yaml:1:1: cannot be read:"),
    ],
)
def test_a_file_that_cannot_be_extended_is_refused_with_its_place(named: str, message: str) -> None:
    here = Path.cwd()
    (here / "below").mkdir()
    (here / "turn.yaml").write_text("\nextends: child.yaml\n")
    (here / "list.yaml").write_text("- 1\n")
    (here / "empty.yaml").write_text("\n")
    (here / "torn.yaml").write_text("a: 1\n  b: 2\n")
    (here / "bytes.yaml").write_bytes(b"\xff")
    with pytest.raises(PipelineError) as caught:
        child("", named.replace("FOLDER", here.name))
    assert str(caught.value).startswith(message)


@pytest.mark.usefixtures("folder")
def test_extends_cannot_be_set_from_elsewhere() -> None:
    pipeline = Pipeline.read("base.yaml", REGISTRY)
    message = r"base.yaml \(with extends=other.yaml\): extends: 'extends' works only in a file; write it there"
    with pytest.raises(PipelineError, match=message):
        pipeline.replaced({"extends": "other.yaml"})


@pytest.mark.usefixtures("folder")
def test_what_is_set_takes_the_place_of_what_is_extended() -> None:
    child("student: {encoder: {steps: 4}}\n")
    changed = Pipeline.read("child.yaml", REGISTRY).replaced({"student.encoder.steps": -1})
    with pytest.raises(PipelineError) as caught:
        changed.engine()
    assert str(caught.value).startswith("child.yaml (with student.encoder.steps=-1): student.encoder.steps: encoder")
