"""The examples with Gymnasium run, and say what is missing."""

from __future__ import annotations

import runpy
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parents[1] / "examples" / "gymnasium"


def test_the_wrapped_pendulum_runs(capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(HERE / "pendulum.py"))["main"](100)
    alone, wrapped = capsys.readouterr().out.splitlines()
    assert alone.startswith("alone: reward -")
    assert wrapped.endswith("of 100 decisions")


def test_without_stable_baselines_there_is_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "stable_baselines3", None)
    main = runpy.run_path(str(HERE / "stable_baselines.py"))["main"]
    assert "needs Stable-Baselines3; install it with: pip install stable-baselines3" in main(["p.yaml"])
    assert main([]).startswith("usage: ")
