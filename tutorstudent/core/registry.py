"""Finds the installed plugins. Each entry point is loaded by itself: a broken one never stops the others."""

from __future__ import annotations

import inspect
import os
import re
import traceback
from collections.abc import Iterable, Iterator
from importlib import metadata
from typing import NamedTuple

import pluggy

from tutorstudent.core import hookspecs
from tutorstudent.core.component import Component
from tutorstudent.core.errors import BrokenPlugin, DuplicatePlugin, UnknownPlugin, listing, suggestion
from tutorstudent.core.interfaces import ActionSelector, Amplifier, Evaluator, Student, Tutor
from tutorstudent.core.leaves import Change, Codec, Condition, Encoder
from tutorstudent.core.observers import Observer
from tutorstudent.core.world import World

GROUP = hookspecs.PROJECT
ALLOW_LIST = "TUTORSTUDENT_LOAD_PLUGINS"
UNKNOWN = "unknown distribution"
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
    """One component class with where it comes from."""

    cls: type[Component]
    entry_point: str
    distribution: str


class Broken(NamedTuple):
    """One entry point that could not be used, and why."""

    entry_point: str
    distribution: str
    reason: str
    remedy: str
    trace: str


class Registry:
    """The components of all entry points, by role and name. An instance, handed about; nothing is global."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, str], Installed] = {}
        self.broken: list[Broken] = []

    @classmethod
    def discover(cls, entry_points: Iterable[metadata.EntryPoint] | None = None) -> Registry:
        """Return a registry of all installed plugins.

        The environment variable TUTORSTUDENT_LOAD_PLUGINS limits the third parties' to the entry points that it names,
        separated by commas.
        """
        registry = cls()
        found = metadata.entry_points(group=GROUP) if entry_points is None else entry_points
        allowed = os.environ.get(ALLOW_LIST)
        names = None if allowed is None else {name.strip() for name in allowed.split(",")}
        for entry_point in sorted(found, key=lambda ep: (not _ours(ep), _distribution(ep), ep.name)):
            if names is None or _ours(entry_point) or entry_point.name in names:
                registry.load(entry_point)
        return registry

    def load(self, entry_point: metadata.EntryPoint) -> None:
        """Add the components of one entry point: all of them, or none and a `Broken` record."""
        distribution = _distribution(entry_point)
        try:
            classes = list(_components(entry_point))
            for cls in classes:
                self._check(cls, entry_point.name)
            _check_doubles(classes, entry_point.name)
        except KeyboardInterrupt:
            raise
        except BaseException as error:
            reason, remedy = _diagnosis(error, distribution)
            self.broken.append(Broken(entry_point.name, distribution, reason, remedy, traceback.format_exc()))
            return
        for cls in classes:
            self.add(cls, entry_point.name, distribution)

    def add(self, cls: type[Component], entry_point: str = "", distribution: str = "this program") -> None:
        """Add one component class."""
        self._check(cls, entry_point)
        self._found[cls.role, cls.name] = Installed(cls, entry_point, distribution)

    def get(self, role: str, name: str) -> type[Component]:
        """Return the component of that role and name.

        Raises:
            UnknownPlugin: if there is none.
            BrokenPlugin: if there is none and an entry point of that name could not be loaded.
        """
        if (role, name) in self._found:
            return self._found[role, name].cls
        for broken in self.broken:
            if name in (broken.entry_point, broken.entry_point.replace("_", "-")):
                raise BrokenPlugin(
                    f"no {role} named '{name}': the plugin '{broken.entry_point}' ({broken.distribution}) could not be "
                    f"loaded: {broken.reason} {broken.remedy}"
                )
        known = [installed.cls.name for installed in self.of(role)]
        others = ", ".join(f"'{broken.entry_point}' ({broken.distribution})" for broken in self.broken)
        hint = f" These plugins could not be loaded and may provide it: {others}." if others else ""
        elsewhere = [found_role for found_role, found_name in self._found if found_name == name]
        if elsewhere:
            hint = f" There is a {elsewhere[0]} of that name.{hint}"
        article = "an" if role[0] in "aeiou" else "a"
        raise UnknownPlugin(
            f"no {role} named '{name}'{suggestion(name, known)}. Installed: {listing(known)}.{hint} "
            f"`tutorstudent plugins list` shows all; a package with {article} {role} is installed with pip."
        )

    def of(self, role: str) -> list[Installed]:
        """Return the components of a role, by name."""
        return [self._found[key] for key in sorted(self._found) if key[0] == role]

    def __iter__(self) -> Iterator[Installed]:
        return iter([self._found[key] for key in sorted(self._found)])

    def _check(self, cls: type[Component], entry_point: str) -> None:
        if not (inspect.isclass(cls) and issubclass(cls, Component)):
            raise BrokenPlugin(f"tutorstudent_components() returned {cls!r}; return component classes.")
        if cls.role not in ROLES or not issubclass(cls, ROLES[cls.role]):
            raise BrokenPlugin(f"{cls.__name__} has the role '{cls.role}'; roles are {listing(ROLES)}.")
        if not (isinstance(cls.name, str) and _NAME.fullmatch(cls.name)):
            raise BrokenPlugin(f"{cls.__name__} has the name '{cls.name}'; names are like 'wall-follower'.")
        if inspect.isabstract(cls):
            missing = listing(getattr(cls, "__abstractmethods__", ()))
            raise BrokenPlugin(f"{cls.role} '{cls.name}' ({cls.__name__}) does not implement {missing}.")
        taken = self._found.get((cls.role, cls.name))
        if taken is not None:
            raise DuplicatePlugin(
                f"{cls.role} '{cls.name}' of '{entry_point}' is already there, from "
                f"'{taken.entry_point}' ({taken.distribution}); rename one of them."
            )


def _components(entry_point: metadata.EntryPoint) -> Iterator[type[Component]]:
    # A plugin manager for each entry point: what one of them registers cannot disturb the next.
    manager = pluggy.PluginManager(hookspecs.PROJECT)
    manager.add_hookspecs(hookspecs)
    manager.register(entry_point.load(), name=entry_point.name)
    manager.check_pending()
    if not manager.hook.tutorstudent_components.get_hookimpls():
        raise BrokenPlugin(
            f"'{entry_point.value}' has no hook tutorstudent_components() marked with @tutorstudent.hookimpl."
        )
    answers = manager.hook.tutorstudent_components()
    if len(answers) != 1 or not isinstance(answers[0], list | tuple | set | frozenset):
        raise BrokenPlugin(f"tutorstudent_components() returned {answers}; return a list of component classes.")
    yield from answers[0]


def _check_doubles(classes: list[type[Component]], entry_point: str) -> None:
    seen: set[tuple[str, str]] = set()
    for cls in classes:
        if (cls.role, cls.name) in seen:
            raise DuplicatePlugin(f"{cls.role} '{cls.name}' of '{entry_point}' stands there twice; rename one of them.")
        seen.add((cls.role, cls.name))


def _ours(entry_point: metadata.EntryPoint) -> bool:
    return entry_point.dist is not None and entry_point.dist.name == GROUP


def _distribution(entry_point: metadata.EntryPoint) -> str:
    dist = entry_point.dist
    return f"{dist.name} {dist.version}" if dist is not None else UNKNOWN


def _diagnosis(error: BaseException, distribution: str) -> tuple[str, str]:
    package = "its package" if distribution == UNKNOWN else distribution.split()[0]
    if isinstance(error, ModuleNotFoundError):
        return (
            f"{error.msg}.",
            f"Install '{error.name}' (perhaps as an extra of {package}), or uninstall {package}.",
        )
    if isinstance(error, pluggy.PluginValidationError):
        return f"{error}".strip(), f"The hook is called tutorstudent_components() and takes nothing; tell {package}."
    if isinstance(error, BrokenPlugin | DuplicatePlugin):
        return str(error), f"Tell the authors of {package}, or uninstall it."
    return f"{type(error).__name__}: {error}", f"Tell the authors of {package}, or uninstall it."
