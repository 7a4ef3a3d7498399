"""What parts measure: declared once, recorded every decision, summed up as they say."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

import tutorstudent as ts
from tests.core.toys import PIPELINE, Rail, toy_registry
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.rundir import run_pipeline
from tutorstudent.core.files.yamlfile import parse_yaml
from tutorstudent.core.running.meter import Totals
from tutorstudent.core.words.measures import as_measure


class Force(ts.Observer):
    """The force, where there is any."""

    name = "force-meter"
    measures = (
        ts.Measure("push", "pushed", unit="N", better="less"),
        ts.Measure("hardest", summed="max"),
        ts.Measure("usual", summed="mean"),
        ts.Measure("newest", summed="last"),
    )

    def observe(self, turn: Any, step: Any) -> Mapping[str, float] | None:
        force = turn.decision.executed.force
        return {"push": force, "hardest": force, "usual": force, "newest": force} if force > 0.3 else None


def pipeline(decisions: int = 50) -> Pipeline:
    return Pipeline(parse_yaml(PIPELINE, "p.yaml"), toy_registry()).replaced({"decisions": decisions})


def test_what_an_observer_measures_is_recorded_and_summed_up_as_it_says() -> None:
    finished = run_pipeline(pipeline(), [Force()])
    columns = finished.decisions
    assert ["push", "hardest", "usual", "newest"] == columns["measure_names"].tolist()
    force = columns["executed"][:, 0]
    np.testing.assert_array_equal(np.where(force > 0.3, force, np.nan), columns["measures"][:, 0])
    there = force[force > 0.3]
    assert 0 < len(there) < len(force)
    assert (there.sum(), there.max(), there.mean(), there[-1]) == pytest.approx(
        tuple(finished.summary[name] for name in ("push", "hardest", "usual", "newest"))
    )
    assert Force.measures == tuple(item for item in finished.measures if item in Force.measures)


def test_the_loop_returns_what_was_measured_and_counted() -> None:
    with pipeline().built() as (engine, world, _):
        summary = ts.run(engine, world, 50, seed=3, observers=[Force()])
    assert run_pipeline(pipeline(), [Force()]).summary["push"] == summary["push"] > 0


def test_a_name_that_is_taken_gets_a_number_in_every_record() -> None:
    class Same(Force):
        measures = (ts.Measure("push", "pushed"), ts.Measure("collided", "hits"), ts.Measure("decisions"))

        def observe(self, turn: Any, step: Any) -> Mapping[str, float]:
            return {"push": 1.0, "collided": 2.0, "decisions": 3.0}

    finished = run_pipeline(pipeline(10), [Force(), Same()])
    names = finished.decisions["measure_names"].tolist()
    assert ["push#2", "collided#2", "decisions#2"] == names[-3:]
    assert [10.0, 20.0, 30.0] == [finished.summary[name] for name in names[-3:]]
    assert {"pushed#2", "hits#2", "decisions#2"} <= {measure.title for measure in finished.measures}


def test_what_an_observer_says_of_its_own_measure_stands_for_the_sum() -> None:
    class Rounding(Force):
        def summary(self) -> Mapping[str, float]:
            return {"push": 7.0, "rest": 1.0}

    summary = run_pipeline(pipeline(), [Force(), Rounding()]).summary
    assert (7.0, 1.0) == (summary["push#2"], summary["rest"])
    assert 7.0 != summary["push"]


def test_a_second_run_begins_at_nothing() -> None:
    force, summaries = Force(), []
    for _ in range(2):
        with pipeline().built() as (engine, world, _observers):
            summaries.append(ts.run(engine, world, 50, seed=3, observers=[force]))
    assert summaries[0] == summaries[1]


@pytest.mark.parametrize(
    ("returned", "message"),
    [
        (
            {"pusch": 1.0},
            (
                r"observer 'force-meter': observe\(\) returned 'pusch', which is none of its measures \(did you mean "
                r"'push'\?\)\. Measures: hardest, newest, push, usual\. Declare it: measures = "
                r"\[ts\.Measure\('pusch'\)\]\."
            ),
        ),
        ({"push": "7"}, r"observe\(\) returned '7' for 'push'; return a number, or leave the name out where there is"),
        ({"push": float("nan")}, r"observe\(\) returned nan for 'push'; return a number"),
        ([1.0], r"observe\(\) returned \[1\.0\]; return \{name: number\} for its measures, or None\."),
    ],
)
def test_what_an_observer_did_not_declare_or_what_is_no_number_is_refused(returned: Any, message: str) -> None:
    class Careless(Force):
        def observe(self, turn: Any, step: Any) -> Any:
            return returned

    with pytest.raises(ts.ContractError, match=message):
        run_pipeline(pipeline(5), [Careless()])


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ({"name": ""}, r"a measure has the name ''; give a word, as in Measure\('energy_j'\)\."),
        ({"name": 3}, r"a measure has the name 3; give a word"),
        ({"better": "fewer"}, r"measure 'x': better is 'fewer'; it is one of 'more', 'less', None\."),
        ({"summed": "average"}, r"measure 'x': summed is 'average'; it is one of 'sum', 'max', 'mean', 'last'\."),
    ],
)
def test_a_measure_in_other_words_is_refused(words: dict[str, Any], message: str) -> None:
    with pytest.raises(ts.ContractError, match=message):
        ts.Measure(**({"name": "x"} | words))


def test_a_world_says_how_an_event_is_summed_or_all_about_it() -> None:
    assert ts.Measure("falls", summed="max") == as_measure("falls", "max")
    assert ts.Measure("falls", better="less") == as_measure("falls", ts.Measure("anything", "falls", better="less"))
    shared = as_measure("distance_m", "mean")
    assert ("distance, m", "mean", "way travelled") == (shared.heading, shared.summed, shared.description)
    assert list(Rail().event_names) == [measure.name for measure in Rail().measures]


def test_without_any_number_a_sum_is_nothing_and_all_else_is_unknown() -> None:
    totals = Totals([ts.Measure("falls"), ts.Measure("speed", summed="mean"), ts.Measure("age", summed="last")])
    assert {"falls": 0.0} == totals.summary()


def test_a_condition_that_was_never_violated_counts_nothing_and_several_are_measures() -> None:
    text = PIPELINE.replace("length_m: 5", "length_m: 4")  # its trials end before anything is violated
    one = run_pipeline(Pipeline(parse_yaml(text, "p.yaml"), toy_registry()))
    assert 0.0 == one.summary["violated:crashed"]
    assert "violated:crashed" not in [measure.name for measure in one.measures]
    both = text.replace("[crashed]", "[crashed, {use: any-of, of: [crashed]}]")
    two = run_pipeline(Pipeline(parse_yaml(both, "p.yaml"), toy_registry()))
    named = [measure.name for measure in two.measures if measure.name.startswith("violated:")]
    assert 2 == len(named)
    assert set(named) <= two.summary.keys()
