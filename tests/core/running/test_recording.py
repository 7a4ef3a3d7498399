"""What a run leaves behind as arrays can be read back, whatever it is called."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any, ClassVar, Literal

import numpy as np
import pytest

from tests.core.toys import PIPELINE, Push, Pusher, toy_pipeline, toy_registry
from tutorstudent.core.files.rundir import run_pipeline
from tutorstudent.core.running.arrays import flatten, load_arrays, nest, save_arrays
from tutorstudent.core.running.observers import Begin
from tutorstudent.core.running.recorder import Recorder
from tutorstudent.core.words import actions
from tutorstudent.core.words.actions import AmplificationMap
from tutorstudent.core.words.errors import ContractError, PipelineError


class Labelled(Push):
    """Not all components are numbers."""

    kind: Literal["push", "rest"]
    label: str = "gently"
    lamp: bool = True
    gear: int | None = None
    hint: float | None = None
    force: float = actions.component(-1.0, 1.0, default=0.0)
    amplification: ClassVar[AmplificationMap] = {"push": {"force": "outward"}, "rest": {}}


class Labeller(Pusher):
    """Says more than a force."""

    name = "labeller"
    action = Labelled

    def act(self, state: float) -> Labelled:
        return Labelled(kind="push", force=0.2)


def test_components_that_are_no_floats_are_left_out() -> None:
    registry = toy_registry()
    registry.add(Labeller)
    text = PIPELINE.replace("tutor: pusher", "tutor: labeller")
    columns = run_pipeline(toy_pipeline(text, registry)).decisions
    assert ["force"] == columns["component_names"].tolist()
    assert (50, 1) == columns["executed"].shape
    assert (columns["executed"] >= 0.2).all()


def test_more_decisions_than_memory_are_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: Any, **__: Any) -> Any:
        raise MemoryError

    pipeline = toy_pipeline()
    engine = pipeline.engine()
    begin = Begin(engine, pipeline.world(engine.tutor.action), 1_000_000_000)
    monkeypatch.setattr("tutorstudent.core.running.recorder.np", SimpleNamespace(zeros=refuse, int32=np.int32))
    message = "there is no memory to record 1,000,000,000 decisions; ask for fewer, as in decisions: 10000."
    with pytest.raises(PipelineError, match=message):
        Recorder().begin(begin)


KEYS = ["a", "a/b", "a%2Fb", "%", "file", "allow_pickle", "x", "x.npy", "", "ä ö", "..", "\x00", "a\\b", "ab\n"]


def test_learned_state_survives_under_any_keys(tmp_path: Path) -> None:
    state: dict[str, Any] = {key: float(i) for i, key in enumerate(KEYS)}
    state["a"] = {"b": {key: i for i, key in enumerate(KEYS)}, "/": "word"}
    save_arrays(tmp_path / "learned.npz", flatten(state))
    assert state == nest(load_arrays(tmp_path / "learned.npz"))


def test_no_two_paths_are_one() -> None:
    assert {"a%2Fb": 1, "a/b": 2} == {path: int(array) for path, array in flatten({"a/b": 1, "a": {"b": 2}}).items()}


def test_a_condition_label_may_hold_a_slash(tmp_path: Path) -> None:
    engine = toy_pipeline().engine()
    state = {**engine.state_dict(), "conditions.near/left": {"count": 3}}
    save_arrays(tmp_path / "learned.npz", flatten(state))
    assert {"count": 3} == nest(load_arrays(tmp_path / "learned.npz"))["conditions.near/left"]


def test_a_key_that_is_no_string_is_refused() -> None:
    with pytest.raises(ContractError, match="the key 1 of learned state is not a string; use strings."):
        flatten({"student": {1: 2.0, "1": 3.0}})


def test_arrays_can_be_read_without_this_package(tmp_path: Path) -> None:
    save_arrays(tmp_path / "x.npz", {"student/w": np.arange(3)})
    with np.load(tmp_path / "x.npz") as stored:
        assert [0, 1, 2] == stored["student/w"].tolist()


def test_the_same_arrays_are_the_same_bytes(tmp_path: Path) -> None:
    for name in ("one", "other"):
        save_arrays(tmp_path / name, {"w": np.arange(3.0)})
    assert (tmp_path / "one").read_bytes() == (tmp_path / "other").read_bytes()
