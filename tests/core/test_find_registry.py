"""Pipelines share one discovery of the plugins as long as the same ones are installed."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests import distributions
from tutorstudent.core.files.loading import ALLOW_LIST
from tutorstudent.core.files.registry import find_registry

Install = Callable[[str], Path]
LOST = """\
import tutorstudent as ts
@ts.condition("lost")
def Lost(state):
    "It is lost."
    return False
@ts.hookimpl
def tutorstudent_components(): return [Lost]
"""


@pytest.fixture
def install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Install]:
    """Return a function that installs a plugin and returns its module's file; the module is forgotten afterwards."""
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setenv(ALLOW_LIST, "acme")

    def make(source: str) -> Path:
        distributions.install(tmp_path, "acme", source, version="2.1", module="acme_plugin")
        return tmp_path / "acme_plugin.py"

    yield make
    sys.modules.pop("acme_plugin", None)


def names() -> list[str]:
    return [installed.cls.name for installed in find_registry()]


def test_a_plugin_that_is_installed_later_is_found_by_the_next_pipeline(install: Install) -> None:
    assert "lost" not in names()
    install(LOST)
    assert "lost" in names()


def test_the_environment_counts_whenever_it_changes(install: Install, monkeypatch: pytest.MonkeyPatch) -> None:
    install(LOST)
    assert "lost" in names()
    monkeypatch.setenv(ALLOW_LIST, "")
    assert "lost" not in names()


def test_what_is_added_to_one_pipelines_registry_is_not_in_the_next_ones(install: Install) -> None:
    install(LOST)
    one = find_registry()
    one.add(type("Other", (one.get("condition", "lost"),), {"name": "other"}))
    assert "other" not in names()


def test_a_plugin_that_was_broken_is_tried_again(install: Install) -> None:
    module = install("raise RuntimeError('not yet')")
    assert ["acme"] == [broken.entry_point for broken in find_registry().broken]
    module.write_text(LOST)
    assert [] == find_registry().broken
    assert "lost" in names()
