"""``extends: other.yaml``: a pipeline file that says only what differs from another one."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tutorstudent.core.files.yamlfile import Document, Location, Place, read_yaml
from tutorstudent.core.words.errors import PipelineError

EXTENDS = "extends"
LONGEST_CHAIN = 50
WHOLE: tuple[Location, ...] = (("on_tutor_failure",),)
"""Mappings that are replaced as a whole: the components of two actions are not mixed."""


def read_extended(path: Path) -> Document:
    """Read a YAML file and all that it extends, as one document in which every value knows its own file.

    Mappings are merged key by key; lists and scalars are replaced. Where ``use`` names another part than before, the
    old options are dropped. A word is short for ``{use: word}``.

    Raises:
        PipelineError: if a file cannot be read or leads back to itself; the message says where and what to do.
    """
    return _read(path, [])


def _read(path: Path, chain: list[Path]) -> Document:
    document = read_yaml(path)
    if not isinstance(document.data, dict) or EXTENDS not in document.data:
        return document
    chain = [*chain, path]
    base = _read(_find_base(document, path, chain), chain)
    if not isinstance(base.data, dict):
        raise _make_error(document, f"{base.name} holds no mapping; extend a pipeline.")
    return _merge(base, document)


def _find_base(document: Document, path: Path, chain: list[Path]) -> Path:
    named = document.data[EXTENDS]
    if not isinstance(named, str) or not named:
        raise _make_error(document, f"found {named!r}; write the path of one YAML file, as in extends: base.yaml.")
    if Path(named).is_absolute():
        raise _make_error(
            document, f"found the absolute path {named}; write it relative to this file, for other machines."
        )
    base = path.parent / named
    if len(chain) > LONGEST_CHAIN:
        raise _make_error(
            document, f"this is file {len(chain)} of a chain; {LONGEST_CHAIN} files may extend each other."
        )
    if not _is_file(base):
        raise _make_error(document, f"there is no file {base}. The path is relative to the file that names it.")
    if base.resolve() in [known.resolve() for known in chain]:
        way = " -> ".join(str(known) for known in [*chain, base])
        raise _make_error(document, f"the files extend each other in a circle: {way}; one of them must extend nothing.")
    return base


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # such as a name that is too long
        return False


def _make_error(document: Document, problem: str) -> PipelineError:
    return PipelineError(f"{document.locate((EXTENDS,))}: {problem}")


def _merge(base: Document, own: Document) -> Document:
    merge = _Merge(base)
    values = {key: value for key, value in own.data.items() if key != EXTENDS}
    data = merge.lay_over(base.data, values, ())
    places = {at: place for at, place in own.places.items() if at != (EXTENDS,)}
    return Document(own.name, data, merge.places | {at: _note_file(own, place) for at, place in places.items()})


class _Merge:
    """Merges values into those of a base, and keeps the places of what is left of the base."""

    def __init__(self, base: Document) -> None:
        self.places = {at: _note_file(base, place) for at, place in base.places.items() if at != (EXTENDS,)}

    def lay_over(self, base: Any, own: Any, at: Location) -> Any:
        old, new = _make_mapping(base, own), _make_mapping(own, base)
        if at in WHOLE or not isinstance(old, dict) or not isinstance(new, dict) or _is_other_part(old, new):
            self.places = {other: place for other, place in self.places.items() if other[: len(at)] != at}
            return own
        if old is not base and at in self.places:
            self.places[*at, "use"] = self.places[at]
        both = {key: self.lay_over(old[key], new[key], (*at, key)) for key in old if key in new}
        return old | new | both


def _make_mapping(value: Any, other: Any) -> Any:
    return {"use": value} if isinstance(value, str) and isinstance(other, dict) else value


def _is_other_part(old: dict[str, Any], new: dict[str, Any]) -> bool:
    return "use" in old and "use" in new and old["use"] != new["use"]


def _note_file(document: Document, place: Place) -> Place:
    return place if place.file else place._replace(file=document.name)
