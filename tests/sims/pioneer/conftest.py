"""Worlds of small scenes, closed at the end of each test."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from ruamel.yaml import YAML

from tutorstudent.sims.pioneer.pioneer_world import PioneerWorld


@pytest.fixture
def write_yaml(tmp_path: Path) -> Callable[[Any], Path]:
    """Return a function that writes a value to a new file and returns its path."""
    numbers = itertools.count()

    def write(content: Any) -> Path:
        path = tmp_path / f"file-{next(numbers)}.yaml"
        with path.open("w") as file:
            YAML(typ="safe", pure=True).dump(content, file)
        return path

    return write


@pytest.fixture
def make_world(write_yaml: Callable[[Any], Path]) -> Iterator[Callable[..., PioneerWorld]]:
    """Return a function that makes a world of a scene (a shipped name, or a mapping) and options."""
    worlds: list[PioneerWorld] = []

    def make(content: dict[str, Any] | str, **options: Any) -> PioneerWorld:
        name = content if isinstance(content, str) else str(write_yaml(content))
        worlds.append(PioneerWorld(scene=name, **options))
        return worlds[-1]

    yield make
    for world in worlds:
        world.close()
