"""Reads YAML into plain values and remembers where each stood. No tags, no objects, no duplicate keys."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from ruamel.yaml import YAML
from ruamel.yaml.comments import CommentedMap, CommentedOrderedMap, CommentedSeq, CommentedSet
from ruamel.yaml.error import MarkedYAMLError, YAMLError

from tutorstudent.core.errors import PipelineError

Key = int | str
Location = tuple[Key, ...]
DEEPEST = 50
PLAIN_TAGS = {f"tag:yaml.org,2002:{name}" for name in ("map", "seq", "str", "int", "float", "bool", "null")}
TAGGED: dict[type[Any], str] = {
    CommentedOrderedMap: "!!omap",
    CommentedSet: "!!set",
    list: "!!pairs",
    bytes: "!!binary",
}
"""What the reader makes of tags that it does not keep."""


class Place(NamedTuple):
    """A line and a column, counted from 1."""

    line: int
    column: int
    file: str = ""
    """Where it is not the document's own: what a file extends stands in another one."""


class Document(NamedTuple):
    """The plain values of a YAML file, with the place of every key."""

    name: str
    data: Any
    places: Mapping[Location, Place] = {}
    settings: Mapping[Location, str] = {}
    """What was set from elsewhere, as ``key=value``; it stands nowhere in the file."""

    def where(self, location: Location) -> str:
        """Return ``file:line:column: dotted.key`` of a location, or of its nearest parent that stands in the file.

        Settings above and below the location are named: ``file (with seed=-1): seed``.
        """
        near = location
        while near and near not in self.places and near not in self.settings:
            near = near[:-1]
        dotted = ".".join(str(key) for key in location)
        settings = [text for at, text in self.settings.items() if _overlap(at, location)]
        position = _position(self.name, self.places.get(near))
        if settings:
            position = f"{position} (with {', '.join(settings)})"
        return f"{position}: {dotted}" if dotted else position

    def replaced(self, at: Location, data: Any, setting: str) -> Document:
        """Return the document with other data, in which `setting` gave what is at and below a location."""
        places = {other: place for other, place in self.places.items() if other[: len(at)] != at}
        settings = {other: text for other, text in self.settings.items() if other[: len(at)] != at}
        return Document(self.name, data, places, settings | {at: setting})


def _overlap(one: Location, other: Location) -> bool:
    return all(a == b for a, b in zip(one, other, strict=False))


def _position(name: str, place: Place | None) -> str:
    return f"{place.file or name}:{place.line}:{place.column}" if place else name


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
    places: dict[Location, Place] = {}
    try:
        return Document(name, _plain(YAML(typ="rt").load(text), (), places, name), places)
    except (RecursionError, AttributeError):  # the second is the reader's, for a mapping that is merged into itself
        raise PipelineError(f"{name}: it is nested too deeply, or in itself; write it flat.") from None
    except MarkedYAMLError as error:
        mark = error.problem_mark
        position = f"{name}:{mark.line + 1}:{mark.column + 1}" if mark else name
        raise PipelineError(f"{position}: not valid YAML: {' '.join(str(error.problem).split())}.") from None
    except (YAMLError, ValueError) as error:
        raise PipelineError(f"{name}: not valid YAML: {' '.join(str(error).split())}.") from None


def _plain(node: Any, at: Location, places: dict[Location, Place], name: str) -> Any:
    if len(at) > DEEPEST:
        raise PipelineError(f"{name}: it is nested too deeply, or in itself; write it flat.")
    tag = TAGGED.get(type(node)) or getattr(getattr(node, "tag", None), "value", None)
    if tag is not None and str(tag) not in PLAIN_TAGS:
        position = _position(name, places.get(at))
        raise PipelineError(f"{position}: the tag '{tag}' is not allowed; write plain YAML without tags.")
    if isinstance(node, CommentedMap):
        for key in node:
            place = _place_of(node, key) or places.get(at)
            if not isinstance(key, str):
                raise PipelineError(f"{_position(name, place)}: the key {key!r} is not a word; quote it.")
            if place is not None:
                places[(*at, str(key))] = place
        return {str(key): _plain(value, (*at, str(key)), places, name) for key, value in node.items()}
    if isinstance(node, CommentedSeq):
        for i in range(len(node)):
            places[(*at, i)] = Place(*(number + 1 for number in node.lc.item(i)))
        return [_plain(value, (*at, i), places, name) for i, value in enumerate(node)]
    return _scalar(node)


def _place_of(node: CommentedMap, key: Any) -> Place | None:
    try:
        return Place(*(number + 1 for number in node.lc.key(key)))
    except (KeyError, TypeError):  # it was merged in with '<<' and has no line of its own
        return None


def _scalar(node: Any) -> Any:
    if node is None or isinstance(node, bool):
        return node
    for plain in (int, float, str):
        if isinstance(node, plain):
            return plain(node)
    return str(node)
