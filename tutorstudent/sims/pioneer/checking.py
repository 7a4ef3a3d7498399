"""Checks the values of a scene's files, and says where each mistake is."""

from __future__ import annotations

import re
import reprlib
from collections.abc import Iterator, Mapping
from typing import Any, TypeVar

from pydantic import ValidationError

from tutorstudent.core.files.yamlfile import Document, Location
from tutorstudent.core.words.errors import PipelineError, list_names, suggest
from tutorstudent.sims.pioneer.scene import Box, Circle, Robot, RosMap, Spec, Walls

PARTS: Mapping[int | str, type[Spec]] = {"walls": Walls, "map": RosMap, "circle": Circle, "boxes": Box, "robots": Robot}
"""What stands below these keys and alternatives of a scene."""
ALTERNATIVES = ("circle", "polygon", "walls", "map", "file")
"""Names that pydantic puts into a location where several kinds of value are allowed."""
_SpecT = TypeVar("_SpecT", bound=Spec)


def validate(model: type[_SpecT], document: Document) -> _SpecT:
    """Return the validated data of a document.

    Raises:
        PipelineError: A line for every mistake, with its place; unknown keys first, since a key that is missing is
            most often one that is misspelt.
    """
    try:
        return model.model_validate(document.data)
    except ValidationError as error:
        items = sorted(error.errors(include_url=False), key=lambda item: item["type"] != "extra_forbidden")
        lines = (
            f"{document.locate(_locate(item['loc'], document.data))}: {_describe_problem(model, item)}"
            for item in items
        )
        raise PipelineError("\n".join(lines)) from None


def _locate(loc: Location, data: Any) -> Location:
    return tuple(_find_keys(loc, data))


def _find_keys(loc: Location, data: Any) -> Iterator[int | str]:
    """Yield the keys of a location as they stand in the file; the names of alternatives are not in it."""
    for i, key in enumerate(loc):
        known = isinstance(data, Mapping) and key in data
        if i > 0 and key in ALTERNATIVES and not known:
            continue
        data = _get_item(data, key)
        yield key


def _get_item(data: Any, key: int | str) -> Any:
    if isinstance(data, Mapping):
        return data.get(key)
    return data[key] if isinstance(data, list) and isinstance(key, int) and key < len(data) else None


def _describe_problem(model: type[Spec], item: Any) -> str:
    """Say what is wrong; the place is said before."""
    *above, last = item["loc"] or ("",)
    found = reprlib.repr(item["input"])
    match item["type"]:
        case "extra_forbidden":
            allowed = next((PARTS[key] for key in reversed(above) if key in PARTS), model).model_fields
            return f"unknown key{suggest(str(last), allowed)}. Allowed: {list_names(allowed)}."
        case "missing":
            return "this is required, but it is missing."
        case "value_error":
            return f"{item['ctx']['error']}."
        case "model_type":
            return f"input should be a mapping of keys and values, found {found}."
        case "literal_error":
            near = suggest(str(item["input"]), re.findall(r"'([^']+)'", item["ctx"]["expected"]))
            return f"input should be {item['ctx']['expected']}, found {found}{near}."
    return f"{item['msg'][0].lower()}{item['msg'][1:]}, found {found}."
