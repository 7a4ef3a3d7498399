"""The script in examples/wrap runs as it is."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "wrap" / "pid.py"


def test_the_pid_in_the_owners_own_loop_is_amplified_without_an_incident(capsys: pytest.CaptureFixture[str]) -> None:
    names = runpy.run_path(str(SCRIPT))
    assert "incidents 0" in capsys.readouterr().out
    assert 0 < names["done"]
    assert 0 < names["level"]
