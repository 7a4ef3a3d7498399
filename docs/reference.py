"""Writes the pages that are generated from the package itself: commands, parts with their options, hooks."""

from __future__ import annotations

import inspect
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import typer.main

from tutorstudent.command.program import app
from tutorstudent.core.deciding.limits import Limits
from tutorstudent.core.files.pipeline import Header
from tutorstudent.core.files.registry import ROLES, Registry
from tutorstudent.core.roles import hookspecs
from tutorstudent.core.roles.part import Component

PAGES = ("commands", "parts", "pipeline", "hooks")


def write(folder: Path) -> None:
    """Write all generated pages as Markdown into a folder."""
    folder.mkdir(exist_ok=True)
    for name, lines in zip(PAGES, (commands(), parts(Registry.discover()), pipeline(), hooks()), strict=True):
        (folder / f"{name}.md").write_text("\n".join(lines) + "\n", encoding="utf-8")


def commands() -> Iterator[str]:
    """Yield the page of the command line."""
    yield "# Command line"
    yield ""
    yield "Every command has `--help`. An error is one sentence on standard error, with exit code 2."
    yield from _command(typer.main.get_command(app), "tutorstudent")


def _command(command: Any, name: str) -> Iterator[str]:
    children = getattr(command, "commands", {})
    if not children:
        yield ""
        yield f"## `{name}`"
        yield ""
        yield _plain(command.help or "")
        yield ""
        yield from _parameters(command.params)
    for child in children:
        yield from _command(children[child], f"{name} {child}")


def _parameters(params: Iterable[Any]) -> Iterator[str]:
    shown = [param for param in params if not getattr(param, "hidden", False)]
    if not shown:
        return
    yield "| parameter | default | what |"
    yield "|---|---|---|"
    for param in shown:
        named = param.param_type_name == "option"
        words = [*param.opts, *param.secondary_opts] if named else [param.opts[0].upper()]
        word = " / ".join(f"`{opt}`" for opt in words)
        default = f"`{param.default}`" if isinstance(param.default, str | int | float) and param.default != "" else ""
        yield f"| {word} | {default} | {_plain(getattr(param, 'help', '') or '')} |"


def pipeline() -> Iterator[str]:
    """Yield the page of a pipeline's own keys."""
    yield "# Keys of a pipeline"
    yield ""
    yield "Plain values; the slots `tutor`, `student`, `selector`, `amplifier`, `evaluator`, `world` and the lists "
    yield "`conditions` and `observers` hold the [parts](parts.md)."
    yield ""
    yield from _table(Header.model_json_schema())
    yield ""
    yield "## limits"
    yield ""
    yield _plain(Limits.__doc__ or "")
    yield ""
    yield from _table(Limits.model_json_schema())


def parts(registry: Registry) -> Iterator[str]:
    """Yield the page of all installed parts with their options."""
    yield "# Parts and their options"
    yield ""
    yield "What comes with the package, by role. `tutorstudent plugins info NAME` prints the same for one part, and "
    yield "for those of other distributions; `tutorstudent schema` prints all of it as a JSON Schema."
    for role in ROLES:
        found = [
            installed.cls for installed in registry.of(role) if installed.distribution.split()[0] == "tutorstudent"
        ]
        if found:
            yield ""
            yield f"## {role}"
        for cls in sorted(found, key=lambda cls: cls.name):
            yield from _part(cls)


def _part(cls: type[Component]) -> Iterator[str]:
    yield ""
    yield f"### {cls.role} `{cls.name}`"
    yield ""
    yield _plain(inspect.getdoc(cls) or "")
    schema = cls.Options.model_json_schema()
    if schema.get("properties"):
        yield ""
        yield from _table(schema)


def _table(schema: dict[str, Any]) -> Iterator[str]:
    yield "| option | takes | default | what |"
    yield "|---|---|---|---|"
    for key, field in _flat(schema, schema):
        default = f"`{field['default']}`" if "default" in field else "required" if field["required"] else ""
        yield f"| `{key}` | {_type(field)} | {default} | {_plain(field.get('description', ''))} |"


def _flat(node: dict[str, Any], root: dict[str, Any], prefix: str = "") -> Iterator[tuple[str, dict[str, Any]]]:
    for key, field in node.get("properties", {}).items():
        inner = _resolved(field, root)
        required = key in node.get("required", [])
        if "properties" in inner:
            yield from _flat(inner, root, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", inner | field | {"required": required}


def _resolved(field: dict[str, Any], root: dict[str, Any]) -> dict[str, Any]:
    reference = field.get("$ref", "")
    found: dict[str, Any] = root["$defs"][reference.rpartition("/")[2]] if reference else field
    return found


def _type(field: dict[str, Any]) -> str:
    if "x-role" in field:
        return f"a part: {field['x-role']}"
    if "anyOf" in field:
        return " or ".join(_type(item) for item in field["anyOf"])
    if "enum" in field or "const" in field:
        return ", ".join(f"`{value}`" for value in field.get("enum", [field.get("const")]))
    if field.get("type") == "array":
        return f"list of {_type(field['items'])}" if isinstance(field.get("items"), dict) else "list"
    words = {"minimum": "≥", "exclusiveMinimum": ">", "maximum": "≤", "exclusiveMaximum": "<"}
    bounds = ", ".join(f"{sign} {field[word]}" for word, sign in words.items() if word in field)
    return f"{field.get('type', 'any')}{f' {bounds}' if bounds else ''}"


def hooks() -> Iterator[str]:
    """Yield the page of the plugin hooks."""
    yield "# Hooks"
    yield ""
    yield "A plugin implements these and is found through an entry point of the group `tutorstudent`."
    for name in vars(hookspecs):
        if name.startswith("tutorstudent_"):
            yield ""
            yield f"## {name}"
            yield ""
            yield "```{eval-rst}"
            yield f".. autofunction:: tutorstudent.core.roles.hookspecs.{name}"
            yield "```"


def _plain(text: str) -> str:
    # Markdown reads ``x`` as code too; a bar would end a cell, and a docstring's table is laid out already.
    if "\n|" in text or text.startswith("|"):
        return text
    return (
        " ".join(text.split()).replace("|", r"\|")
        if "\n\n" not in text
        else "\n\n".join(map(_plain, text.split("\n\n")))
    )
