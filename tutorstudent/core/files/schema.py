"""A JSON Schema of pipelines, composed from the plugins that are installed."""

from __future__ import annotations

import json
from typing import Any

from pydantic.json_schema import models_json_schema

from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.files.defaults import DEFAULTS, ONE_KIND
from tutorstudent.core.files.extending import EXTENDS
from tutorstudent.core.files.optiontable import read_default
from tutorstudent.core.files.pipeline import Header
from tutorstudent.core.files.registry import ROLES, Registry
from tutorstudent.core.roles.interfaces import SLOTS
from tutorstudent.core.roles.part import Component
from tutorstudent.core.roles.part_options import ROLE_KEY

DIALECT = "https://json-schema.org/draft/2020-12/schema"
EXTENDING = "extending:"
"""Prefix of the definitions for files that extend another; every key and option may be left out there."""


def make_schema(registry: Registry) -> dict[str, Any]:
    """Return the schema; editors complete and validate pipelines with it."""
    definitions: dict[str, Any] = {role: _make_role(role, registry) for role in ROLES}
    for installed in registry:
        definitions |= _make_part(installed.cls)
    _, shared = models_json_schema([(Limits, "validation")])
    definitions |= shared.get("$defs", {})
    whole = {"properties": _make_properties(), "required": ["tutor", "student"]}
    return {
        "$schema": DIALECT,
        "title": "tutorstudent pipeline",
        "type": "object",
        "additionalProperties": False,
        "properties": {EXTENDS: _EXTENDS} | {key: {} for key in _make_properties()},
        "if": {"required": [EXTENDS]},
        "then": _make_partial(whole),
        "else": whole,
        "$defs": definitions | {f"{EXTENDING}{name}": _make_partial(value) for name, value in definitions.items()},
    }


_EXTENDS = {
    "type": "string",
    "minLength": 1,
    "description": "another pipeline file, relative to this one; this file says only what differs",
}


def _make_properties() -> dict[str, Any]:
    properties: dict[str, Any] = Header.model_json_schema()["properties"]
    slots = {slot: {"$ref": f"#/$defs/{slot}", "description": read_summary(ROLES[slot])} for slot in (*SLOTS, "world")}
    others = {
        "conditions": _make_list("condition", "what must not be true of the state after an action"),
        "observers": _make_list("observer", "what counts and measures beside the run"),
        "limits": {"$ref": "#/$defs/Limits", "description": read_summary(Limits)},
        "on_tutor_failure": {
            "anyOf": [{"const": "raise"}, {"type": "object"}],
            "description": "what is executed where the tutor fails: an action of its class, or 'raise'",
        },
    }
    for key, value in (slots | others).items():
        properties[key] = value | _describe_default(key, value["description"])
    return properties


def _describe_default(key: str, description: str) -> dict[str, Any]:
    """Return the default of a key; in words where it depends on how many kinds the tutor's actions have."""
    if key in ONE_KIND:
        several = json.dumps(DEFAULTS[key]) if key in DEFAULTS else "required"
        left_out = f"if left out, with actions of one kind: {json.dumps(ONE_KIND[key])}; with several: {several}"
        return {"description": f"{description.rstrip('.')}; {left_out}"}
    return {"default": DEFAULTS[key]} if key in DEFAULTS else {}


def _make_list(role: str, description: str) -> dict[str, Any]:
    return {"type": "array", "items": {"$ref": f"#/$defs/{role}"}, "description": description}


def _make_partial(node: Any) -> Any:
    """Return a schema without required keys, for values that are merged with those of another file."""
    if isinstance(node, list):
        return [_make_partial(item) for item in node]
    if not isinstance(node, dict):
        return node
    lead = "#/$defs/"
    reference = {"$ref": node["$ref"].replace(lead, f"{lead}{EXTENDING}")} if isinstance(node.get("$ref"), str) else {}
    kept = {key: value for key, value in node.items() if key != "required" or not isinstance(value, list)}
    return {key: _make_partial(value) for key, value in kept.items()} | reference


def _make_role(role: str, registry: Registry) -> dict[str, Any]:
    classes = [installed.cls for installed in registry.of(role)]
    words = [{"const": cls.name, "description": read_summary(cls)} for cls in classes]
    return {"anyOf": [*words, *({"$ref": f"#/$defs/{role}:{cls.name}"} for cls in classes)] or [False]}


def read_summary(cls: type[Any]) -> str:
    """Return the first paragraph of a class's documentation, in one line."""
    return " ".join((cls.__doc__ or "").split("\n\n")[0].split())


def _make_part(cls: type[Component]) -> dict[str, Any]:
    options = cls.Options.model_json_schema(ref_template=f"#/$defs/{cls.role}:{cls.name}:{{model}}")
    nested = {f"{cls.role}:{cls.name}:{name}": value for name, value in options.pop("$defs", {}).items()}
    described = {
        "type": "object",
        "title": f"{cls.role} {cls.name}",
        "description": read_summary(cls),
        "additionalProperties": False,
        "required": ["use", *options.get("required", [])],
        "properties": {"use": {"const": cls.name, "description": read_summary(cls)}} | _add_defaults(cls, options),
    }
    return {key: _fill_parts(value) for key, value in ({f"{cls.role}:{cls.name}": described} | nested).items()}


def _add_defaults(cls: type[Component], options: dict[str, Any]) -> dict[str, Any]:
    # What pydantic leaves out: defaults that are made anew each time, such as parts.
    made = {name: field for name, field in cls.Options.model_fields.items() if field.default_factory}
    return {
        name: value | ({"default": read_default(made[name])} if name in made else {})
        for name, value in options.get("properties", {}).items()
    }


def _fill_parts(node: Any) -> Any:
    """Return a schema in which every part refers to the definition of its role."""
    if isinstance(node, list):
        return [_fill_parts(item) for item in node]
    if not isinstance(node, dict):
        return node
    role = {"$ref": f"#/$defs/{node[ROLE_KEY]}"} if ROLE_KEY in node else {}
    return {key: _fill_parts(value) for key, value in node.items() if key != ROLE_KEY} | role
