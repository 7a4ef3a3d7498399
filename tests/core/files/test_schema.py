"""The schema is composed from what is installed, and agrees with what the assembler takes."""

from __future__ import annotations

from contextlib import closing
from importlib import metadata
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from tests.core.toys import PIPELINE, toy_registry
from tutorstudent.core.files.pipeline import KEYS, Pipeline
from tutorstudent.core.files.plainvalues import make_plain
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.schema import make_schema
from tutorstudent.core.files.yamlfile import parse_yaml, read_yaml
from tutorstudent.core.roles.interfaces import SLOTS

ROOT = Path(__file__).parents[3]
SHIPPED = sorted((ROOT / "examples").rglob("*.yaml"))


def validate(data: Any, schema: dict[str, Any]) -> None:
    jsonschema.Draft202012Validator(schema).validate(data)


@pytest.fixture(scope="module")
def schema() -> dict[str, Any]:
    return make_schema(toy_registry())


def test_the_schema_is_a_schema(schema: dict[str, Any]) -> None:
    jsonschema.Draft202012Validator.check_schema(schema)


def test_the_schema_knows_the_keys_of_a_pipeline(schema: dict[str, Any]) -> None:
    assert set(KEYS) == set(schema["properties"])


@pytest.fixture(scope="module")
def installed() -> dict[str, Any]:
    return make_schema(Registry.discover())


def is_pipeline(path: Path) -> bool:
    data = read_yaml(path).data
    return "extends" in data or {"tutor", "student"} <= set(data)


@pytest.mark.parametrize("path", [path for path in SHIPPED if is_pipeline(path)], ids=lambda path: path.stem)
def test_every_pipeline_of_the_examples_validates(installed: dict[str, Any], path: Path) -> None:
    if path.is_relative_to(ROOT / "examples" / "controllers"):
        needs("tutorstudent-controllers")
    validate(read_yaml(path).data, installed)


def needs(distribution: str) -> None:
    try:
        metadata.version(distribution)
    except metadata.PackageNotFoundError:
        pytest.skip(f"{distribution} is not installed")


def test_a_resolved_pipeline_validates(installed: dict[str, Any]) -> None:
    pipeline = Pipeline.read(ROOT / "examples/prototype2/tutorstudent_prototype2/pipelines/prototype2a.yaml")
    with closing(pipeline.engine()) as engine:
        described = {slot: make_plain(getattr(engine, slot).describe(), slot) for slot in SLOTS}
    validate(described | {"world": "pioneer"}, installed)


def test_names_of_plugins_options_and_keys_are_described_with_defaults_and_bounds(schema: dict[str, Any]) -> None:
    words = {item["const"]: item["description"] for item in schema["$defs"]["student"]["anyOf"] if "const" in item}
    assert {"backprop", "table", "silent"} <= set(words)
    assert all(words.values())
    hidden = schema["$defs"]["student:backprop"]["properties"]["hidden"]
    assert (30, 1, 10_000, "hidden neurons") == tuple(
        hidden[k] for k in ("default", "minimum", "maximum", "description")
    )
    assert "kind-level-ampbit" == schema["$defs"]["student:backprop"]["properties"]["codec"]["default"]
    keys = schema["else"]["properties"]
    assert [] == [key for key, value in keys.items() if not value.get("description")]
    assert "conditions" == keys["evaluator"]["default"]
    left_out = 'if left out, with actions of one kind: "modifier"; with several: "same-kind"'
    assert keys["selector"]["description"].endswith(left_out)


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
    validate(parse_yaml(f"extends: base.yaml\n{text}", "p").data, schema)


@pytest.mark.parametrize(
    "text",
    ["extends: 7", "extends: ''", "extends: b\ntutr: x", "extends: b\nseed: x", "extends: b\nstudent: {hiden: 3}"],
)
def test_a_file_that_extends_another_is_checked_too(schema: dict[str, Any], text: str) -> None:
    with pytest.raises(jsonschema.ValidationError):
        validate(parse_yaml(text, "p").data, schema)


def test_a_file_that_extends_nothing_names_tutor_and_student(schema: dict[str, Any]) -> None:
    with pytest.raises(jsonschema.ValidationError, match="'tutor' is a required property"):
        validate(parse_yaml("seed: 5", "p").data, schema)


def test_every_reference_of_the_schema_leads_somewhere(schema: dict[str, Any]) -> None:
    def references(node: Any) -> list[str]:
        if isinstance(node, dict):
            own = [node["$ref"]] if isinstance(node.get("$ref"), str) else []
            return own + [ref for value in node.values() for ref in references(value)]
        return [ref for item in node for ref in references(item)] if isinstance(node, list) else []

    found = references(schema)
    assert found
    assert set() == {ref for ref in found if ref.removeprefix("#/$defs/") not in schema["$defs"]}


def test_every_option_of_every_part_is_described(schema: dict[str, Any]) -> None:
    options = {
        f"{name}.{option}": value
        for name, definition in schema["$defs"].items()
        if ":" in name and "rail" not in name
        for option, value in definition.get("properties", {}).items()
        if option not in ("use", "kind")
    }
    assert 50 < len(options)
    assert [] == [name for name, value in options.items() if "description" not in value]


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
    validate(parse_yaml(PIPELINE, "p").data, schema)
    with pytest.raises(jsonschema.ValidationError):
        validate(parse_yaml(PIPELINE.replace(old, new), "p").data, schema)
