"""A pipeline file is built, or refused with file, line, column, key and remedy."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.core.toys import PIPELINE, Push, Pusher, toy_pipeline, toy_registry
from tutorstudent.core.files.pipeline import Pipeline, describe, load
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.core.words.errors import PipelineError

REGISTRY = toy_registry()
EXAMPLES = Path(__file__).parents[3] / "examples" / "prototype2" / "tutorstudent_prototype2" / "pipelines"


def pipeline(text: str = PIPELINE) -> Pipeline:
    return toy_pipeline(text, REGISTRY)


def build(text: str) -> Any:
    found = pipeline(text)
    engine = found.engine()
    return engine, found.world(engine.tutor.action)


def test_a_pipeline_builds_its_parts_under_their_slots() -> None:
    engine, world = build(PIPELINE)
    assert ["tutor", "student", "selector", "amplifier", "evaluator", "conditions.crashed"] == [
        slot for slot, _ in engine.slots()
    ]
    assert "student.encoder" == engine.student.options.encoder.slot
    assert "world" == world.slot


def test_a_pipeline_that_is_no_mapping_is_refused() -> None:
    with pytest.raises(PipelineError, match=r"p.yaml: found \['tutor'\]; a pipeline is a mapping with the keys"):
        pipeline("- tutor\n")


def test_a_failure_action_is_written_in_the_pipeline() -> None:
    engine, _ = build(PIPELINE + "on_tutor_failure: {kind: rest}\n")
    assert Push(kind="rest") == engine.on_tutor_failure


def test_replaced_values_take_the_place_of_the_files() -> None:
    changed = pipeline().replaced({"seed": 9, "student.teaching": 1, "tutor.use": "pusher", "world.length_m": 2})
    assert 9 == changed.header.seed
    assert {"use": "pusher"} == changed.document.data["tutor"]
    assert 2 == changed.document.data["world"]["length_m"]
    assert 5 == pipeline().document.data["world"]["length_m"]


def test_the_resolved_pipeline_builds_the_same_again() -> None:
    found = pipeline()
    engine = found.engine()
    resolved = describe(engine, found.world(Push), found)
    again = Pipeline(parse_yaml("{}", "x")._replace(data=resolved), REGISTRY)
    engine_again = again.engine()
    assert resolved == describe(engine_again, again.world(Push), again)


def test_load_takes_a_tutor_and_a_callable(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("student: silent\nselector: modifier\namplifier: never\n")
    assert Push(kind="push", force=0.2) == load(path, tutor=Pusher()).step(1.0)
    assert Push(kind="rest") == load(path, tutor=lambda _: Push(kind="rest"), action=Push).step(1.0)


def test_load_refuses_a_slot_that_is_not_there(tmp_path: Path) -> None:
    path = tmp_path / "p.yaml"
    path.write_text("student: silent\nselector: modifier\namplifier: never\n")
    message = r"there is no slot 'studnet' for a part of your own \(did you mean 'student'\?\). Slots: amplifier, cond"
    with pytest.raises(PipelineError, match=message):
        load(path, tutor=Pusher(), studnet=object())
    with pytest.raises(PipelineError, match="'action' is the action class of a callable tutor; give the tutor too"):
        load(path, action=Push)


def test_parts_that_are_given_take_the_place_of_the_files_even_where_they_are_empty() -> None:
    assert 1 == len(pipeline().engine().conditions)
    assert () == pipeline().engine(conditions=[]).conditions
    given = Hollow()
    assert given is pipeline().engine(tutor=given).tutor


class Hollow(Pusher):
    """A tutor that is false in a condition."""

    def __len__(self) -> int:
        return 0


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.yaml")), ids=lambda path: path.stem)
def test_the_shipped_pipelines_build(path: Path) -> None:
    assert Pipeline.read(path, Registry.discover()).engine()


def test_the_streamlined_pipeline_differs_from_the_full_one_in_two_values() -> None:
    full = Pipeline.read(EXAMPLES / "prototype2a.yaml").document.data
    streamlined = Pipeline.read(EXAMPLES / "streamlined.yaml").document.data
    differing = {key for key in full if full[key] != streamlined[key]}
    assert {"student", "selector"} == differing
    assert {"codec"} == {key for key in full["student"] if full["student"][key] != streamlined["student"][key]}
    assert full.keys() == streamlined.keys()
