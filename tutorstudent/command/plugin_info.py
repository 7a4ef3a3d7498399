"""`tutorstudent plugins info`: everything about one part."""

from __future__ import annotations

import inspect
import io
import json
import textwrap
from collections.abc import Iterator
from typing import Annotated, Any

import typer
from ruamel.yaml import YAML

from tutorstudent.core.files.defaults import DEFAULTS, ONE_KIND
from tutorstudent.core.files.optiontable import OptionRow, list_options
from tutorstudent.core.files.registry import ROLES, Installed, Registry
from tutorstudent.core.words.errors import UnknownPlugin, list_names, suggest

WIDTH = 80
IN_LISTS = {"condition": "conditions", "observer": "observers"}


def info(
    name: Annotated[str, typer.Argument(help="the name of a part, as in a pipeline")],
    role: Annotated[str | None, typer.Option(help="its role, where several parts have the name")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="print JSON")] = False,
) -> None:
    """Show a part: where it comes from, what it does, its options, and the line for a pipeline.

    `wrap` shows the pipeline that does what `ts.wrap` does.
    """
    if name == "wrap":
        typer.echo(json.dumps(make_wrapped(), indent=2) if as_json else format_wrapped())
        return
    registry = Registry.discover()
    found = find(name, role, registry)
    if as_json:
        typer.echo(json.dumps(collect_values(found, registry), indent=2))
        return
    for line in format_page(found, registry):
        typer.echo(line)


def make_wrapped() -> dict[str, Any]:
    """Return the values of the pipeline that does what `ts.wrap` does with its own defaults."""
    others = {key: DEFAULTS[key] for key in ("evaluator", "conditions")}
    return {"seed": 0} | ONE_KIND | others


def format_wrapped() -> str:
    """Return the same as YAML, with a head for people."""
    stream = io.StringIO()
    YAML().dump(make_wrapped(), stream)
    return (
        "# What ts.wrap(controller, action=...) makes, as a pipeline: tutorstudent.load(FILE, tutor=..., action=...).\n"
        "# A pipeline whose tutor has actions of one kind may leave all of it out.\n"
        "# Write the ranges of your state's numbers and your conditions into it.\n" + stream.getvalue()
    ).rstrip()


def find(name: str, role: str | None, registry: Registry) -> Installed:
    """Return the one part of that name, and role if it is given.

    Raises:
        UnknownPlugin: if there is none, or several; the message lists them.
    """
    if role is not None and role not in ROLES:
        raise UnknownPlugin(f"there is no role '{role}'{suggest(role, ROLES)}. Roles: {list_names(ROLES)}.")
    found = [item for item in registry if item.cls.name == name and role in (None, item.cls.role)]
    if len(found) > 1:
        roles = list_names(item.cls.role for item in found)
        raise UnknownPlugin(f"several parts are named '{name}': {roles}. Choose one with --role.")
    if not found and role is not None:
        registry.get(role, name)  # says what there is instead
    if not found:
        registry.check_not_broken(name)
        raise UnknownPlugin(
            f"no part is named '{name}'{suggest(name, {item.cls.name for item in registry})}."
            f" `tutorstudent plugins list` shows all.{registry.suspects()}"
        )
    return found[0]


def collect_values(found: Installed, registry: Registry) -> dict[str, Any]:
    """Return what is known about a part as plain values."""
    cls = found.cls
    return {
        "role": cls.role,
        "name": cls.name,
        "plugin": found.entry_point,
        "distribution": found.distribution,
        "class": f"{cls.__module__}.{cls.__qualname__}",
        "description": inspect.cleandoc(cls.__doc__ or ""),
        "options": [row._asdict() for row in list_options(cls)],
        "yaml": format_yaml(found, registry),
    }


def format_page(found: Installed, registry: Registry) -> Iterator[str]:
    """Yield the lines of a description for people."""
    cls, rows = found.cls, list_options(found.cls)
    yield f"{cls.role} {cls.name}"
    yield f"plugin '{found.entry_point}' of {found.distribution}, class {cls.__module__}.{cls.__qualname__}"
    yield ""
    yield inspect.cleandoc(cls.__doc__ or "")
    yield ""
    yield "Options:" if rows else "There are no options."
    for row in rows:
        default = "required" if row.required else f"default {json.dumps(row.default)}"
        head = ", ".join(filter(None, (f"{row.name}: {row.type}", row.bounds, default)))
        yield from textwrap.wrap(head, WIDTH, initial_indent="  ", subsequent_indent="      ")
        yield from textwrap.wrap(row.description, WIDTH, initial_indent="      ", subsequent_indent="      ")
        if row.role:
            names = list_names(item.cls.name for item in registry.of(row.role))
            yield from textwrap.wrap(f"one of: {names}", WIDTH, initial_indent="      ", subsequent_indent="      ")
    yield ""
    yield "In a pipeline:"
    yield f"  {format_yaml(found, registry)}"


def format_yaml(found: Installed, registry: Registry) -> str:
    """Return the line that names a part in a pipeline, with ``...`` for required options."""
    role, name = found.cls.role, found.cls.name
    needed = [f"{row.name}: {_make_example(row, found, registry)}" for row in list_options(found.cls) if row.required]
    part = f"{{use: {name}, {', '.join(needed)}}}" if needed else name
    return f"{IN_LISTS[role]}: [{part}]" if role in IN_LISTS else f"{role}: {part}"


def _make_example(row: OptionRow, found: Installed, registry: Registry) -> str:
    plain = [
        item for item in registry.of(row.role or "") if not any(other.required for other in list_options(item.cls))
    ]
    near = sorted(plain, key=lambda item: item.distribution != found.distribution)
    name = near[0].cls.name if near else "..."
    return f"[{name}]" if row.type.startswith("list") else name
