"""Finds the installed plugins. Each entry point is loaded by itself: a broken one never stops the others."""

from __future__ import annotations

import inspect
import os
import re
import sys
from collections.abc import Iterable, Iterator
from functools import lru_cache
from importlib import metadata
from pathlib import Path
from typing import Any, NamedTuple

from tutorstudent.core.files.loading import (
    ALLOW_LIST,
    TRACE,
    Broken,
    find_distribution,
    find_double,
    find_entry_points,
    is_allowed,
    is_ours,
    load_parts,
    make_broken,
)
from tutorstudent.core.roles.interfaces import ActionSelector, Amplifier, Evaluator, Student, Tutor
from tutorstudent.core.roles.leaves import Change, Codec, Condition, Encoder
from tutorstudent.core.roles.part import Component
from tutorstudent.core.roles.world import World
from tutorstudent.core.running.observers import Observer
from tutorstudent.core.words.errors import (
    BrokenPlugin,
    DuplicatePlugin,
    UnknownPlugin,
    list_names,
    suggest,
    with_article,
)

ROLES: dict[str, type[Component]] = {
    role.role: role
    for role in (
        Tutor,
        Student,
        ActionSelector,
        Amplifier,
        Evaluator,
        World,
        Encoder,
        Codec,
        Change,
        Condition,
        Observer,
    )
}
_NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")


class Installed(NamedTuple):
    """One part class with where it comes from."""

    cls: type[Component]
    entry_point: str
    distribution: str


class Registry:
    """The parts of all entry points, by role and name. An object that is passed on; nothing is global."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, str], Installed] = {}
        self.broken: list[Broken] = []

    @classmethod
    def discover(cls, entry_points: Iterable[metadata.EntryPoint] | None = None) -> Registry:
        """Return a registry of all installed plugins.

        The environment variable TUTORSTUDENT_LOAD_PLUGINS names the third-party distributions and entry points that
        may be loaded, separated by commas; if it is empty, none is. With TUTORSTUDENT_TRACE=1 every call of a hook is
        printed on standard error.
        """
        registry = cls()
        found = find_entry_points(registry.broken) if entry_points is None else entry_points
        for entry_point in sorted(found, key=lambda ep: (not is_ours(ep), find_distribution(ep), ep.name)):
            if is_ours(entry_point) or is_allowed(entry_point):
                registry.load(entry_point)
        return registry

    def copy(self) -> Registry:
        """Return an independent registry of the same parts."""
        other = Registry()
        other._found, other.broken = dict(self._found), list(self.broken)
        return other

    def load(self, entry_point: metadata.EntryPoint) -> None:
        """Add the parts of one entry point: all of them, or none and a `Broken` record."""
        classes: list[type[Component]] = []
        try:
            classes += load_parts(entry_point)
            for cls in classes:
                self._check(cls, entry_point.name)
            if twice := find_double(classes):
                raise DuplicatePlugin(
                    f"{twice.role} '{twice.name}' of '{entry_point.name}' is there twice; rename one of them."
                )
        except KeyboardInterrupt:
            raise
        except BaseException as error:
            self.broken.append(make_broken(error, entry_point, classes))
            return
        for cls in classes:
            self.add(cls, entry_point.name, find_distribution(entry_point))

    def add(self, cls: type[Component], entry_point: str = "", distribution: str = "this program") -> None:
        """Add one part class."""
        self._check(cls, entry_point)
        self._found[cls.role, cls.name] = Installed(cls, entry_point, distribution)

    def get(self, role: str, name: str) -> type[Component]:
        """Return the part of that role and name.

        Raises:
            UnknownPlugin: if there is none.
            BrokenPlugin: if there is none, and a plugin that has it, or is of that name, could not be loaded.
        """
        if (role, name) in self._found:
            return self._found[role, name].cls
        self.check_not_broken(name, role)
        known = [installed.cls.name for installed in self.of(role)]
        elsewhere = [found_role for found_role, found_name in self._found if found_name == name]
        hint = f" There is {with_article(elsewhere[0])} of that name." if elsewhere else ""
        raise UnknownPlugin(
            f"no {role} named '{name}'{suggest(name, known)}. Installed: {list_names(known)}.{hint} "
            f"`tutorstudent plugins list` shows all; a package with {with_article(role)} is installed with pip."
            f"{self.suspects()}"
        )

    def check_not_broken(self, name: str, role: str | None = None) -> None:
        """Raise if the part is missing because its plugin could not be loaded.

        Raises:
            BrokenPlugin: if so; the message has the reason and the remedy.
        """
        for broken in self.broken:
            if broken.provides(name, role):
                raise BrokenPlugin(
                    f"no {role or 'part'} named '{name}': the plugin '{broken.entry_point}' ({broken.distribution}) "
                    f"could not be loaded: {broken.reason} {broken.remedy}"
                )

    def suspects(self) -> str:
        """Return a sentence about broken plugins, which may provide what is missing, or nothing."""
        others = " ".join(broken.explain() for broken in self.broken)
        return f" These plugins could not be loaded and may provide it: {others}" if others else ""

    def of(self, role: str) -> list[Installed]:
        """Return the parts of a role, by name."""
        return [self._found[key] for key in sorted(self._found) if key[0] == role]

    def __iter__(self) -> Iterator[Installed]:
        return iter([self._found[key] for key in sorted(self._found)])

    def _check(self, cls: type[Component], entry_point: str) -> None:
        if not (inspect.isclass(cls) and issubclass(cls, Component)):
            raise BrokenPlugin(f"tutorstudent_components() returned {cls!r}; return part classes.")
        if cls.role not in ROLES or not issubclass(cls, ROLES[cls.role]):
            raise BrokenPlugin(f"{cls.__name__} has the role '{cls.role}'; roles are {list_names(ROLES)}.")
        if not (isinstance(cls.name, str) and _NAME.fullmatch(cls.name)):
            raise BrokenPlugin(f"{cls.__name__} has the name '{cls.name}'; names are like 'wall-follower'.")
        if inspect.isabstract(cls):
            missing = list_names(getattr(cls, "__abstractmethods__", ()))
            raise BrokenPlugin(f"{cls.role} '{cls.name}' ({cls.__name__}) does not implement {missing}.")
        taken = self._found.get((cls.role, cls.name))
        if taken is not None:
            raise DuplicatePlugin(
                f"{cls.role} '{cls.name}' of '{entry_point}' is already there, from "
                f"'{taken.entry_point}' ({taken.distribution}); rename one of them."
            )


def find_registry() -> Registry:
    """Return `Registry.discover()`, kept in memory until something is installed or removed; broken plugins are retried.

    Discovering takes a tenth of a second, too long for a program that builds many pipelines.
    """
    found = _discover(_stamp_installed())
    if found.broken:
        _discover.cache_clear()
    return found.copy()


@lru_cache(maxsize=1)
def _discover(_: tuple[Any, ...]) -> Registry:
    return Registry.discover()


def _stamp_installed() -> tuple[Any, ...]:
    # A distribution that comes or goes changes its folder; the environment says which plugins are loaded.
    folders = tuple((folder, _read_time(Path(folder))) for folder in sys.path)
    return folders, os.environ.get(ALLOW_LIST), os.environ.get(TRACE)


def _read_time(folder: Path) -> int:
    try:
        return folder.stat().st_mtime_ns
    except OSError:
        return 0
