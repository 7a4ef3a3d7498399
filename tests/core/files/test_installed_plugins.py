"""Real distributions on the path: whatever one of them does, the others load, and it is told why and what to do."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests import distributions
from tutorstudent.core.files.loading import ALLOW_LIST, TRACE, Broken
from tutorstudent.core.files.pipeline import load
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.roles.hookspecs import API
from tutorstudent.core.words.errors import BrokenPlugin, UnknownPlugin

Install = Callable[..., None]
GOOD = """\
import tutorstudent as ts
@ts.condition("NAME")
def Lost(state):
    "It is lost."
    return False
@ts.hookimpl
def tutorstudent_components(): return [Lost]
"""
ABSTRACT = """\
import tutorstudent as ts
class Unfinished(ts.Tutor):
    name = "unfinished"
@ts.hookimpl
def tutorstudent_components(): return [Unfinished]
"""
UNNAMEABLE = """\
import tutorstudent as ts
class Nameless(type(ts.Tutor)):
    @property
    def name(cls): raise RuntimeError("no name")
class Bad(ts.Tutor, metaclass=Nameless):
    action = ts.scalar(-1, 1)
    def act(self, state): pass
@ts.hookimpl
def tutorstudent_components(): return [Bad]
"""


@pytest.fixture
def install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Install]:
    """Return a function that installs a distribution with one module; the modules are forgotten afterwards."""
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setenv(ALLOW_LIST, "acme,good,bad,worse")
    before = set(sys.modules)

    def make(name: str, source: str = GOOD, points: str | None = None, version: str = "2.1") -> None:
        text = source.replace("NAME", f"{name}-condition")
        distributions.install(tmp_path, name, text, version=version, module=f"{name}_plugin", points=points or "")

    yield make
    for module in set(sys.modules) - before:
        del sys.modules[module]


def broken() -> list[Broken]:
    return Registry.discover().broken


def test_a_third_party_is_found_with_its_distribution(install: Install) -> None:
    install("acme")
    found = {item.cls.name: item.distribution for item in Registry.discover().of("condition")}
    assert "acme 2.1" == found["acme-condition"]


@pytest.mark.parametrize(
    ("source", "reason", "remedy"),
    [
        ("import no_such_thing", "No module named 'no_such_thing'.", "Install 'no_such_thing' (perhaps as an extra of"),
        ("from tutorstudent import nothing", "ImportError: cannot import name 'nothing'", "Tell the authors of bad"),
        ("raise SystemExit(3)", "it ended the program while it was loaded (SystemExit: 3).", "Tell the authors of bad"),
        (
            "import sys; sys.exit('no')",
            "it ended the program while it was loaded (SystemExit: no).",
            "or uninstall it.",
        ),
        ("def broken(:", "SyntaxError: invalid syntax", "Tell the authors of bad, or uninstall it."),
        ("1 / 0", "ZeroDivisionError: division by zero", "Tell the authors of bad"),
        ("", "'bad_plugin' has no hook tutorstudent_components() marked with @tutorstudent.hookimpl.", "Tell the auth"),
        (
            "def tutorstudent_components(): return []",
            "'bad_plugin' has no hook tutorstudent_components() marked",
            "Tell",
        ),
        (
            GOOD.replace("_components", "_component"),
            "unknown hook 'tutorstudent_component'",
            "The hook is tutor",
        ),
        (
            GOOD.replace("components()", "components(x)"),
            "Argument(s) {'x'} are declared in the hookimpl",
            "without argu",
        ),
        (GOOD.replace("return [Lost]", "raise KeyError(1)"), "KeyError: 1", "Tell the authors of bad"),
        (
            GOOD.replace("return [Lost]", "return Lost"),
            "return a list of part classes.",
            "Tell the authors of bad",
        ),
        (GOOD.replace("return [Lost]", "return None"), "returned []; return a list of part classes.", "Tell"),
        (GOOD.replace("return [Lost]", "return [Lost()]"), "return part classes.", "Tell the authors of bad"),
        (GOOD.replace("[Lost]", "[ts.Tutor]"), "Tutor has the name ''; names are like 'wall-follower'.", "Tell"),
        (
            GOOD.replace("NAME", "bumped"),
            "condition 'bumped' of 'bad' is already there, from 'conditions' (tutors",
            "Te",
        ),
        (
            f"tutorstudent_api = {API + 1}\n{GOOD}",
            f"it is written for version {API + 1} of the plugin interface; und",
            "U",
        ),
        (f"tutorstudent_api = {API + 1}\n{GOOD}", "", "Upgrade tutorstudent, or uninstall bad."),
        (
            f"tutorstudent_api = 0\n{GOOD}",
            "it is written for version 0 of the plugin interface",
            "Upgrade bad, or uninst",
        ),
        (f"tutorstudent_api = '1'\n{GOOD}", "tutorstudent_api is '1'; write a whole number", "Tell the authors of bad"),
    ],
)
def test_a_broken_distribution_is_told_with_reason_and_remedy_and_stops_nobody(
    install: Install, source: str, reason: str, remedy: str
) -> None:
    install("bad", source)
    install("good")
    registry = Registry.discover()
    assert registry.get("condition", "good-condition")
    assert registry.get("condition", "bumped")
    (found,) = registry.broken
    assert ("bad", "bad 2.1") == (found.entry_point, found.distribution)
    assert reason in found.reason
    assert remedy in found.remedy
    assert "Traceback" in found.trace


def test_a_part_that_cannot_even_tell_its_name_stops_nobody(install: Install) -> None:
    install("good")
    install("bad", UNNAMEABLE)
    (record,) = broken()
    assert ("bad", "RuntimeError: no name", ()) == (record.entry_point, record.reason.rstrip("."), record.parts)
    assert "good-condition" in [item.cls.name for item in Registry.discover().of("condition")]


def test_a_plugin_for_this_version_loads(install: Install) -> None:
    install("good", f"tutorstudent_api = {API}\n{GOOD}")
    assert [] == broken()


@pytest.mark.parametrize("points", ["[tutorstudent]\nbad\n", "[tutorstudent]\nbad = not a module:x:y\n"])
def test_a_damaged_list_of_entry_points_stops_nobody(install: Install, points: str) -> None:
    install("bad", points=points)
    install("good")
    registry = Registry.discover()
    assert registry.get("condition", "good-condition")
    assert registry.get("condition", "bumped")
    assert ["bad 2.1"] == [item.distribution for item in registry.broken]


def test_the_second_distribution_of_one_name_is_the_broken_one(install: Install) -> None:
    install("acme", GOOD.replace("NAME", "same"))
    install("bad", GOOD.replace("NAME", "same"))
    (found,) = broken()
    assert "condition 'same' of 'bad' is already there, from 'acme' (acme 2.1); rename one of them." == found.reason


def test_a_pipeline_that_names_a_broken_plugin_is_told_so_again(install: Install) -> None:
    install("bad", "import no_such_thing")
    registry = Registry.discover()
    with pytest.raises(
        BrokenPlugin, match=r"the plugin 'bad' \(bad 2.1\) could not be loaded: No module named 'no_such"
    ):
        registry.get("tutor", "bad")
    with pytest.raises(UnknownPlugin, match=r"could not be loaded and may provide it: 'bad' \(bad 2.1\)"):
        registry.get("tutor", "wall-follower")


def test_a_pipeline_that_names_a_part_of_a_broken_plugin_is_told_the_reason_and_the_place(
    install: Install, tmp_path: Path
) -> None:
    install("bad", ABSTRACT)
    path = tmp_path / "p.yaml"
    path.write_text("seed: 7\ntutor: unfinished\nstudent: silent\n")
    with pytest.raises(BrokenPlugin) as caught:
        load(path)
    assert (
        f"{path}:2:1: tutor: no tutor named 'unfinished': the plugin 'bad' (bad 2.1) could not be loaded: "
        "tutor 'unfinished' (Unfinished) does not implement act. Tell the authors of bad, or uninstall it."
    ) == str(caught.value)


@pytest.mark.parametrize(
    ("allowed", "names"),
    [
        (None, {"acme-condition", "good-condition"}),
        ("", set()),
        (" , ", set()),
        ("acme", {"acme-condition"}),
        ("ACME, good", {"acme-condition", "good-condition"}),
        ("other", set()),
        ("acme-point", {"acme-condition"}),
        ("Acme_Point", {"acme-condition"}),
    ],
)
def test_the_environment_says_which_third_parties_are_loaded(
    install: Install, monkeypatch: pytest.MonkeyPatch, allowed: str | None, names: set[str]
) -> None:
    install("acme", points="[tutorstudent]\nacme-point = acme_plugin\n")
    install("good")
    if allowed is None:
        monkeypatch.delenv(ALLOW_LIST)
    else:
        monkeypatch.setenv(ALLOW_LIST, allowed)
    found = {item.cls.name for item in Registry.discover().of("condition")}
    assert names == found & {"acme-condition", "good-condition"}
    assert "bumped" in found


@pytest.mark.parametrize(("value", "told"), [("1", True), ("0", False), ("", False)])
def test_calls_of_hooks_are_traced_on_request(
    install: Install, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], value: str, told: bool
) -> None:
    install("acme")
    monkeypatch.setenv(TRACE, value)
    Registry.discover()
    assert told == ("acme: tutorstudent_components [hook]" in capsys.readouterr().err)
