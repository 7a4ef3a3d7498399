"""Reads YAML into plain values and remembers where each stood. No tags, no objects, no duplicate keys."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from ruamel.yaml import YAML
from ruamel.yaml.comments import CommentedMap, CommentedSeq
from ruamel.yaml.error import MarkedYAMLError, YAMLError

from tutorstudent.core.errors import PipelineError

Key = int | str
Location = tuple[Key, ...]
PLAIN_TAGS = {f"tag:yaml.org,2002:{name}" for name in ("map", "seq", "str", "int", "float", "bool", "null")}


class Place(NamedTuple):
    """A line and a column, counted from 1."""

    line: int
    column: int


class Document(NamedTuple):
    """The plain values of a YAML file, with the place of every key."""

    name: str
    data: Any
    places: Mapping[Location, Place]

    def where(self, location: Location) -> str:
        """Return ``file:line:column: dotted.key`` of a location, or of its nearest parent that stands in the file."""
        near = location
        while near and near not in self.places:
            near = near[:-1]
        place = self.places.get(near)
        dotted = ".".join(str(key) for key in location)
        position = f"{self.name}:{place.line}:{place.column}" if place else self.name
        return f"{position}: {dotted}" if dotted else position


def read_yaml(path: Path) -> Document:
    """Read a YAML file.

    Raises:
        PipelineError: if it cannot be read, with the place and the remedy.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise PipelineError(f"{path}: there is no such file. Give the path of a YAML file.") from None
    except (OSError, UnicodeDecodeError) as error:
        raise PipelineError(f"{path}: cannot be read: {error}. Give the path of a YAML file in UTF-8.") from None
    return parse_yaml(text, str(path))


def parse_yaml(text: str, name: str) -> Document:
    """Parse YAML text; `name` stands for it in messages."""
    try:
        tree = YAML(typ="rt").load(text)
    except MarkedYAMLError as error:
        mark = error.problem_mark
        position = f"{name}:{mark.line + 1}:{mark.column + 1}" if mark else name
        raise PipelineError(f"{position}: not valid YAML: {' '.join(str(error.problem).split())}.") from None
    except (YAMLError, ValueError) as error:
        raise PipelineError(f"{name}: not valid YAML: {' '.join(str(error).split())}.") from None
    places: dict[Location, Place] = {}
    return Document(name, _plain(tree, (), places, name), places)


def _plain(node: Any, at: Location, places: dict[Location, Place], name: str) -> Any:
    tag = getattr(getattr(node, "tag", None), "value", None)
    if tag is not None and str(tag) not in PLAIN_TAGS:
        place = places.get(at)
        position = f"{name}:{place.line}:{place.column}" if place else name
        raise PipelineError(f"{position}: the tag '{tag}' is not allowed; write plain YAML without tags.")
    if isinstance(node, CommentedMap):
        for key in node:
            if not isinstance(key, str):
                line, column = node.lc.key(key)
                raise PipelineError(f"{name}:{line + 1}:{column + 1}: the key {key!r} is not a word; quote it.")
            places[(*at, str(key))] = Place(*(number + 1 for number in node.lc.key(key)))
        return {str(key): _plain(value, (*at, str(key)), places, name) for key, value in node.items()}
    if isinstance(node, CommentedSeq):
        for i in range(len(node)):
            places[(*at, i)] = Place(*(number + 1 for number in node.lc.item(i)))
        return [_plain(value, (*at, i), places, name) for i, value in enumerate(node)]
    return _scalar(node)


def _scalar(node: Any) -> Any:
    if node is None or isinstance(node, bool):
        return node
    for plain in (int, float, str):
        if isinstance(node, plain):
            return plain(node)
    return str(node)
