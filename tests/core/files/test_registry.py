"""Plugins are found through entry points, each by itself; what is broken says why and stops nobody."""

from __future__ import annotations

import sys
import types
from importlib import metadata
from typing import Any

import pytest

from tests.core.toys import Pusher, Rail
from tutorstudent.core.files.loading import ALLOW_LIST
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.roles.hookspecs import hookimpl
from tutorstudent.core.roles.interfaces import Tutor
from tutorstudent.core.roles.part import Component
from tutorstudent.core.words.errors import BrokenPlugin, DuplicatePlugin, UnknownPlugin


class Abstract(Tutor[Any, Any]):
    name = "abstract"


class Unnamed(Rail):
    name = "Not A Name"


class Nameless(Rail):
    name = None


class Roleless(Component):
    name = "roleless"


def returning(answer: Any) -> Any:
    @hookimpl
    def tutorstudent_components() -> Any:
        return answer

    return tutorstudent_components


@pytest.fixture
def plugin(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Return a function that makes an entry point of a module with the given contents."""

    def make(name: str, **contents: Any) -> metadata.EntryPoint:
        module = types.ModuleType(f"fake_{name}")
        for key, value in contents.items():
            setattr(module, key, value)
        monkeypatch.setitem(sys.modules, module.__name__, module)
        return metadata.EntryPoint(name, module.__name__, "tutorstudent")

    return make


def hook(*classes: Any) -> Any:
    @hookimpl
    def tutorstudent_components() -> list[Any]:
        return list(classes)

    return tutorstudent_components


def test_the_shipped_plugins_all_load() -> None:
    assert [] == Registry.discover().broken


@pytest.mark.parametrize(
    ("role", "names"),
    [
        ("tutor", {"prototype2"}),
        ("student", {"backprop", "sklearn", "table", "silent", "constant", "random", "ramp"}),
        ("selector", {"same-kind", "modifier"}),
        ("amplifier", {"learning-phase", "never"}),
        ("evaluator", {"conditions", "blind"}),
        ("world", {"pioneer"}),
        ("encoder", {"prototype2-bits", "prototype2-situation-bits", "prototype2-thermometer", "ranges"}),
        ("codec", {"kind-level-ampbit", "level-ampbit"}),
        ("change", {"additive", "multiplicative"}),
        ("condition", {"bumped", "near", "any-of", "all-of", "not"}),
        ("observer", {"attractors"}),
    ],
)
def test_every_role_has_its_shipped_parts(role: str, names: set[str]) -> None:
    found = Registry.discover().of(role)
    assert names <= {installed.cls.name for installed in found if installed.distribution.startswith("tutorstudent ")}


def test_a_third_party_is_found(plugin: Any) -> None:
    registry = Registry.discover([plugin("acme", tutorstudent_components=hook(Pusher))])
    assert Pusher is registry.get("tutor", "pusher")


@pytest.mark.parametrize(
    ("contents", "reason"),
    [
        ({}, "'fake_bad' has no hook tutorstudent_components() marked with @tutorstudent.hookimpl."),
        ({"tutorstudent_component": hook(Pusher)}, "unknown hook 'tutorstudent_component' in plugin"),
        ({"tutorstudent_components": hook(Abstract)}, "tutor 'abstract' (Abstract) does not implement act."),
        (
            {"tutorstudent_components": hook("pusher")},
            "tutorstudent_components() returned 'pusher'; return part classes.",
        ),
        ({"tutorstudent_components": hook(Unnamed)}, "Unnamed has the name 'Not A Name'; names are like"),
        ({"tutorstudent_components": hook(Nameless)}, "Nameless has the name 'None'; names are like"),
        ({"tutorstudent_components": returning(None)}, "tutorstudent_components() returned []; return a list"),
        ({"tutorstudent_components": returning(Pusher)}, "return a list of part classes."),
        ({"tutorstudent_components": hook(Roleless)}, "Roleless has the role ''; roles are"),
        ({"tutorstudent_components": hook(Pusher, Pusher)}, "tutor 'pusher' of 'bad' is there twice"),
    ],
)
def test_a_broken_plugin_says_why_and_stops_nobody(plugin: Any, contents: Any, reason: str) -> None:
    if "tutorstudent_component" in contents:
        contents["tutorstudent_component"].__name__ = "tutorstudent_component"
    registry = Registry.discover([plugin("bad", **contents), plugin("good", tutorstudent_components=hook(Rail))])
    assert Rail is registry.get("world", "rail")
    assert ["bad"] == [broken.entry_point for broken in registry.broken]
    assert reason in registry.broken[0].reason
    assert registry.broken[0].remedy


def test_an_import_error_names_what_is_missing() -> None:
    registry = Registry.discover([metadata.EntryPoint("gone", "no_such_module_at_all", "tutorstudent")])
    assert "No module named 'no_such_module_at_all'." == registry.broken[0].reason
    assert "Install 'no_such_module_at_all'" in registry.broken[0].remedy
    assert "Traceback" in registry.broken[0].trace


@pytest.mark.parametrize(
    ("error", "reason"),
    [
        (SystemExit, "it ended the program while it was loaded (SystemExit: boom)."),
        (RuntimeError, "RuntimeError: boom"),
        (BaseException, "BaseException: boom"),
    ],
)
def test_a_hook_that_raises_anything_stops_nobody(plugin: Any, error: type[BaseException], reason: str) -> None:
    @hookimpl
    def tutorstudent_components() -> list[Any]:
        raise error("boom")

    registry = Registry.discover([plugin("bad", tutorstudent_components=tutorstudent_components)])
    assert reason == registry.broken[0].reason


def test_the_second_of_one_name_is_broken_as_a_whole(plugin: Any) -> None:
    registry = Registry.discover(
        [
            plugin("first", tutorstudent_components=hook(Pusher)),
            plugin("second", tutorstudent_components=hook(Rail, Pusher)),
        ]
    )
    assert ["second"] == [broken.entry_point for broken in registry.broken]
    assert "already there, from 'first'" in registry.broken[0].reason
    with pytest.raises(BrokenPlugin, match="no world named 'rail': the plugin 'second' .* could not be loaded: tutor"):
        registry.get("world", "rail")


def test_adding_a_name_twice_is_refused() -> None:
    registry = Registry()
    registry.add(Pusher)
    with pytest.raises(DuplicatePlugin, match="tutor 'pusher' of '' is already there"):
        registry.add(Pusher)


def test_an_unknown_name_says_what_is_there_and_what_was_meant() -> None:
    with pytest.raises(UnknownPlugin) as caught:
        Registry.discover().get("tutor", "protoype2")
    assert "no tutor named 'protoype2' (did you mean 'prototype2'?). Installed: " in str(caught.value)


def test_a_name_of_another_role_is_told_apart() -> None:
    with pytest.raises(UnknownPlugin, match="There is a student of that name"):
        Registry.discover().get("tutor", "backprop")


def test_naming_a_broken_plugin_says_that_it_is_broken() -> None:
    registry = Registry.discover([metadata.EntryPoint("acme_nav", "no_such_module_at_all", "tutorstudent")])
    with pytest.raises(BrokenPlugin, match="the plugin 'acme_nav' .* could not be loaded: No module named"):
        registry.get("tutor", "acme-nav")
    with pytest.raises(UnknownPlugin, match="could not be loaded and may provide it: 'acme_nav' .*: No module named"):
        registry.get("tutor", "other")


@pytest.mark.parametrize(
    ("returned", "role", "name", "reason"),
    [
        ([Abstract], "tutor", "abstract", "tutor 'abstract' (Abstract) does not implement act. Tell the authors of"),
        ([Abstract, Rail], "world", "rail", "tutor 'abstract' (Abstract) does not implement act."),
        ([Rail, Pusher()], "tutor", "pusher", "return part classes."),
        ([Rail, Rail], "world", "rail", "world 'rail' of 'bad' is there twice; rename one of them."),
    ],
)
def test_naming_a_part_of_a_broken_plugin_says_why_it_is_not_there(
    plugin: Any, returned: list[Any], role: str, name: str, reason: str
) -> None:
    registry = Registry.discover([plugin("bad", tutorstudent_components=hook(*returned))])
    with pytest.raises(BrokenPlugin) as caught:
        registry.get(role, name)
    assert f"no {role} named '{name}': the plugin 'bad' (unknown distribution) could not be loaded: " in str(
        caught.value
    )
    assert reason in str(caught.value)
    with pytest.raises(UnknownPlugin):
        registry.get("student", name)


def test_a_reason_of_several_lines_becomes_one(plugin: Any) -> None:
    misspelt = hook(Pusher)
    misspelt.__name__ = "tutorstudent_component"
    registry = Registry.discover([plugin("bad", tutorstudent_component=misspelt)])
    assert "\n" not in registry.broken[0].explain()


def test_the_allow_list_limits_third_parties_only(plugin: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    points = [plugin("one", tutorstudent_components=hook(Pusher)), plugin("two", tutorstudent_components=hook(Rail))]
    monkeypatch.setenv(ALLOW_LIST, "two")
    registry = Registry.discover([*points, *metadata.entry_points(group="tutorstudent")])
    assert Rail is registry.get("world", "rail")
    assert "same-kind" == registry.get("selector", "same-kind").name
    with pytest.raises(UnknownPlugin, match="no tutor named 'pusher'"):
        registry.get("tutor", "pusher")
