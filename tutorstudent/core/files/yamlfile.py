"""Reads YAML into plain values and remembers the place of each."""

from __future__ import annotations

import stat
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from ruamel.yaml import YAML
from ruamel.yaml.error import YAMLError

from tutorstudent.core.files.yamlnodes import DEEPEST, Location, NodeReader, Place, count_position, explain_syntax
from tutorstudent.core.words.errors import PipelineError

LARGEST = 500_000
"""Characters of a file; more would take the parser minutes."""


MOST_BYTES = 4
"""Of a character in UTF-8."""


class Document(NamedTuple):
    """The plain values of a YAML file, with the place of every key."""

    name: str
    data: Any
    places: Mapping[Location, Place] = {}
    settings: Mapping[Location, str] = {}
    """What was set from outside, as ``key=value``, so that it has no place in the file."""

    def locate(self, location: Location) -> str:
        """Return ``file:line:column: dotted.key`` of a location, or of its nearest parent that is in the file.

        Settings above and below the location are named: ``file (with seed=-1): seed``.
        """
        near = location
        while near and near not in self.places and near not in self.settings:
            near = near[:-1]
        dotted = ".".join(str(key) for key in location)
        settings = [text for at, text in self.settings.items() if _overlap(at, location)]
        position = _format_position(self.name, self.places.get(near))
        if settings:
            position = f"{position} (with {', '.join(settings)})"
        return f"{position}: {dotted}" if dotted else position

    def replace(self, at: Location, data: Any, setting: str) -> Document:
        """Return the document with other data, where `setting` gave everything at and below a location."""
        places = {other: place for other, place in self.places.items() if other[: len(at)] != at}
        settings = {other: text for other, text in self.settings.items() if other[: len(at)] != at}
        return Document(self.name, data, places, settings | {at: setting})


def _overlap(one: Location, other: Location) -> bool:
    return all(a == b for a, b in zip(one, other, strict=False))


def _format_position(name: str, place: Place | None) -> str:
    return f"{place.file or name}:{place.line}:{place.column}" if place else name


def read_yaml(path: Path) -> Document:
    """Read a YAML file.

    Raises:
        PipelineError: if it cannot be read, with the place and the remedy.
    """
    return parse_yaml(read_text(path), str(path))


def read_text(path: Path) -> str:
    """Return the text of a YAML file.

    Raises:
        PipelineError: if it cannot be read, with the place and the remedy.
    """
    try:
        _check_file(path)
        return path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise PipelineError(f"{path}: there is no such file. Give the path of a YAML file.") from None
    except UnicodeDecodeError as error:
        before = error.object[: error.start].decode("utf-8")
        place = f"{path}:{count_position(before, len(before))}"
        raise PipelineError(f"{place}: cannot be read: this is not UTF-8. Save the file in UTF-8.") from None
    except OSError as error:
        raise PipelineError(f"{path}: cannot be read: {error.strerror}. Give the path of a YAML file.") from None


def _check_file(path: Path) -> None:
    found = path.stat()
    if stat.S_ISREG(found.st_mode) and found.st_size > LARGEST * MOST_BYTES:
        raise PipelineError(f"{path}: it has {found.st_size:,} bytes; {LARGEST:,} characters are allowed.")
    if not stat.S_ISREG(found.st_mode) and not stat.S_ISDIR(found.st_mode):
        raise PipelineError(f"{path}: this is no file but a pipe or a device. Give the path of a YAML file.")


def parse_yaml(text: str, name: str) -> Document:
    """Parse YAML text; `name` is what messages call it.

    Raises:
        PipelineError: if it is not plain YAML, with the place and the remedy.
    """
    if len(text) > LARGEST:
        raise PipelineError(f"{name}: it has {len(text):,} characters; {LARGEST:,} are allowed.")
    reader = NodeReader(name)
    try:
        node = _compose(text)
        return Document(name, None if node is None else reader.read_value(node), reader.places)
    except RecursionError:
        raise PipelineError(f"{name}: it is nested too deeply, or contains itself; make it flatter.") from None
    except YAMLError as error:
        raise PipelineError(explain_syntax(name, text, error)) from None


def _compose(text: str) -> Any:
    yaml = YAML(typ="safe", pure=True)
    yaml.max_depth = DEEPEST
    yaml.composer.warn_double_anchors = False  # a name may be given again
    return yaml.compose(text)


__all__ = ["Document", "Location", "Place", "parse_yaml", "read_text", "read_yaml"]
