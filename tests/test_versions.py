"""Lower bounds of dependencies: `make lowest` installs them, so they are the same in every file."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[1]
OTHERS = [*sorted((ROOT / "examples").glob("*/pyproject.toml")), *(ROOT / "tutorstudent/templates/files").rglob("*.in")]
FILES = [path for path in OTHERS if path.name.startswith("pyproject")]


def read(path: Path) -> Mapping[str, Any]:
    return tomllib.loads(path.read_text(encoding="utf-8").replace("$", ""))  # templates have placeholders


def dependencies(project: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield name and bound of every dependency on another project."""
    extras = project.get("optional-dependencies", {})
    for requirement in [*project.get("dependencies", []), *(item for items in extras.values() for item in items)]:
        name, bound = re.fullmatch(r"([\w.-]+)(?:\[[\w,]+\])?(.*)", requirement).groups()
        if name != "tutorstudent":
            yield name, bound


OWN = sorted(set(dependencies(read(ROOT / "pyproject.toml")["project"])))


def test_every_dependency_has_one_lower_bound() -> None:
    assert [] == [f"{name}{bound}" for name, bound in OWN if not re.fullmatch(r">=[\d.]+", bound)]
    assert len(OWN) == len({name for name, _ in OWN})


@pytest.mark.parametrize("path", FILES, ids=[path.parent.name for path in FILES])
def test_other_projects_have_the_same_bounds(path: Path) -> None:
    known = dict(OWN)
    found = [(name, bound) for name, bound in dependencies(read(path)["project"]) if name in known]
    assert found
    assert [] == [f"{name}{bound}" for name, bound in found if bound != known[name]]


def test_the_versions_of_python_that_are_named_are_those_that_were_run() -> None:
    named = {line.split(" :: ")[-1] for line in read(ROOT / "pyproject.toml")["project"]["classifiers"] if "3." in line}
    page = (ROOT / "docs" / "versions.md").read_text(encoding="utf-8")
    assert named == set(re.findall(r"^\| (3\.\d+)", page, flags=re.MULTILINE))
