"""Every fault is one change, and the file that it is put into can still be compiled."""

from __future__ import annotations

import ast

import pytest

from tests.mutants.__main__ import FILES, ROOT
from tests.mutants.operators import make_mutants

FAULTS = {
    "return a < b": {"return a <= b", "return None"},
    "return a is not b": {"return a is b", "return None"},
    "return a + b": {"return a - b", "return None"},
    "return a and b": {"return a or b", "return None"},
    "return 3": {"return 4", "return None"},
    "return True": {"return False", "return None"},
    "return None": set(),
    "return a if b else c": {"return a if not b else c", "return None"},
    "a = b": {"pass"},
    "raise a": {"pass"},
}


@pytest.mark.parametrize("statement", FAULTS)
def test_faults_of(statement: str) -> None:
    found = {mutant.source.split("\n    ")[1] for mutant in make_mutants(f"def f(a, b, c):\n    {statement}\n")}
    assert found == FAULTS[statement]


def test_a_docstring_is_no_statement() -> None:
    assert [] == list(make_mutants('def f():\n    """Say nothing."""\n'))


@pytest.mark.parametrize("file", FILES)
def test_every_mutant_differs_and_can_be_compiled(file: str) -> None:
    source = (ROOT / "tutorstudent" / file).read_text(encoding="utf-8")
    plain, mutants = ast.unparse(ast.parse(source)), list(make_mutants(source))
    assert len(mutants) > 10
    for mutant in mutants[::10]:
        assert mutant.source != plain
        compile(mutant.source, file, "exec")
