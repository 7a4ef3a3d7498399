"""Options that hold parts: how they are marked and recognised."""

from __future__ import annotations

from types import UnionType
from typing import Annotated, Any, NamedTuple, TypeVar, Union, get_args, get_origin

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, core_schema

from tutorstudent.core.roles.part import Component

ROLE_KEY = "x-role"
"""Marks, in an option's JSON schema, where any part of a role may be; `schema.make_schema` fills it in."""


class PartMarker:
    """Marks an option that holds a nested part of one role."""

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.is_instance_schema(get_origin(source) or source)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        found: Any = schema
        while "cls" not in found:  # validators stand round it
            found = found["schema"]
        return {ROLE_KEY: found["cls"].role}


_T = TypeVar("_T")
Part = Annotated[_T, PartMarker()]
"""An option that is itself a part: ``encoder: ts.Part[ts.Encoder]``."""


class PartOption(NamedTuple):
    """An option that holds parts."""

    role: type[Component]
    one: bool
    """Whether it may hold a single part."""
    many: bool
    """Whether it may hold a list of parts."""
    none: bool
    """Whether nothing may."""


def read_part_option(annotation: Any, metadata: list[Any]) -> PartOption | None:
    """Return which part an option's annotation asks for, or None if it asks for none.

    >>> read_part_option(int, []) is None
    True
    """
    if any(isinstance(item, PartMarker) for item in metadata):
        found = get_origin(annotation) or annotation
        if isinstance(found, type) and issubclass(found, Component):
            return PartOption(found, one=True, many=False, none=False)
    origin, inner = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        return read_part_option(inner[0], list(inner[1:]))
    found_inside = [option for arg in inner if (option := read_part_option(arg, []))]
    if not found_inside:
        return None
    if origin in (Union, UnionType):
        role, *flags = zip(*found_inside, strict=True)
        return PartOption(role[0], any(flags[0]), any(flags[1]), type(None) in inner)
    return PartOption(found_inside[0].role, one=False, many=True, none=False)


def read_part_role(annotation: Any, metadata: list[Any]) -> type[Component] | None:
    """Return the role of the part that an option's annotation asks for, or None if it asks for none."""
    option = read_part_option(annotation, metadata)
    return option.role if option else None
