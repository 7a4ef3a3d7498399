"""Builds parts from plain values, and says where in the file a mistake is."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError

from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.yamlfile import Document, Location
from tutorstudent.core.roles.option_problems import find_option_problems
from tutorstudent.core.roles.part import Component
from tutorstudent.core.roles.part_options import read_part_option
from tutorstudent.core.words.errors import PipelineError, TutorStudentError, list_names, quote, suggest, with_article

ModelT = TypeVar("ModelT", bound=BaseModel)


class Assembler:
    """Makes parts of the values of a document."""

    def __init__(self, document: Document, registry: Registry) -> None:
        self._document = document
        self._registry = registry
        self._slots: dict[str, Location] = {}

    def place_slot(self, slot: str, at: Location) -> None:
        """Say where a slot is in the document, if it has another name there, such as ``conditions.bumped``."""
        self._slots[slot] = at

    def make_part(self, role: str, node: Any, at: Location) -> Any:
        """Return the part that a node names: a word, or a mapping with ``use`` and the options beside it."""
        if isinstance(node, Component):
            return node
        word = isinstance(node, str)
        values = {"use": node} if word else node
        if not isinstance(values, dict) or not isinstance(values.get("use"), str):
            raise self._refuse_unnamed(role, node, at)
        with self.locate_errors(at if word else (*at, "use")):
            cls = self._registry.get(role, values["use"])
        options = {key: self._make_option(cls, key, value, (*at, key)) for key, value in values.items() if key != "use"}
        self.make_model(cls.Options, options, at, f"{role} '{cls.name}'")
        with self.locate_errors(at):
            return cls(**options)

    def _refuse_unnamed(self, role: str, node: Any, at: Location) -> PipelineError:
        known = [installed.cls.name for installed in self._registry.of(role)]
        if isinstance(node, dict) and "use" in node:
            allowed = f"'use' is the name of {with_article(role)}. Installed: {list_names(known)}."
            return self.make_error((*at, "use"), f"found {quote(node['use'])}; {allowed}")
        if isinstance(node, dict):
            name = next((name for name in known if name in node), "name")
            return self.make_error(
                at,
                f"there is no 'use' in it; name {with_article(role)} and write its options beside that, "
                f"as in {{use: {name}}}.",
            )
        return self.make_error(
            at,
            f"found {quote(node)}; {with_article(role)} is named by a word or by a mapping with 'use', "
            "as in {use: name}.",
        )

    def make_parts(self, role: str, node: Any, at: Location) -> list[Any]:
        """Return the parts that a list names."""
        if not isinstance(node, list | tuple):
            raise self.make_error(at, f"found {quote(node)}; write a list, as in [name] or [{{use: name}}].")
        return [self.make_part(role, item, (*at, i)) for i, item in enumerate(node)]

    def make_model(self, model: type[ModelT], values: dict[str, Any], at: Location, what: str) -> ModelT:
        """Return the validated model, or say where the first mistake is."""
        try:
            return model(**values)
        except ValidationError as error:
            location, problem = find_option_problems(model, error)[0]
            raise self.make_error((*at, *location), f"{what}: {problem}") from None

    def check_keys(self, found: dict[str, Any], allowed: list[str], at: Location) -> None:
        """Refuse the first key that is not allowed."""
        for key in found:
            if key not in allowed:
                first, dot, rest = key.partition(".")
                hint = f" Keys are nested, as in {first}: {{{rest}: ...}}." if dot and first in allowed else ""
                raise self.make_error(
                    (*at, key), f"unknown key{suggest(key, allowed)}.{hint} Allowed: {list_names(allowed)}."
                )

    @contextmanager
    def locate_errors(self, at: Location) -> Iterator[None]:
        """Put a position before every error of ours: that of the part to blame, else `at`."""
        try:
            yield
        except TutorStudentError as error:
            if not error.placed:
                error.args = (f"{self._document.locate(self._find_location(error.slot) or at)}: {error}",)
                error.placed = True
            raise

    def make_error(self, at: Location, problem: str) -> PipelineError:
        """Return the error that says where and what."""
        error = PipelineError(f"{self._document.locate(at)}: {problem}")
        error.placed = True
        return error

    def _make_option(self, cls: type[Component], key: str, value: Any, at: Location) -> Any:
        field = cls.Options.model_fields.get(key)
        option = None if field is None else read_part_option(field.annotation, list(field.metadata))
        if option is None or (value is None and option.none):
            return value
        if option.many and (isinstance(value, list) or not option.one):
            return self.make_parts(option.role.role, value, at)
        return self.make_part(option.role.role, value, at)

    def _find_location(self, slot: str) -> Location:
        for name, at in self._slots.items():
            if slot == name or slot.startswith(f"{name}."):
                return (*at, *_split_keys(slot[len(name) + 1 :]))
        return _split_keys(slot)


def _split_keys(dotted: str) -> Location:
    return tuple(int(key) if key.isdigit() else key for key in dotted.split(".")) if dotted else ()
