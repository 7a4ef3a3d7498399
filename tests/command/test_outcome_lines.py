"""What `run` says first: how far it was amplified, how often, and what held it back."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from tutorstudent.command.outcome_lines import describe_amplification
from tutorstudent.command.program import app
from tutorstudent.core.files.registry import Registry

PLANT = """\
decisions: 300
world: kettle
tutor: keeper
student: {use: table, encoder: {use: ranges, ranges: [20, 100]}, codec: level-ampbit}
conditions: [too-hot]
"""


def run(text: str, tmp_path: Path) -> str:
    (tmp_path / "p.yaml").write_text(text)
    done = CliRunner().invoke(app, ["run", str(tmp_path / "p.yaml"), "--out", str(tmp_path / "run")])
    assert 0 == done.exit_code, done.output
    return done.stdout


def test_the_ratio_is_told_without_decisions_at_neutral_and_every_limit_is_counted() -> None:
    arrays = {
        "executed_ratio": np.array([1.0, 1.1, 1.2, 1.3, np.nan]),
        "resulting_level": np.array([0, 1, 2, 3, 0]),
        "limited_by": np.array([0, 2, 1, 2, 3]),
        "limited_by_names": np.array(["", "factor", "slew", "nothing to move", "cap"]),
    }
    assert [
        (
            "executed / said by the tutor: median 1.15, 95 % 1.28, most 1.3 "
            "(4 decisions with a command that is not neutral)"
        ),
        "amplified: 3 of 5 decisions (60.0%); held back by: slew 2, nothing to move 1, factor 1",
    ] == list(describe_amplification(arrays))


def test_a_run_that_was_never_amplified_says_so() -> None:
    nothing = {"executed_ratio": np.full(2, np.nan), "resulting_level": np.zeros(2, int)}
    limits = {"limited_by": np.zeros(2, int), "limited_by_names": np.array([""])}
    assert ["amplified: 0 of 2 decisions (0.0%); held back by nothing"] == list(
        describe_amplification(nothing | limits)
    )


def test_run_prints_it(tmp_path: Path, registry: Registry) -> None:
    shown = run(PLANT, tmp_path)
    assert "executed / said by the tutor: median 1." in shown
    assert "held back by: " in shown
    assert "notice:" not in shown


def test_run_prints_what_keeps_the_learner_from_having_any_effect(tmp_path: Path, registry: Registry) -> None:
    shown = run(f"{PLANT}amplifier: never\n", tmp_path)
    assert "amplified: 0 of 300 decisions (0.0%)" in shown
    assert "notice: none of 300 decisions was amplified: student 'table' asked for no level above 0" in shown


@pytest.mark.parametrize("ranges", ["[[20, 100], [0, 1]]", "{celsius: [20, 100]}"])
def test_ranges_that_do_not_fit_end_a_run_with_a_sentence(ranges: str, tmp_path: Path, registry: Registry) -> None:
    (tmp_path / "p.yaml").write_text(PLANT.replace("[20, 100]", ranges))
    done = CliRunner().invoke(app, ["run", str(tmp_path / "p.yaml"), "--out", str(tmp_path / "run")])
    assert 0 != done.exit_code
    assert "encoder 'ranges': " in str(done.exception)
