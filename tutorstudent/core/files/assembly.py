"""Builds components from plain values, and says where a mistake stands."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError

from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.yamlfile import Document, Location
from tutorstudent.core.roles.option_problems import option_problems
from tutorstudent.core.roles.part import Component
from tutorstudent.core.roles.part_options import part_option
from tutorstudent.core.words.errors import PipelineError, TutorStudentError, an, listing, shown, suggestion

ModelT = TypeVar("ModelT", bound=BaseModel)


class Assembler:
    """Turns the values of a document into components of the registry."""

    def __init__(self, document: Document, registry: Registry) -> None:
        self._document = document
        self._registry = registry
        self.slots: dict[str, Location] = {}
        """Where slots stand in the document that are named otherwise there, such as ``conditions.bumped``."""

    def part(self, role: str, node: Any, at: Location) -> Any:
        """Return the component that a node names: a word, or a mapping with ``use`` and the options beside it."""
        if isinstance(node, Component):
            return node
        word = isinstance(node, str)
        values = {"use": node} if word else node
        if not isinstance(values, dict) or not isinstance(values.get("use"), str):
            raise self._unnamed(role, node, at)
        with self.placed(at if word else (*at, "use")):
            cls = self._registry.get(role, values["use"])
        options = {key: self._option(cls, key, value, (*at, key)) for key, value in values.items() if key != "use"}
        self.model(cls.Options, options, at, f"{role} '{cls.name}'")
        with self.placed(at):
            return cls(**options)

    def _unnamed(self, role: str, node: Any, at: Location) -> PipelineError:
        known = [installed.cls.name for installed in self._registry.of(role)]
        if isinstance(node, dict) and "use" in node:
            allowed = f"'use' is the name of {an(role)}. Installed: {listing(known)}."
            return self.error((*at, "use"), f"found {shown(node['use'])}; {allowed}")
        if isinstance(node, dict):
            name = next((name for name in known if name in node), "name")
            return self.error(
                at,
                f"there is no 'use' in it; name {an(role)} and write its options beside that, as in {{use: {name}}}.",
            )
        return self.error(
            at, f"found {shown(node)}; {an(role)} is named by a word or by a mapping with 'use', as in {{use: name}}."
        )

    def parts(self, role: str, node: Any, at: Location) -> list[Any]:
        """Return the components that a list names."""
        if not isinstance(node, list | tuple):
            raise self.error(at, f"found {shown(node)}; write a list, as in [name] or [{{use: name}}].")
        return [self.part(role, item, (*at, i)) for i, item in enumerate(node)]

    def model(self, model: type[ModelT], values: dict[str, Any], at: Location, what: str) -> ModelT:
        """Return the validated model, or say where the first mistake stands."""
        try:
            return model(**values)
        except ValidationError as error:
            location, problem = option_problems(model, error)[0]
            raise self.error((*at, *location), f"{what}: {problem}") from None

    def check_keys(self, found: dict[str, Any], allowed: list[str], at: Location) -> None:
        """Refuse the first key that is not allowed."""
        for key in found:
            if key not in allowed:
                first, dot, rest = key.partition(".")
                hint = f" Keys are nested, as in {first}: {{{rest}: ...}}." if dot and first in allowed else ""
                raise self.error(
                    (*at, key), f"unknown key{suggestion(key, allowed)}.{hint} Allowed: {listing(allowed)}."
                )

    @contextmanager
    def placed(self, at: Location) -> Iterator[None]:
        """Let every error of ours say where: at the part that was being bound, else at `at`."""
        try:
            yield
        except TutorStudentError as error:
            if not error.placed:
                error.args = (f"{self._document.where(self._location(error.slot) or at)}: {error}",)
                error.placed = True
            raise

    def error(self, at: Location, problem: str) -> PipelineError:
        """Return the error that says where and what."""
        error = PipelineError(f"{self._document.where(at)}: {problem}")
        error.placed = True
        return error

    def _option(self, cls: type[Component], key: str, value: Any, at: Location) -> Any:
        field = cls.Options.model_fields.get(key)
        option = None if field is None else part_option(field.annotation, list(field.metadata))
        if option is None or (value is None and option.none):
            return value
        if option.many and (isinstance(value, list) or not option.one):
            return self.parts(option.role.role, value, at)
        return self.part(option.role.role, value, at)

    def _location(self, slot: str) -> Location:
        for name, at in self.slots.items():
            if slot == name or slot.startswith(f"{name}."):
                return (*at, *_keys(slot[len(name) + 1 :]))
        return _keys(slot)


def _keys(dotted: str) -> Location:
    return tuple(int(key) if key.isdigit() else key for key in dotted.split(".")) if dotted else ()
