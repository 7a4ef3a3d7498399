"""Holds the site against the package: every name that a public module promises is rendered."""

from __future__ import annotations

import importlib
from collections.abc import Collection

PUBLIC = (
    "tutorstudent",
    "tutorstudent.checks",
    "tutorstudent.plugins.backprop",
    "tutorstudent.plugins.process",
    "tutorstudent.plugins.prototype2",
    "tutorstudent.plugins.streamlined",
    "tutorstudent.sims.gym",
    "tutorstudent.sims.gym.envs",
    "tutorstudent.sims.pioneer.types",
    "tutorstudent.study",
)
"""Modules whose names are promised; what a module without `__all__` promises are its own classes."""


def promised(module: str) -> list[str]:
    """Return the names that a module promises, with the module before them."""
    loaded = importlib.import_module(module)
    own = [name for name, value in vars(loaded).items() if getattr(value, "__module__", "") == module]
    return [f"{module}.{name}" for name in getattr(loaded, "__all__", own)]


def not_rendered(rendered: Collection[str]) -> list[str]:
    """Return every promised name that is not among those that the site describes."""
    return [name for module in PUBLIC for name in promised(module) if name not in rendered]
