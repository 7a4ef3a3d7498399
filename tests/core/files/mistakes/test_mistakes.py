"""Every mistake in a pipeline is one sentence with file, line, column and key, and what to do."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.core.files.mistakes.table import BASE, KEYS, PARTS, SYNTAX, VALUES, WIRING, Mistake
from tests.core.toys import toy_registry
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.settings import read_settings
from tutorstudent.core.words.errors import PipelineError, TutorStudentError

REGISTRY = toy_registry()


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def build(text: str, values: dict[str, Any] | None = None) -> None:
    Path("p.yaml").write_text(text)
    with Pipeline.read("p.yaml", REGISTRY).replaced(values or {}).built():
        pass


def complaint(text: str, values: dict[str, Any] | None = None) -> str:
    with pytest.raises(TutorStudentError) as caught:
        build(text, values)
    return str(caught.value)


def test_the_pipeline_without_mistakes_builds() -> None:
    build(BASE)


@pytest.mark.parametrize(
    "mistake",
    [*SYNTAX, *VALUES, *KEYS, *PARTS, *WIRING],
    ids=lambda mistake: mistake.new.strip()[:40] or mistake.old[:20],
)
def test_a_mistake_is_told_with_place_key_and_remedy(mistake: Mistake) -> None:
    assert mistake.old in BASE
    said = complaint(BASE.replace(mistake.old, mistake.new, 1))
    key = f" {mistake.key}:" if mistake.key else ""
    place = f"p.yaml:{mistake.place}:" if mistake.place else "p.yaml:"
    assert said.startswith(f"{place}{key}")
    assert [] == [word for word in mistake.words if word not in said]
    assert "\n" not in said
    assert said.endswith((".", ".'"))


@pytest.mark.parametrize(
    ("setting", "key", "words"),
    [
        ("seed=-1", "seed", ("greater than or equal to 0",)),
        ("sed=1", "sed", ("unknown key", "did you mean 'seed'?")),
        ("student.hiden=10", "student.hiden", ("unknown option", "did you mean 'hidden'?")),
        ("student.hidden=ten", "student.hidden", ("valid integer", "found 'ten'")),
        ("student.encoder.steps=0", "student.encoder.steps", ("encoder 'ranges'",)),
        ("student.encoder=rangs", "student.encoder", ("no encoder named", "did you mean 'ranges'?")),
        ("student.use=tabel", "student.use", ("no student named", "did you mean 'table'?")),
        ("student.use=table", "student.hidden", ("unknown option 'hidden'",)),
        ("tutor.speed=3", "tutor.speed", ("unknown option 'speed'",)),
        ("selector=modifier", "selector", ("needs LevelProposal",)),
        ("limits.cap=none", "limits.cap", ("valid number",)),
        ("conditions=crashed", "conditions", ("write a list",)),
        ("conditions=[crashed, crashd]", "conditions.1", ("no condition named",)),
        ("on_tutor_failure.kind=stop", "on_tutor_failure.kind", ("'push' or 'rest'",)),
        ("extends=other.yaml", "extends", ("works only in a file",)),
        ("learned=absent.npz", "learned", ("absent.npz",)),
    ],
)
def test_a_mistake_in_a_setting_names_setting_and_option(setting: str, key: str, words: tuple[str, ...]) -> None:
    said = complaint(BASE, read_settings("--set", [setting]))
    head, _, rest = said.partition(f": {key}: ")
    assert rest
    assert head.startswith("p.yaml")
    assert [] == [word for word in words if word not in rest]
    if key == setting.partition("=")[0]:
        assert setting.partition("=")[0] in head


@pytest.mark.parametrize(
    ("setting", "message"),
    [
        ("seed", "--set seed: write key=value, as in --set world.scene=cave-box."),
        ("=3", "--set =3: write key=value"),
        ("student..hidden=3", "--set student..hidden=3: write key=value"),
        (".=3", "--set .=3: write key=value"),
        ("seed=[1", "--set seed=[1:1:1: not valid YAML: the '[' that opens here is not closed"),
        ("seed=!x 1", "--set seed=!x 1:1:1: the tag '!x' is not allowed"),
        ("conditions.0=near", "p.yaml: conditions.0: 'conditions' is ["),
        ("seed.x=3", "p.yaml: seed.x: 'seed' is 3, not a mapping; set 'seed' itself."),
    ],
)
def test_a_setting_that_cannot_be_read_says_how_it_is_written(setting: str, message: str) -> None:
    Path("p.yaml").write_text(BASE)
    with pytest.raises(PipelineError) as caught:
        Pipeline.read("p.yaml", REGISTRY).replaced(read_settings("--set", [setting]))
    assert str(caught.value).startswith(message)


def test_an_action_can_be_set_where_the_file_says_raise() -> None:
    build(f"{BASE}on_tutor_failure: raise\n", {"on_tutor_failure.kind": "rest"})


@pytest.mark.parametrize("text", ["", "# nothing\n", "tutor", "- tutor: x\n", "3"])
def test_a_file_that_holds_no_mapping_is_told_what_it_should_hold(text: str) -> None:
    assert "a pipeline is a mapping with the keys extends, seed," in complaint(text)
