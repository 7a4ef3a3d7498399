"""A pipeline file is built, or refused with file, line, column, key and remedy."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.core.toys import PIPELINE, Push, Pusher, toy_registry
from tutorstudent.core.files.pipeline import Pipeline, describe, load
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.core.words.errors import PipelineError, TutorStudentError

REGISTRY = toy_registry()
EXAMPLES = Path(__file__).parents[3] / "examples" / "prototype2" / "tutorstudent_prototype2" / "pipelines"


def pipeline(text: str = PIPELINE) -> Pipeline:
    return Pipeline(parse_yaml(text, "p.yaml"), REGISTRY)


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


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("tutor: pusher", "tutr: pusher", "p.yaml:4:1: tutr: unknown key (did you mean 'tutor'?). Allowed: amplifier,"),
        ("tutor: pusher", "", "p.yaml: there is no 'tutor'; name one, as in 'tutor: {use: ...}'."),
        ("tutor: pusher", "tutor: pushr", "p.yaml:4:1: tutor: no tutor named 'pushr' (did you mean 'pusher'?)."),
        ("tutor: pusher", "tutor: 7", "p.yaml:4:1: tutor: found 7; a tutor is named by a word or by a mapping"),
        ("tutor: pusher", "tutor: {name: pusher}", "p.yaml:4:1: tutor: there is no 'use' in it; name a tutor and"),
        ("use: table", "use: table\n  hiden: 3", "p.yaml:7:3: student.hiden: student 'table': unknown option 'hiden'"),
        ("steps: 4", "steps: 0", "p.yaml:7:44: student.encoder.steps: encoder 'ranges': option 'steps': input should"),
        ("use: ranges", "use: rangs", "p.yaml:7:13: student.encoder.use: no encoder named 'rangs' (did you mean"),
        ("encoder: {", "encodr: {", "p.yaml:7:3: student.encodr: student 'table': unknown option 'encodr'"),
        (
            "seed: 3",
            "seed: -3",
            "p.yaml:1:1: seed: pipeline: option 'seed': input should be greater than or equal to 0",
        ),
        ("seed: 3", "seed: x", "p.yaml:1:1: seed: pipeline: option 'seed': input should be a valid integer"),
        ("decisions: 50", "decisions: 0", "p.yaml:2:1: decisions: pipeline: option 'decisions': input should be"),
        ("[crashed]", "[crashd]", "p.yaml:11:14: conditions.0: no condition named 'crashd' (did you mean 'crashed'?)"),
        ("[crashed]", "crashed", "p.yaml:11:1: conditions: found 'crashed'; write a list, as in [name]"),
        ("[crashed]", "[crashed, crashed]", "p.yaml:11:23: conditions.1: condition 'crashed' stands there twice"),
        ("length_m: 5", "length_m: -5", "p.yaml:3:20: world.length_m: world 'rail': option 'length_m': input should"),
        ("world: {use: rail, length_m: 5}", "", "p.yaml: there is no 'world'; add one, as in"),
        ("same-kind", "modifier", "p.yaml:9:1: selector: selector 'modifier' needs LevelProposal but student 'table'"),
        ("seed: 3", "limits: {cap: 0}", "p.yaml:1:10: limits.cap: limits: option 'cap': input should be greater than"),
        ("seed: 3", "limits: 0.8", "p.yaml:1:1: limits: found 0.8; write a mapping, as in limits: {cap: 0.8}."),
        ("seed: 3", "on_incident: shrug", "p.yaml:1:1: on_incident: pipeline: option 'on_incident': input should be"),
        (
            "seed: 3",
            "on_tutor_failure: stop",
            "p.yaml:1:1: on_tutor_failure: found 'stop'. Write 'raise' or an action, as in on_tutor_failure: {",
        ),
        ("decisions: 50", "decisions: 2000000000", "p.yaml:2:1: decisions: pipeline: option 'decisions': input should"),
        ("seed: 3", "on_tutor_failure: {kind: stp}", "p.yaml:1:20: on_tutor_failure.kind: not a Push: option 'kind'"),
    ],
)
def test_a_mistake_is_told_with_place_and_remedy(old: str, new: str, message: str) -> None:
    text = PIPELINE.replace("[[0, 5]]}", "[[0, 5]], steps: 4}")
    assert old in text
    with pytest.raises(TutorStudentError) as caught:
        build(text.replace(old, new))
    assert message in str(caught.value)


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
