"""A student goes on with what it learned elsewhere, and with nothing else (Thesis 5.2.3)."""

from __future__ import annotations

import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.core.toys import PIPELINE, toy_pipeline
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.rundir import Finished, run_pipeline, write_run
from tutorstudent.core.roles.part import Learned
from tutorstudent.core.running.arrays import flatten, load_arrays, save_arrays
from tutorstudent.core.running.transplanting import transplant
from tutorstudent.core.words.errors import PipelineError
from tutorstudent.plugins.controls import Silent

NETWORK = PIPELINE.replace("use: table", "use: backprop\n  hidden: 5")


def pipeline(text: str = NETWORK) -> Pipeline:
    return toy_pipeline(text)


@pytest.fixture(scope="module")
def donor() -> Finished:
    """One that has learned."""
    return run_pipeline(pipeline())


@pytest.fixture
def learned(donor: Finished, tmp_path: Path) -> Path:
    """What it left behind."""
    write_run(tmp_path / "donor", donor)
    return tmp_path / "donor" / "learned.npz"


def refused(path: Path, text: str = NETWORK) -> str:
    with pytest.raises(PipelineError) as caught:
        pipeline(f"{text}learned: {path}\n").engine()
    return str(caught.value)


def test_the_student_begins_with_what_the_other_had_learned(learned: Path) -> None:
    engine = pipeline().replaced({"learned": str(learned), "seed": 99}).engine()
    stored = load_arrays(learned)
    for name, array in engine.student.state_dict().items():
        assert stored[f"student/{name}"].tolist() == array.tolist()


def test_the_learning_phase_starts_anew(learned: Path) -> None:
    assert 50 == load_arrays(learned)["decisions"]
    assert 0 == pipeline().replaced({"learned": str(learned)}).engine().decisions


def test_nothing_but_the_student_is_taken_over(learned: Path) -> None:
    begun = pipeline().replaced({"learned": str(learned)})
    expected = {path: array.tolist() for path, array in flatten(begun.engine().state_dict()).items()}
    more = {"tutor/secret": np.array(3), "evaluator": np.array(4), "decisions": np.array(5)}
    save_arrays(learned, load_arrays(learned) | more)
    assert expected == {path: array.tolist() for path, array in flatten(begun.engine().state_dict()).items()}


def test_it_decides_otherwise_than_one_that_begins_with_nothing(learned: Path) -> None:
    fresh, begun = run_pipeline(pipeline()), run_pipeline(pipeline().replaced({"learned": str(learned)}))
    assert fresh.decisions["selected_level"].tolist() != begun.decisions["selected_level"].tolist()


def test_the_resolved_pipeline_names_the_file_from_anywhere(learned: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(learned.parent)
    assert str(learned) == run_pipeline(pipeline().replaced({"learned": "learned.npz"})).resolved["learned"]
    assert None is run_pipeline(pipeline()).resolved["learned"]


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    message = refused(tmp_path / "no.npz")
    assert f"p.yaml:13:1: learned: {tmp_path / 'no.npz'}: there is no such file. Give the learned.npz that a" in message


def test_a_folder_is_no_file(tmp_path: Path) -> None:
    assert "cannot be read: Is a directory. Give the learned.npz" in refused(tmp_path)


@pytest.mark.parametrize("content", [b"", b"hello", b"PK\x03\x04broken", b"\x80\x04N."])
def test_a_file_of_something_else(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "odd").write_bytes(content)
    assert "odd: this is no file of learned arrays (" in refused(tmp_path / "odd")


def test_a_damaged_file(learned: Path) -> None:
    whole = learned.read_bytes()
    for end in (10, len(whole) // 2, len(whole) - 1):
        learned.write_bytes(whole[:end])
        assert "this is no file of learned arrays (" in refused(learned)


def test_pickled_objects_are_never_loaded(tmp_path: Path) -> None:
    np.savez(tmp_path / "objects.npz", **{"student/w": np.array([{}], dtype=object)})
    assert "objects.npz: this is no file of learned arrays (ValueError)" in refused(tmp_path / "objects.npz")


@pytest.mark.parametrize("arrays", [{}, {"decisions": 3}, {"student": 3}, {"student": 3, "student/w": 4}])
def test_a_file_in_which_no_student_learned_anything(tmp_path: Path, arrays: dict[str, int]) -> None:
    path = tmp_path / "learned.npz"
    save_arrays(path, {name: np.array(value) for name, value in arrays.items()})
    assert f"{path}: it holds nothing that a student learned. Give the learned.npz" in refused(path)


def test_an_archive_of_texts(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "texts.npz", "w") as archive:
        archive.writestr("student.npy", "text")
    assert "texts.npz: it holds nothing that a student learned." in refused(tmp_path / "texts.npz")


def test_what_another_student_learned(learned: Path) -> None:
    assert "student 'table' learned nothing named" in refused(learned, PIPELINE)


def test_a_student_of_another_size(learned: Path) -> None:
    message = refused(learned, NETWORK.replace("hidden: 5", "hidden: 6"))
    assert "student 'backprop' cannot load 'hidden_weights': found the shape (5, " in message
    assert "load it into a part with the options that it was saved with" in message


def test_a_third_partys_student_that_raises_whatever_it_likes(learned: Path) -> None:
    class Fussy(Silent[Any, Any]):
        name = "fussy"

        def load_state_dict(self, state: Learned) -> None:
            raise ZeroDivisionError("no\nluck.")

    with pytest.raises(PipelineError, match=r"student 'fussy' cannot take it: ZeroDivisionError: no luck\. Give the"):
        transplant(learned, Fussy())


def test_a_value_that_is_no_path() -> None:
    with pytest.raises(PipelineError, match=r"p.yaml:13:1: learned: pipeline: option 'learned': .*found 7"):
        pipeline(NETWORK + "learned: 7\n")
