"""The schema is composed from what is installed, and agrees with what the assembler takes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import jsonschema
import pytest

from tests.core.toys import PIPELINE, toy_registry
from tutorstudent.core.pipeline import KEYS
from tutorstudent.core.registry import Registry
from tutorstudent.core.schema import pipeline_schema
from tutorstudent.core.yamlfile import parse_yaml, read_yaml

ROOT = Path(__file__).parents[2]
SHIPPED = sorted((ROOT / "examples" / "prototype2" / "tutorstudent_prototype2" / "pipelines").glob("*.yaml"))


@pytest.fixture(scope="module")
def schema() -> dict[str, Any]:
    return pipeline_schema(toy_registry())


def test_the_schema_is_a_schema(schema: dict[str, Any]) -> None:
    jsonschema.Draft202012Validator.check_schema(schema)


def test_the_schema_knows_the_keys_of_a_pipeline(schema: dict[str, Any]) -> None:
    assert set(KEYS) == set(schema["properties"])


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_shipped_pipelines_validate(path: Path) -> None:
    jsonschema.validate(read_yaml(path).data, pipeline_schema(Registry.discover()))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "seed: 5",
        "student: {encoder: {steps: 4}}",
        "student: {use: backprop, encoder: {use: ranges}}",
        "student: table",
        "world: {length_m: 2}",
        "limits: {factor: 2}",
        "conditions: [crashed]",
    ],
)
def test_a_file_that_extends_another_says_only_what_differs(schema: dict[str, Any], text: str) -> None:
    jsonschema.validate(parse_yaml(f"extends: base.yaml\n{text}", "p").data, schema)


@pytest.mark.parametrize(
    "text",
    ["extends: 7", "extends: ''", "extends: b\ntutr: x", "extends: b\nseed: x", "extends: b\nstudent: {hiden: 3}"],
)
def test_a_file_that_extends_another_is_checked_too(schema: dict[str, Any], text: str) -> None:
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(parse_yaml(text, "p").data, schema)


def test_a_file_that_extends_nothing_names_tutor_and_student(schema: dict[str, Any]) -> None:
    with pytest.raises(jsonschema.ValidationError, match="'tutor' is a required property"):
        jsonschema.validate(parse_yaml("seed: 5", "p").data, schema)


def test_every_reference_of_the_schema_leads_somewhere(schema: dict[str, Any]) -> None:
    def references(node: Any) -> list[str]:
        if isinstance(node, dict):
            own = [node["$ref"]] if isinstance(node.get("$ref"), str) else []
            return own + [ref for value in node.values() for ref in references(value)]
        return [ref for item in node for ref in references(item)] if isinstance(node, list) else []

    found = references(schema)
    assert found
    assert set() == {ref for ref in found if ref.removeprefix("#/$defs/") not in schema["$defs"]}


def test_every_option_of_every_component_is_described(schema: dict[str, Any]) -> None:
    bare = [
        f"{name}.{option}"
        for name, definition in schema["$defs"].items()
        if ":" in name and "rail" not in name
        for option, value in definition.get("properties", {}).items()
        if option not in ("use", "kind") and "description" not in value
    ]
    assert [] == bare


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("tutor: pusher", "tutr: pusher"),
        ("tutor: pusher", "tutor: pushr"),
        ("use: table", "use: table\n  hiden: 3"),
        ("seed: 3", "seed: -3"),
        ("[crashed]", "crashed"),
        ("length_m: 5", "length_m: -5"),
        ("decisions: 10", "decisions: -1"),
    ],
)
def test_what_the_assembler_refuses_the_schema_refuses(schema: dict[str, Any], old: str, new: str) -> None:
    jsonschema.validate(parse_yaml(PIPELINE, "p").data, schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(parse_yaml(PIPELINE.replace(old, new), "p").data, schema)
