"""The entry points of plugins: what they provide, or why they cannot be used."""

from __future__ import annotations

import inspect
import os
import re
import sys
import traceback
from collections.abc import Iterable, Iterator
from importlib import metadata
from typing import Any, NamedTuple

import pluggy

from tutorstudent.core.roles import hookspecs
from tutorstudent.core.roles.part import Component
from tutorstudent.core.words.errors import BrokenPlugin, DuplicatePlugin

GROUP = hookspecs.PROJECT
ALLOW_LIST = "TUTORSTUDENT_LOAD_PLUGINS"
TRACE = "TUTORSTUDENT_TRACE"
UNKNOWN = "unknown distribution"


class Broken(NamedTuple):
    """One entry point that could not be used, and why."""

    entry_point: str
    distribution: str
    reason: str
    remedy: str
    trace: str
    parts: tuple[tuple[str, str], ...] = ()
    """Role and name of what its hook returned, if it got that far."""

    def explain(self) -> str:
        """Return what it is, why it could not be used, and what to do."""
        return f"'{self.entry_point}' ({self.distribution}): {self.reason} {self.remedy}"

    def provides(self, name: str, role: str | None = None) -> bool:
        """Return whether it has that name or would have provided such a part (of any role, if none is given)."""
        if name in (self.entry_point, self.entry_point.replace("_", "-")):
            return True
        return any(name == part_name and role in (None, part_role) for part_role, part_name in self.parts)


def find_entry_points(broken: list[Broken]) -> list[metadata.EntryPoint]:
    """Return the entry points of all plugins; a distribution whose list cannot be read is added to `broken`."""
    try:
        return list(metadata.entry_points(group=GROUP))
    except Exception:  # one damaged list spoils the whole answer; ask each distribution by itself
        return list(_ask_each_distribution(broken))


def _ask_each_distribution(broken: list[Broken]) -> Iterator[metadata.EntryPoint]:
    seen: set[str] = set()
    for dist in metadata.distributions():
        name = str(dist.metadata["Name"])
        if name in seen:
            continue
        seen.add(name)
        try:
            found = list(dist.entry_points.select(group=GROUP))
        except Exception as error:
            reason = f"its entry points cannot be read ({type(error).__name__}: {error})."
            remedy = f"Tell the authors of {name}, or uninstall it."
            broken.append(Broken("?", f"{name} {dist.version}", reason, remedy, traceback.format_exc()))
            continue
        yield from found


def is_allowed(entry_point: metadata.EntryPoint) -> bool:
    """Return whether the environment lets a third party's entry point be loaded."""
    text = os.environ.get(ALLOW_LIST)
    if text is None:
        return True
    names = {_normalise(name) for name in text.split(",") if name.strip()}
    return bool(names & {_normalise(entry_point.name), _normalise(find_distribution(entry_point).split()[0])})


def _normalise(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name.strip()).lower()


def load_parts(entry_point: metadata.EntryPoint) -> Iterator[type[Component]]:
    """Yield what the hook of one entry point returns.

    Raises:
        BrokenPlugin: if there is no such hook, it returns something else, or is written for another version.
    """
    # A plugin manager for each entry point: what one of them registers cannot disturb the next.
    manager = pluggy.PluginManager(hookspecs.PROJECT)
    manager.add_hookspecs(hookspecs)
    plugin = entry_point.load()
    if inspect.isclass(plugin):
        raise BrokenPlugin(
            f"'{entry_point.value}' names the class {plugin.__name__}; an entry point names the module with the hook "
            f'tutorstudent_components(), as in {entry_point.name} = "{entry_point.module}".'
        )
    _check_version(plugin)
    manager.register(plugin, name=entry_point.name)
    manager.check_pending()
    if not manager.hook.tutorstudent_components.get_hookimpls():
        raise BrokenPlugin(
            f"'{entry_point.value}' has no hook tutorstudent_components() marked with @tutorstudent.hookimpl."
        )
    if os.environ.get(TRACE, "") not in ("", "0"):
        manager.trace.root.setwriter(lambda text: sys.stderr.write(f"{entry_point.name}: {text.strip()}\n"))
        manager.enable_tracing()
    answers = manager.hook.tutorstudent_components()
    if len(answers) != 1 or not isinstance(answers[0], list | tuple | set | frozenset):
        raise BrokenPlugin(f"tutorstudent_components() returned {answers}; return a list of part classes.")
    yield from answers[0]


class TooNew(BrokenPlugin):
    """A plugin is written for a newer version of the interface than this one."""


class TooOld(BrokenPlugin):
    """A plugin is written for a version of the interface that is no longer understood."""


def _check_version(plugin: Any) -> None:
    version = getattr(plugin, "tutorstudent_api", hookspecs.API)
    if type(version) is not int:
        raise BrokenPlugin(f"tutorstudent_api is {version!r}; write a whole number, as in tutorstudent_api = 1.")
    if not hookspecs.OLDEST_API <= version <= hookspecs.API:
        kind = TooNew if version > hookspecs.API else TooOld
        raise kind(
            f"it is written for version {version} of the plugin interface; understood here: "
            f"{hookspecs.OLDEST_API} to {hookspecs.API}."
        )


def is_ours(entry_point: metadata.EntryPoint) -> bool:
    """Return whether an entry point comes with this package."""
    return entry_point.dist is not None and entry_point.dist.name == GROUP


def find_distribution(entry_point: metadata.EntryPoint) -> str:
    """Return name and version of the distribution of an entry point."""
    dist = entry_point.dist
    return f"{dist.name} {dist.version}" if dist is not None and dist.name else UNKNOWN


def make_broken(error: BaseException, entry_point: metadata.EntryPoint, returned: Iterable[Any]) -> Broken:
    """Return the record of an entry point that could not be used; `returned` is what its hook returned until then."""
    distribution = find_distribution(entry_point)
    reason, remedy = diagnose(error, distribution)
    trace = "".join(traceback.format_exception(error))
    return Broken(entry_point.name, distribution, " ".join(reason.split()), remedy, trace, tuple(_name_parts(returned)))


def _name_parts(returned: Iterable[Any]) -> Iterator[tuple[str, str]]:
    """Yield role and name of the parts; one that is too broken to have them is left out."""
    for part in returned:
        try:
            cls = part if inspect.isclass(part) else type(part)
            if issubclass(cls, Component):
                yield cls.role, cls.name
        except KeyboardInterrupt:
            raise
        except BaseException:  # noqa: S112 - the reason why it is broken has been found already
            continue


def diagnose(error: BaseException, distribution: str) -> tuple[str, str]:
    """Return reason and remedy, in sentences, for an error in loading an entry point."""
    package = "its package" if distribution == UNKNOWN else distribution.split()[0]
    remedy = f"Tell the authors of {package}, or uninstall it."
    match error:
        case ModuleNotFoundError():
            missing = f"Install '{error.name}' (perhaps as an extra of {package}), or uninstall {package}."
            return f"{error.msg}.", missing
        case pluggy.PluginValidationError():
            return str(error), f"The hook is tutorstudent_components(), without arguments; tell {package}."
        case TooNew():
            return str(error), f"Upgrade {GROUP}, or uninstall {package}."
        case TooOld():
            return str(error), f"Upgrade {package}, or uninstall it."
        case BrokenPlugin() | DuplicatePlugin():
            return str(error), remedy
        case SystemExit():
            return f"it ended the program while it was loaded (SystemExit: {error.code}).", remedy
    return f"{type(error).__name__}: {error}", remedy


def find_double(classes: Iterable[type[Component]]) -> type[Component] | None:
    """Return the first class that has role and name of one before it."""
    seen: set[tuple[str, str]] = set()
    for cls in classes:
        if (cls.role, cls.name) in seen:
            return cls
        seen.add((cls.role, cls.name))
    return None
