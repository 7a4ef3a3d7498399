"""Where the parts of a run come from, and which versions its result depends on."""

from __future__ import annotations

import platform
from collections.abc import Iterable, Iterator
from importlib import metadata

from tutorstudent.core.files.pipeline import Built
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.roles.part import Component

PACKAGES = ("tutorstudent", "numpy", "pydantic", "pluggy", "pybullet", "scikit-learn")


def find_providers(built: Built, registry: Registry) -> dict[str, str]:
    """Return the distribution of every part, by role and name, as in ``tutor prototype2``."""
    known = {installed.cls: installed.distribution for installed in registry}
    engine = [part for _, part in built.engine.slots()]
    used = {type(part) for part in _walk_parts([*engine, built.world, *built.observers])}
    return {f"{cls.role} {cls.name}": known[cls] for cls in used if cls in known}


def _walk_parts(parts: Iterable[Component]) -> Iterator[Component]:
    for part in parts:
        yield part
        yield from _walk_parts(nested for _, nested in part.parts())


def find_versions() -> dict[str, str]:
    """Return the versions that a result depends on."""
    found = {"python": platform.python_version(), "machine": platform.machine()}
    for package in PACKAGES:
        try:
            found[package] = metadata.version(package)
        except metadata.PackageNotFoundError:
            found[package] = "not installed"
    return found
