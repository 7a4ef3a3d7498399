"""Decisions are byte for byte what they were when they were recorded."""

from __future__ import annotations

import json

import numpy as np
import pytest

from tests.recordings.__main__ import DATA
from tests.recordings.cases import loops, pipelines
from tests.recordings.streams import BLOCK, arithmetic, differences, digests
from tutorstudent.core.files.rundir import run_pipeline

RECORDED = json.loads(DATA.read_text(encoding="utf-8"))
PIPELINES = dict(pipelines())
LOOPS = loops()
same_arithmetic = pytest.mark.skipif(
    arithmetic() != RECORDED["arithmetic"], reason="this machine's numpy differs in the last bits from the recording's"
)


def test_every_case_is_recorded() -> None:
    assert set(RECORDED["streams"]) == {*PIPELINES, *LOOPS}


@same_arithmetic
@pytest.mark.parametrize("name", PIPELINES)
def test_a_shipped_pipeline_decides_as_it_did(name: str) -> None:
    assert [] == differences(RECORDED["streams"][name], digests(run_pipeline(PIPELINES[name]).decisions))


@same_arithmetic
@pytest.mark.parametrize("name", LOOPS)
def test_a_wrapped_controller_commands_as_it_did(name: str) -> None:
    assert [] == differences(RECORDED["streams"][name], digests({"commands": np.array(LOOPS[name]())}))


def test_a_difference_is_named_by_column_and_decision() -> None:
    column = np.arange(3 * BLOCK)
    changed = column.copy()
    changed[BLOCK + 3] += 1
    assert [f"level differs from decision {BLOCK} on"] == differences(
        digests({"level": column}), digests({"level": changed})
    )


def test_a_column_that_is_gone_is_named() -> None:
    assert ["level is no longer recorded"] == differences(digests({"level": np.zeros(3)}), {})
