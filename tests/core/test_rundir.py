"""A run leaves a directory that can be read later, without pickle."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from tests.core.toys import PIPELINE, toy_registry
from tutorstudent.core.errors import PipelineError
from tutorstudent.core.pipeline import Pipeline
from tutorstudent.core.recording import flat, load_arrays, nested, save_arrays
from tutorstudent.core.rundir import Finished, prepare, run_pipeline, write_run
from tutorstudent.core.yamlfile import parse_yaml

REGISTRY = toy_registry()


def finished(text: str = PIPELINE) -> Finished:
    return run_pipeline(Pipeline(parse_yaml(text, "p.yaml"), REGISTRY))


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
    save_arrays(tmp_path / "learned.npz", flat(engine.state_dict()))
    other = Pipeline(parse_yaml(PIPELINE, "p.yaml"), REGISTRY).engine()
    other.load_state_dict(nested(load_arrays(tmp_path / "learned.npz")))
    assert 50 == other.decisions
    ours, theirs = flat(engine.state_dict()), flat(other.state_dict())
    assert ours.keys() == theirs.keys()
    for path, array in ours.items():
        np.testing.assert_array_equal(array, theirs[path])


def test_arrays_of_objects_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="allow_pickle=False"):
        save_arrays(tmp_path / "x.npz", {"bad": np.array([object()])})


def test_a_directory_with_other_things_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "thesis.txt").write_text("mine")
    with pytest.raises(PipelineError, match="holds something that is no run; name another directory."):
        prepare(tmp_path)
    with pytest.raises(PipelineError, match="is a file; name a directory for the run."):
        prepare(tmp_path / "thesis.txt")


def test_an_earlier_run_is_written_over(tmp_path: Path) -> None:
    write_run(tmp_path / "run", finished())
    write_run(tmp_path / "run", finished(PIPELINE.replace("seed: 3", "seed: 4")))
    assert 4 == json.loads((tmp_path / "run" / "run.json").read_text())["seed"]
