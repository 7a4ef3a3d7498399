"""The study's corridor and its pipelines, for the commands that compare them."""

import pytest

from tests.study.conftest import corridor_distribution, files, registry

__all__ = ["corridor_distribution", "files", "registry"]


@pytest.fixture(autouse=True)
def _one_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """A command that is called in the tests' own process stays in it."""
    monkeypatch.setattr("tutorstudent.command.supervising.can_fork", lambda: False)
