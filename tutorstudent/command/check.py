"""`tutorstudent plugins check`: all conformance checks of an installed part."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Annotated, Any

import typer

from tutorstudent.checks.catalogue import checks_of
from tutorstudent.checks.process import make
from tutorstudent.checks.report import run_checks
from tutorstudent.core.files.registry import ROLES, Registry
from tutorstudent.core.files.settings import read_settings, set_value
from tutorstudent.core.roles.part import Component
from tutorstudent.core.roles.part_options import read_part_role
from tutorstudent.core.words.errors import PipelineError, UnknownPlugin, list_names, suggest


def check(
    name: Annotated[str, typer.Argument(help="name of an installed part, as in a pipeline")],
    role: Annotated[str | None, typer.Option(help="its role, where parts of several roles have that name")] = None,
    settings: Annotated[
        list[str] | None, typer.Option("--set", metavar="OPTION=VALUE", help="an option of the part; repeatable")
    ] = None,
    world: Annotated[str | None, typer.Option(help="a world whose states it is tried with")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="print JSON")] = False,
) -> None:
    """Check that a part does what its role promises. A failure says what was expected, what happened and what to do."""
    registry = Registry.discover()
    found = find_role(registry, name, role)
    values: dict[str, Any] = {"use": name}
    for key, value in read_settings("--set", settings or []).items():
        set_value(values, key, value, f"plugins check {name}")
    check_required(registry, registry.get(found, name), values)
    where = None if world is None else make(registry, "world", {"use": world}, "--world")
    report = run_checks(checks_of(make(registry, found, values, f"plugins check {name}"), world=where))
    typer.echo(json.dumps(report.as_json(), indent=2) if as_json else "\n".join(report.lines()))
    if report.of("failed"):
        raise typer.Exit(1)


def check_required(registry: Registry, cls: type[Component], values: Mapping[str, Any]) -> None:
    """Raise if a required option is missing; the message says how to give it.

    Raises:
        PipelineError: if one is missing, and none is misspelt.
    """
    fields = cls.Options.model_fields
    missing = [name for name, field in fields.items() if field.is_required() and name not in values]
    if not missing or not set(values) - {"use"} <= set(fields):
        return
    role = read_part_role(fields[missing[0]].annotation, list(fields[missing[0]].metadata))
    known = f" ({role.role}s: {list_names(item.cls.name for item in registry.of(role.role))})" if role else ""
    raise PipelineError(
        f"{cls.role} '{cls.name}' needs the options {list_names(missing)}; give each with --set, "
        f"as in --set {missing[0]}=...{known}."
    )


def find_role(registry: Registry, name: str, role: str | None) -> str:
    """Return the role of the part of that name.

    Raises:
        UnknownPlugin: if there is none.
        BrokenPlugin: if a plugin that has it could not be loaded.
        PipelineError: if there are several, or the role is none.
    """
    if role is not None and role not in ROLES:
        raise PipelineError(f"--role {role}: no such role{suggest(role, ROLES)}. Roles: {list_names(ROLES)}.")
    if role is not None:
        return registry.get(role, name).role
    roles = [installed.cls.role for installed in registry if installed.cls.name == name]
    if len(roles) > 1:
        raise PipelineError(f"'{name}' is the name of parts of the roles {list_names(roles)}; say which, as in --role.")
    if not roles:
        known = [installed.cls.name for installed in registry]
        registry.check_not_broken(name)
        raise UnknownPlugin(
            f"no part named '{name}'{suggest(name, known)}. Installed: {list_names(known)}. "
            f"Install its package with pip to have it found.{registry.suspects()}"
        )
    return roles[0]
