"""The names of a new plugin, made from one: of the part, its distribution, its module and its class."""

from __future__ import annotations

import importlib.util
import keyword
import re
from importlib import metadata
from typing import NamedTuple

from tutorstudent.core.files.registry import ROLES, Registry
from tutorstudent.core.words.errors import PipelineError, list_names, suggest

_NAME = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")


class Names(NamedTuple):
    """What a new plugin and its parts are called."""

    role: str
    name: str
    """Of the part in pipelines, and of the distribution: ``wall-follower``."""
    module: str
    """``wall_follower``."""
    class_name: str
    """``WallFollowerTutor``: the role is added unless the name ends with it."""


def make_names(role: str, name: str, registry: Registry) -> Names:
    """Return the names of a new plugin.

    >>> make_names("tutor", "wall-follower", Registry())
    Names(role='tutor', name='wall-follower', module='wall_follower', class_name='WallFollowerTutor')

    Raises:
        PipelineError: if there is no such role, the name cannot be used, or it is taken.
    """
    if role not in ROLES:
        raise PipelineError(f"plugins new {role}: no such role{suggest(role, ROLES)}. Roles: {list_names(ROLES)}.")
    if not _NAME.fullmatch(name):
        raise PipelineError(
            f"plugins new {role} {name}: a name is like 'wall-follower': small letters and digits, a letter first, "
            f"words joined by single hyphens{_propose(name)}."
        )
    module = name.replace("-", "_")
    _check_module(role, name, module)
    _check_not_taken(role, name, registry)
    camel = "".join(word.capitalize() for word in name.split("-"))
    class_name = camel if camel.endswith(role.capitalize()) else camel + role.capitalize()
    return Names(role, name, module, class_name)


def _propose(name: str) -> str:
    spaced = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", name).lower()
    likely = re.sub(r"[^a-z0-9]+", "-", spaced).strip("-").lstrip("0123456789-")
    return f" (perhaps '{likely}')" if likely else ""


def _check_module(role: str, name: str, module: str) -> None:
    where = f"plugins new {role} {name}"
    if keyword.iskeyword(module) or module in ("tests", "test"):
        raise PipelineError(f"{where}: '{module}' cannot be the name of a module; choose another, as in 'my-{name}'.")
    if importlib.util.find_spec(module) is not None:
        raise PipelineError(
            f"{where}: a module '{module}' is installed already; choose another name, as in 'my-{name}'."
        )


def _check_not_taken(role: str, name: str, registry: Registry) -> None:
    where = f"plugins new {role} {name}"
    for installed in registry.of(role):
        if installed.cls.name == name:
            raise PipelineError(
                f"{where}: there is a {role} of that name, from '{installed.entry_point}' ({installed.distribution}); "
                f"choose another, as in 'my-{name}'."
            )
    try:
        version = metadata.version(name)
    except metadata.PackageNotFoundError:
        return
    raise PipelineError(f"{where}: the distribution '{name}' {version} is installed; choose another name.")
