"""A run leaves a directory that can be read later, without pickle."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from enum import Enum
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.core.toys import PIPELINE, Pusher, Rail, toy_pipeline, toy_registry
from tutorstudent.core.files.finished import Finished
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.rundir import prepare, run_pipeline, write_run
from tutorstudent.core.roles import part as part_module
from tutorstudent.core.roles.part import Field
from tutorstudent.core.roles.world import Step
from tutorstudent.core.running.arrays import flatten, load_arrays, nest, save_arrays
from tutorstudent.core.running.observers import Observer
from tutorstudent.core.words.errors import PipelineError


class Paint(Enum):
    RED = "red"


class Workshop(Rail):
    """A rail with options and events of other types."""

    name = "workshop"

    class Options(Rail.Options):  # type: ignore[name-defined, misc]
        plan: Path = Field(Path("plans/a.txt"), description="a path")
        paint: Paint = Field(Paint.RED, description="an enumeration")
        size: Any = Field(1.0, description="anything")

    def step(self, action: Any) -> Step[float]:
        step = super().step(action)
        events: dict[str, Any] = {"distance_m": np.float32(0.5), "speed": np.int64(3), "x_m": np.float64(1.0)}
        return step._replace(events=dict(step.events) | events)


class Counter(Observer):
    """Counts in all sorts of numbers."""

    name = "counter"

    def observe(self, turn: Any, step: Any) -> None:
        pass

    def summary(self) -> Mapping[str, Any]:
        return {
            "half": np.float32(0.5),
            "three": np.int64(3),
            "nothing": math.nan,
            "endless": np.inf,
            "word": "7",
            "huge": 10**400,
        }


class Forgetful(Pusher):
    """Cannot say what it learned."""

    name = "forgetful"

    class Options(part_module.Options):
        how: str = Field("raise", description="what is wrong with what it learned")

    def state_dict(self) -> Mapping[str, Any]:
        if self.options.how == "raise":
            raise RuntimeError("it slipped\nmy mind.")
        return {"fact": {"object": object(), "ragged": [[1], [1, 2]], "number": 3}[self.options.how]}


REGISTRY = toy_registry()
for toy in (Workshop, Counter, Forgetful):
    REGISTRY.add(toy, "toys", "toy-box 1.2")


def finished(text: str = PIPELINE) -> Finished:
    return run_pipeline(toy_pipeline(text, REGISTRY))


def test_a_run_can_be_read_and_repeated(tmp_path: Path) -> None:
    first = finished()
    write_run(tmp_path / "run", first)
    again = run_pipeline(Pipeline.read(tmp_path / "run" / "pipeline.yaml", REGISTRY))
    stored = load_arrays(tmp_path / "run" / "decisions.npz")
    assert first.decisions.keys() == stored.keys()
    for name, array in again.decisions.items():
        np.testing.assert_array_equal(array, stored[name])
    record = json.loads((tmp_path / "run" / "run.json").read_text())
    assert 3 == record["seed"]
    assert again.summary == record["summary"]
    assert {} == record["incident_counts"]
    assert record["versions"]["tutorstudent"]


def test_the_columns_say_what_was_decided() -> None:
    columns = finished().decisions
    assert ["push", "rest"] == columns["kind_names"].tolist()
    assert ["force"] == columns["component_names"].tolist()
    assert ["crashed"] == columns["condition_names"].tolist()
    level = columns["resulting_level"]
    np.testing.assert_allclose(columns["executed"][:, 0], np.minimum(0.2 + 0.1 * level, 1.0))
    violated = columns["violated"][:, 0]
    assert violated.any()
    np.testing.assert_array_equal(columns["taught_ampbit"] == 1, ~violated)
    np.testing.assert_array_equal(columns["trial_ended"] == 1, violated)
    np.testing.assert_array_equal(columns["taught_level"][~violated], level[~violated])
    assert np.all(level >= columns["selected_level"])


def test_what_was_learned_survives_the_file(tmp_path: Path) -> None:
    engine = finished().engine
    save_arrays(tmp_path / "learned.npz", flatten(engine.state_dict()))
    other = toy_pipeline(registry=REGISTRY).engine()
    other.load_state_dict(nest(load_arrays(tmp_path / "learned.npz")))
    assert 50 == other.decisions
    ours, theirs = flatten(engine.state_dict()), flatten(other.state_dict())
    assert ours.keys() == theirs.keys()
    for path, array in ours.items():
        np.testing.assert_array_equal(array, theirs[path])


def test_arrays_of_objects_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="allow_pickle=False"):
        save_arrays(tmp_path / "x.npz", {"bad": np.array([object()])})


def test_a_directory_with_other_things_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "thesis.txt").write_text("mine")
    with pytest.raises(PipelineError, match="holds something other than a run; name another directory."):
        prepare(tmp_path)
    with pytest.raises(PipelineError, match="is a file; name a directory for the run."):
        prepare(tmp_path / "thesis.txt")


def test_an_earlier_run_is_written_over(tmp_path: Path) -> None:
    write_run(tmp_path / "run", finished())
    write_run(tmp_path / "run", finished(PIPELINE.replace("seed: 3", "seed: 4")))
    assert 4 == json.loads((tmp_path / "run" / "run.json").read_text())["seed"]


def test_a_directory_that_cannot_be_made_is_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    for directory in (tmp_path / "file" / "run", tmp_path / ("x" * 300)):
        with pytest.raises(
            PipelineError, match=r"(file/run|x+): cannot be written: .*\. Name a directory that you may"
        ):
            prepare(directory)


def test_a_file_that_cannot_be_written_is_a_sentence(tmp_path: Path) -> None:
    write_run(tmp_path, finished())
    (tmp_path / "decisions.npz").unlink()
    (tmp_path / "decisions.npz").mkdir()
    with pytest.raises(PipelineError, match=f"{tmp_path}: cannot be written: Is a directory"):
        write_run(tmp_path, finished())


WORKSHOP = PIPELINE.replace("use: rail", "use: workshop")


def test_options_and_events_of_other_types_do_not_cost_the_run(tmp_path: Path) -> None:
    assert "" == write_run(tmp_path / "run", finished(WORKSHOP + "observers: [counter]\n"))
    again = Pipeline.read(tmp_path / "run" / "pipeline.yaml", REGISTRY).document.data["world"]
    assert ("plans/a.txt", "red") == (again["plan"], again["paint"])
    summary = json.loads((tmp_path / "run" / "run.json").read_text())["summary"]
    assert (25.0, 3.0, 0.5, 3.0) == tuple(summary[key] for key in ("distance_m", "speed", "half", "three"))


def test_what_is_no_finite_number_is_null_in_the_record_and_never_left_out(tmp_path: Path) -> None:
    write_run(tmp_path / "run", finished(PIPELINE + "observers: [counter]\n"))
    summary = json.loads((tmp_path / "run" / "run.json").read_text())["summary"]
    assert [None] * 4 == [summary[key] for key in ("nothing", "endless", "word", "huge")]


def test_an_option_that_no_file_can_hold_is_refused_before_the_run() -> None:
    class Eager(Observer):
        name = "eager"
        began = False

        def begin(self, begin: Any) -> None:
            self.began = True

        def observe(self, turn: Any, step: Any) -> None:
            pass

    eager = Eager()
    odd = toy_pipeline(WORKSHOP, REGISTRY).replaced({"world.size": object()})
    with pytest.raises(PipelineError, match="world: cannot be written into a file: an option holds a object"):
        run_pipeline(odd, [eager])
    assert not eager.began


@pytest.mark.parametrize(
    ("how", "why"),
    [
        ("raise", "RuntimeError: it slipped my mind."),
        ("object", "ValueError: Object arrays cannot be saved when allow_pickle=False."),
        ("ragged", "ValueError: setting an array element with a sequence."),
    ],
)
def test_what_was_learned_but_cannot_be_saved_does_not_cost_the_rest(tmp_path: Path, how: str, why: str) -> None:
    text = PIPELINE.replace("tutor: pusher", "tutor: {use: forgetful, how: HOW}")
    assert "" == write_run(tmp_path, finished(text.replace("HOW", "number")))
    assert (tmp_path / "learned.npz").exists()
    note = write_run(tmp_path, finished(text.replace("HOW", how)))
    assert note.startswith(f"{tmp_path / 'learned.npz'}: what was learned could not be saved: {why[:-1]}")
    assert note.endswith(". The other files of the run are written.")
    assert {"pipeline.yaml", "run.json", "decisions.npz"} == {path.name for path in tmp_path.iterdir()}


def test_the_record_says_where_every_part_comes_from(tmp_path: Path) -> None:
    write_run(tmp_path, finished(WORKSHOP + "observers: [counter]\n"))
    record = json.loads((tmp_path / "run.json").read_text())
    ours = f"tutorstudent {record['versions']['tutorstudent']}"
    parts = ["student table", "encoder ranges", "codec kind-level-ampbit", "selector same-kind", "evaluator conditions"]
    expected = dict.fromkeys([*parts, "amplifier learning-phase", "change additive"], ours)
    expected |= {"world workshop": "toy-box 1.2", "observer counter": "toy-box 1.2"}
    expected |= {"tutor pusher": "this program", "condition crashed": "this program"}
    assert expected == record["plugins"]


def test_every_observer_is_closed_after_it_was_asked_for_its_summary() -> None:
    class Careful(Observer):
        name = "careful"
        said: list[str] = []

        def observe(self, turn: Any, step: Any) -> None:
            pass

        def summary(self) -> Mapping[str, float]:
            self.said.append("summary")
            return {}

        def close(self) -> None:
            self.said.append("close")

    run_pipeline(toy_pipeline(registry=REGISTRY), [Careful()])
    assert ["summary", "close"] == Careful.said


def test_observers_that_use_one_name_keep_all_their_counts() -> None:
    pipeline = toy_pipeline(PIPELINE + "observers: [counter, counter, counter]\n", REGISTRY)
    summary = run_pipeline(pipeline).summary
    assert (0.5, 0.5, 0.5) == tuple(summary[key] for key in ("half", "half#2", "half#3"))
    assert "half#4" not in summary


def test_a_learner_that_did_nothing_is_in_the_record(tmp_path: Path) -> None:
    idle = finished(PIPELINE.replace("{use: learning-phase, decisions: 10}", "never"))
    write_run(tmp_path / "run", idle)
    (notice,) = json.loads((tmp_path / "run" / "run.json").read_text())["notices"]
    assert "nobody asked" == notice["kind"]
    assert "student 'table' asked for no level above 0, and amplifier 'never' raised none." in notice["says"]
    assert () == finished().notices
