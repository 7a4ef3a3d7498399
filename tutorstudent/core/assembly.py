"""Builds components from plain values, and says where a mistake stands."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError

from tutorstudent.core.component import Component, option_problems, part_role
from tutorstudent.core.errors import PipelineError, TutorStudentError, listing, suggestion
from tutorstudent.core.registry import Registry
from tutorstudent.core.yamlfile import Document, Location

ModelT = TypeVar("ModelT", bound=BaseModel)


class Assembler:
    """Turns the values of a document into components of the registry."""

    def __init__(self, document: Document, registry: Registry) -> None:
        self._document = document
        self._registry = registry

    def part(self, role: str, node: Any, at: Location) -> Any:
        """Return the component that a node names: a word, or a mapping with ``use`` and the options beside it."""
        if isinstance(node, Component):
            return node
        named_at = at if isinstance(node, str) else (*at, "use")
        if isinstance(node, str):
            node = {"use": node}
        if not isinstance(node, dict) or not isinstance(node.get("use"), str):
            raise self.error(
                at, f"found {node!r}; a {role} is named by a word or by a mapping with 'use', as in {{use: name}}."
            )
        with self.placed(named_at):
            cls = self._registry.get(role, node["use"])
        options = {key: self._option(cls, key, value, (*at, key)) for key, value in node.items() if key != "use"}
        self.model(cls.Options, options, at, f"{role} '{cls.name}'")
        with self.placed(at):
            return cls(**options)

    def parts(self, role: str, node: Any, at: Location) -> list[Any]:
        """Return the components that a list names."""
        if not isinstance(node, list | tuple):
            raise self.error(at, f"found {node!r}; write a list, as in [name] or [{{use: name}}].")
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
                raise self.error((*at, key), f"unknown key{suggestion(key, allowed)}. Allowed: {listing(allowed)}.")

    @contextmanager
    def placed(self, at: Location) -> Iterator[None]:
        """Let every error of ours say where: at the part that was being bound, else at `at`."""
        try:
            yield
        except TutorStudentError as error:
            if not error.placed:
                error.args = (f"{self._document.where(_location(error.slot) or at)}: {error}",)
                error.placed = True
            raise

    def error(self, at: Location, problem: str) -> PipelineError:
        """Return the error that says where and what."""
        error = PipelineError(f"{self._document.where(at)}: {problem}")
        error.placed = True
        return error

    def _option(self, cls: type[Component], key: str, value: Any, at: Location) -> Any:
        field = cls.Options.model_fields.get(key)
        role = None if field is None else part_role(field.annotation, list(field.metadata))
        if role is None or value is None:
            return value
        if isinstance(value, list):
            return self.parts(role.role, value, at)
        return self.part(role.role, value, at)


def _location(slot: str) -> Location:
    return tuple(int(key) if key.isdigit() else key for key in slot.split(".")) if slot else ()
