"""The options of a part as rows of a table."""

from __future__ import annotations

import json
from typing import Any, NamedTuple

from pydantic.fields import FieldInfo

from tutorstudent.core.roles.part import Component
from tutorstudent.core.roles.part_options import ROLE_KEY, PartOption, read_part_option

BOUNDS = (
    ("minimum", ">= {}"),
    ("exclusiveMinimum", "> {}"),
    ("maximum", "<= {}"),
    ("exclusiveMaximum", "< {}"),
    ("minItems", "at least {} items"),
    ("maxItems", "at most {} items"),
)
WORDS = {"object": "mapping", "array": "list", "null": "nothing", "boolean": "true or false"}


class OptionRow(NamedTuple):
    """One option of a part."""

    name: str
    type: str
    """In words, as in ``integer`` or ``a list of conditions``."""
    bounds: str
    required: bool
    default: Any
    """A plain value; None where the option is required or nothing is its default."""
    role: str | None
    """Of the parts that it may hold."""
    description: str


def list_options(cls: type[Component]) -> list[OptionRow]:
    """Return the options of a part class, in the order in which it declares them."""
    schema = cls.Options.model_json_schema()
    return [_make_row(name, field, schema["properties"][name]) for name, field in cls.Options.model_fields.items()]


def read_default(field: FieldInfo) -> Any:
    """Return the default of an option as a plain value: a part by its name, a model by its values."""
    value = field.get_default(call_default_factory=True)
    if isinstance(value, Component):
        return value.name
    return json.loads(json.dumps(value, default=_make_plain))


def _make_plain(value: Any) -> Any:
    if isinstance(value, Component):
        return value.name
    return value.model_dump(mode="json") if hasattr(value, "model_dump") else str(value)


def _make_row(name: str, field: FieldInfo, schema: dict[str, Any]) -> OptionRow:
    part = read_part_option(field.annotation, list(field.metadata))
    required = field.is_required()
    return OptionRow(
        name,
        _describe_parts(part) if part else describe_type(schema),
        ", ".join(list_bounds(schema)),
        required,
        None if required else read_default(field),
        part.role.role if part else None,
        field.description or "",
    )


def _describe_parts(part: PartOption) -> str:
    role = part.role.role
    kinds = [role] * part.one + [f"list of {role}s"] * part.many + ["nothing"] * part.none
    return " or ".join(kinds)


def describe_type(schema: dict[str, Any]) -> str:
    """Return in words what a JSON schema allows.

    >>> describe_type({"anyOf": [{"type": "integer"}, {"type": "null"}]}), describe_type({"enum": ["clip", "wrap"]})
    ('integer or nothing', "'clip' or 'wrap'")
    """
    if "anyOf" in schema:
        return " or ".join(describe_type(item) for item in schema["anyOf"])
    if "const" in schema or "enum" in schema:
        return " or ".join(map(repr, schema.get("enum", [schema.get("const")])))
    if "prefixItems" in schema:
        return f"[{', '.join(describe_type(item) for item in schema['prefixItems'])}]"
    if "items" in schema:
        return f"list of {describe_type(schema['items'])}"
    if "$ref" in schema or ROLE_KEY in schema:
        return str(schema.get(ROLE_KEY, "mapping"))
    found = str(schema.get("type", "any value"))
    return WORDS.get(found, found)


def list_bounds(schema: dict[str, Any]) -> list[str]:
    """Return the bounds that a JSON schema states, as in ``>= 1``.

    >>> list_bounds({"anyOf": [{"type": "integer", "minimum": 1}, {"type": "null"}]})
    ['>= 1']
    """
    own = [text.format(schema[key]) for key, text in BOUNDS if key in schema and "prefixItems" not in schema]
    return own + [bound for item in schema.get("anyOf", []) for bound in list_bounds(item)]
