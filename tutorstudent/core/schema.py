"""A JSON Schema of pipelines, composed from the plugins that are installed."""

from __future__ import annotations

from typing import Any

from pydantic.json_schema import models_json_schema

from tutorstudent.core.component import ROLE_KEY, Component
from tutorstudent.core.limits import Limits
from tutorstudent.core.pipeline import SLOTS, Header
from tutorstudent.core.registry import ROLES, Registry

DIALECT = "https://json-schema.org/draft/2020-12/schema"


def pipeline_schema(registry: Registry) -> dict[str, Any]:
    """Return the schema; editors complete and validate pipelines with it."""
    definitions: dict[str, Any] = {role: _role(role, registry) for role in ROLES}
    for installed in registry:
        definitions |= _component(installed.cls)
    header = Header.model_json_schema()
    _, shared = models_json_schema([(Limits, "validation")])
    return {
        "$schema": DIALECT,
        "title": "tutorstudent pipeline",
        "type": "object",
        "additionalProperties": False,
        "required": ["tutor", "student"],
        "properties": header["properties"]
        | {slot: {"$ref": f"#/$defs/{slot}"} for slot in (*SLOTS, "world")}
        | {
            "conditions": {"type": "array", "items": {"$ref": "#/$defs/condition"}},
            "observers": {"type": "array", "items": {"$ref": "#/$defs/observer"}},
            "limits": {"$ref": "#/$defs/Limits"},
            "on_tutor_failure": {"anyOf": [{"const": "raise"}, {"type": "object", "required": ["kind"]}]},
        },
        "$defs": definitions | shared.get("$defs", {}),
    }


def _role(role: str, registry: Registry) -> dict[str, Any]:
    names = [installed.cls.name for installed in registry.of(role)]
    return {"anyOf": [{"enum": names}, *({"$ref": f"#/$defs/{role}:{name}"} for name in names)]}


def _component(cls: type[Component]) -> dict[str, Any]:
    options = cls.Options.model_json_schema(ref_template=f"#/$defs/{cls.role}:{cls.name}:{{model}}")
    nested = {f"{cls.role}:{cls.name}:{name}": value for name, value in options.pop("$defs", {}).items()}
    described = {
        "type": "object",
        "title": f"{cls.role} {cls.name}",
        "description": " ".join((cls.__doc__ or "").split("\n\n")[0].split()),
        "additionalProperties": False,
        "required": ["use", *options.get("required", [])],
        "properties": {"use": {"const": cls.name}} | options.get("properties", {}),
    }
    return {key: _filled(value) for key, value in ({f"{cls.role}:{cls.name}": described} | nested).items()}


def _filled(node: Any) -> Any:
    """Return a schema in which every place for a component refers to the definition of its role."""
    if isinstance(node, list):
        return [_filled(item) for item in node]
    if not isinstance(node, dict):
        return node
    role = {"$ref": f"#/$defs/{node[ROLE_KEY]}"} if ROLE_KEY in node else {}
    return {key: _filled(value) for key, value in node.items() if key != ROLE_KEY} | role
