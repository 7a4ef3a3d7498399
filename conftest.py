"""Tests that take long say why, so that ``make quick`` can leave them out; one that does not say it fails."""

from __future__ import annotations

import _posixsubprocess
import os
import subprocess
from collections.abc import Generator
from typing import Any, NoReturn

import pytest

from tutorstudent.study.runs import jobs

TAKES_LONG = {
    "process": [
        (subprocess.Popen, "__init__"),
        (os, "fork"),
        (os, "posix_spawn"),
        (_posixsubprocess, "fork_exec"),
        (pytest, "main"),
    ],
    "study": [(jobs, "keep_run")],
}
"""What a test calls, at some depth, that has to have the marker."""


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, object, object]:
    """Refuse what a test, or a fixture made for it, has not said that it does."""

    def refuse(marker: str) -> Any:
        def refused(*_: object, **__: object) -> NoReturn:
            pytest.fail(f"this test needs @pytest.mark.{marker}: see 'markers' in pyproject.toml")

        return refused

    with pytest.MonkeyPatch.context() as patch:
        for marker, calls in TAKES_LONG.items():
            if item.get_closest_marker(marker) is None:
                for owner, name in calls:
                    patch.setattr(owner, name, refuse(marker))
        return (yield)


@pytest.fixture(autouse=True)
def _one_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """A command that is called in the tests' own process stays in it."""
    monkeypatch.setattr("tutorstudent.command.supervising.can_fork", lambda: False)
