"""What a pipeline leaves out: with actions of one kind, what `ts.wrap` takes; with several, the thesis's values."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tutorstudent as ts
from tests.core.toys import PIPELINE, toy_pipeline
from tutorstudent.command.plugin_info import format_wrapped, make_wrapped
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.plugins.amplifiers import Never

UNIT = ts.scalar(-1, 1)


def control(y: float) -> float:
    return float(np.clip((70 - y) / 30, -1, 1))


def make_engine(text: str, **given: Any) -> ts.Engine[Any, Any, Any]:
    return ts.Pipeline(parse_yaml(text, "p.yaml")).engine(tutor=ts.FunctionTutor(control, UNIT), **given)


def drive(loop: ts.Loop) -> list[float]:
    return [loop.step(y) for y in np.random.default_rng(3).normal(75, 8, 400).tolist()]


def hot(y: float) -> bool:
    return y > 80


@pytest.mark.parametrize("text", [format_wrapped(), "seed: 0"], ids=["info wrap", "nothing"])
def test_the_pipeline_that_info_prints_and_one_that_says_nothing_are_what_wrap_makes(text: str, tmp_path: Path) -> None:
    (tmp_path / "p.yaml").write_text(text)
    conditions = [ts.condition("condition-1")(hot)()]
    engine = ts.load(tmp_path / "p.yaml", tutor=control, action=UNIT, conditions=conditions)
    wrapped = ts.wrap(control, action=UNIT, condition=hot)
    found = drive(ts.Loop(engine))
    assert found == drive(wrapped)
    assert found != [control(y) for y in np.random.default_rng(3).normal(75, 8, 400).tolist()]
    for slot, part in wrapped.engine.slots():
        assert part.describe() == dict(engine.slots())[slot].describe()
    assert engine.limits.model_dump() == wrapped.engine.limits.model_dump() == {"cap": 0.8, "factor": 1.3, "slew": 1}


def test_each_value_is_left_out_by_itself() -> None:
    engine = make_engine("{amplifier: {use: learning-phase, amount: 0.2}, limits: {cap: 0.5, slew: null}}")
    assert {"cap": 0.5, "factor": 1.3, "slew": None} == engine.limits.model_dump()
    assert "multiplicative" == engine.amplifier.change.name
    assert (0.2, 2500) == (engine.amplifier.options.amount, engine.amplifier.options.decisions)


@pytest.mark.parametrize("amplifier", ["never", "{use: never}", "{use: never, amount: 0.2}"])
def test_an_amplifier_without_a_change_gets_the_one_in_proportion(amplifier: str) -> None:
    assert "multiplicative" == make_engine(f"amplifier: {amplifier}").amplifier.change.name
    assert "additive" == make_engine("amplifier: {use: never, change: additive}").amplifier.change.name


def test_a_part_that_is_given_in_python_keeps_its_options() -> None:
    assert "additive" == make_engine("seed: 1", amplifier=Never()).amplifier.change.name


@pytest.mark.parametrize(("codec", "selector"), [("level-ampbit", "modifier"), ("kind-level-ampbit", "same-kind")])
def test_the_selector_is_the_one_that_reads_the_students_proposals(codec: str, selector: str) -> None:
    student = f"student: {{use: table, encoder: ranges, codec: {codec}}}"
    assert selector == make_engine(student).selector.name
    assert (
        selector
        == ts.wrap(
            control, action=UNIT, student={"use": "table", "encoder": "ranges", "codec": codec}
        ).engine.selector.name
    )


def test_with_several_kinds_they_are_the_thesiss() -> None:
    engine = toy_pipeline(
        PIPELINE.replace("selector: same-kind\n", "").replace("decisions: 10}", "decisions: 9}")
    ).engine()
    assert {"cap": 0.8, "factor": None, "slew": None} == engine.limits.model_dump()
    assert ("same-kind", "additive") == (engine.selector.name, engine.amplifier.change.name)
    with pytest.raises(ts.PipelineError, match="there is no 'student'"):
        toy_pipeline("tutor: pusher").engine()


def test_the_page_about_pipelines_shows_the_same() -> None:
    page = (Path(__file__).parents[3] / "docs/guide/pipelines.md").read_text(encoding="utf-8")
    shown = page.split("# wrap.yaml\n")[1].split("```")[0]
    values = parse_yaml(shown, "page").data
    assert values == {key: value for key, value in make_wrapped().items() if key in values}
