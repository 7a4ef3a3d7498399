"""Parts that do not fit together are a type error, and parts that do are none.

Every file in ``tests/typing`` is checked with ``mypy --strict``; a line that has to be refused ends in ``# error``.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

import pytest
from mypy import api

pytestmark = pytest.mark.types

SNIPPETS = sorted((Path(__file__).with_name("typing")).glob("*_*.py"))


@pytest.fixture(scope="module")
def found() -> Mapping[str, set[int]]:
    """The lines that mypy refuses in each snippet; one run for all, since starting is what costs."""
    printed, trouble, _ = api.run(["--strict", "--no-error-summary", "--hide-error-context", *map(str, SNIPPETS)])
    assert not trouble
    lines: dict[str, set[int]] = {path.name: set() for path in SNIPPETS}
    for name, line in re.findall(r"([^/\s]+\.py):(\d+): error", printed):
        assert name in lines, f"an error outside the snippets:\n{printed}"
        lines[name].add(int(line))
    return lines


@pytest.mark.parametrize("path", SNIPPETS, ids=lambda path: path.stem)
def test_mypy_refuses_just_what_does_not_fit(path: Path, found: Mapping[str, set[int]]) -> None:
    lines = path.read_text().splitlines()
    expected = {number for number, line in enumerate(lines, 1) if line.endswith("# error")}
    assert expected == found[path.name]


def test_there_is_something_to_refuse_and_something_to_allow() -> None:
    assert {"right_wiring", "wrong_selector", "wrong_state"} <= {path.stem for path in SNIPPETS}
