"""The commonest mistakes of a plugin's author are a sentence."""

from __future__ import annotations

import math
import os
import zipfile
from importlib import metadata
from pathlib import Path
from typing import Any, ClassVar

import pytest

import tutorstudent as ts
from tests.core.toys import PIPELINE, Push, Pusher, Rail, toy_pipeline, toy_registry
from tutorstudent.core.files.finished import Finished
from tutorstudent.core.files.loading import diagnose, load_parts
from tutorstudent.core.files.pipeline import Pipeline
from tutorstudent.core.files.registry import Registry
from tutorstudent.core.files.rundir import try_pipeline


class Wrong(Pusher):
    """Returns what it is told to at decision 3."""

    name = "wrong"
    deed: ClassVar[Any] = None

    def setup(self) -> None:
        self._number = 0

    def act(self, state: float) -> Any:
        self._number += 1
        return type(self).deed() if self._number == 4 else Push(kind="push", force=0.2)


def finished(deed: Any) -> Finished:
    Wrong.deed = staticmethod(deed)
    registry = toy_registry()
    registry.add(Wrong)
    return try_pipeline(toy_pipeline(PIPELINE.replace("tutor: pusher", "tutor: wrong"), registry))


@pytest.mark.parametrize(
    ("deed", "said"),
    [
        (lambda: Push(kind="push", force=1.5), "'force' is 1.5; input should be less than or equal to 1."),
        (lambda: Push(kind="push", force=math.nan), "'force' is nan; input should be a finite number."),
    ],
)
def test_an_action_out_of_bounds_says_who_when_what_and_the_remedy(deed: Any, said: str) -> None:
    failure = finished(deed).failure
    assert failure is not None
    assert failure.problem == (
        f"decision 3: tutor 'wrong' made no Push: {said} Clip it, or widen the bounds of the action class."
    )


def test_an_action_without_names_is_told_how_it_is_written() -> None:
    force: Any = ts.scalar(-1, 1)
    failure = finished(lambda: force(0.5)).failure
    assert failure is not None
    assert "decision 3: tutor 'wrong' made an action without the names of its components; write" in failure.problem


def refused(*classes: type[ts.Component], text: str = PIPELINE) -> str:
    registry = toy_registry()
    for cls in classes:
        registry.add(cls)
    with pytest.raises(ts.TutorStudentError) as caught, toy_pipeline(text, registry).built():
        pass
    return str(caught.value)


def test_an_own_init_without_super_is_told() -> None:
    class Forgetful(Pusher):
        name = "forgetful"

        def __init__(self, **_: Any) -> None:
            self.gain = 1.0

    said = refused(Forgetful, text=PIPELINE.replace("tutor: pusher", "tutor: forgetful"))
    assert "tutor 'forgetful': its own __init__ does not call super().__init__(**options); call that first" in said


def test_a_setup_that_raises_is_told_with_its_place() -> None:
    class Broken(Pusher):
        name = "broken"

        def setup(self) -> None:
            raise FileNotFoundError("no map")

    said = refused(Broken, text=PIPELINE.replace("tutor: pusher", "tutor: broken"))
    assert said == "p.yaml:4:1: tutor: tutor 'broken': setup() raised FileNotFoundError: no map."


def test_a_tutor_and_a_world_without_action_are_told() -> None:
    class Mute(ts.Tutor[float, Any]):
        name = "mute"

        def act(self, state: float) -> Any:
            return None

    class Void(ts.World[float, Any]):
        name = "void"

        def reset(self, seed: int) -> float:
            return 0.0

        def step(self, action: Any) -> Any:
            return None

    said = refused(Mute, text=PIPELINE.replace("tutor: pusher", "tutor: mute"))
    assert "tutor 'mute': it has no 'action'; name the class of actions that it returns, as in action =" in said
    said = refused(Void, text=PIPELINE.replace("world: {use: rail, length_m: 5}", "world: void"))
    assert "world 'void': it has no 'action'; name the class of actions that it executes, as in action =" in said


def test_a_reset_without_a_seed_is_told() -> None:
    class Seedless(Rail):
        name = "seedless"

        def reset(self) -> float:  # type: ignore[override]
            return 0.0

    said = refused(Seedless, text=PIPELINE.replace("use: rail", "use: seedless"))
    assert "world 'seedless': reset() cannot be called with one argument; write def reset(self, seed)." in said


def test_two_classes_of_one_form_are_told() -> None:
    class Twin(Pusher):
        name = "twin"
        action = ts.scalar(-1, 1)  # type: ignore[assignment]

    class Other(Rail):
        name = "other"
        action = ts.scalar(-1, 1)

    text = PIPELINE.replace("tutor: pusher", "tutor: twin").replace("use: rail", "use: other")
    said = refused(Twin, Other, text=text)
    assert "world 'other' and tutor 'twin' have two action classes of the same form, both called Scalar." in said
    assert said.endswith("make it once, and use that one in both.")


def test_a_name_in_other_letters_is_suggested() -> None:
    assert "no tutor named 'Pusher' (did you mean 'pusher'?)" in refused(
        text=PIPELINE.replace("tutor: pusher", "tutor: Pusher")
    )


def test_an_entry_point_that_names_a_class_is_told() -> None:
    point = metadata.EntryPoint("acme", "tests.core.toys:Pusher", "tutorstudent")
    with pytest.raises(ts.BrokenPlugin) as caught:
        list(load_parts(point))
    reason, _ = diagnose(caught.value, "acme 1")
    assert reason.startswith("'tests.core.toys:Pusher' names the class Pusher; an entry point names the module with")


def read(path: Path) -> str:
    with pytest.raises(ts.PipelineError) as caught:
        Pipeline.read(path, Registry())
    return str(caught.value)


def test_a_huge_file_is_refused_before_it_is_read(tmp_path: Path) -> None:
    with (tmp_path / "huge.yaml").open("wb") as stream:
        stream.truncate(10_000_000_000)
    (tmp_path / "p.yaml").write_text("extends: huge.yaml\n")
    assert read(tmp_path / "p.yaml").endswith("huge.yaml: it has 10,000,000,000 bytes; 500,000 characters are allowed.")


def test_a_pipe_is_refused_at_once(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "p.yaml")
    said = "this is no file but a pipe or a device."
    assert said in read(tmp_path / "p.yaml")
    assert said in read(Path("/dev/zero"))
    for path in (tmp_path / "p.yaml", Path("/dev/zero")):
        assert said in refused(text=f"{PIPELINE}learned: {path}\n")


def test_a_long_chain_is_refused(tmp_path: Path) -> None:
    for number in range(60):
        (tmp_path / f"{number}.yaml").write_text(f"extends: {number + 1}.yaml\n")
    assert read(tmp_path / "0.yaml").endswith("this is file 51 of a chain; 50 files may extend each other.")


def test_a_number_of_half_a_million_digits_is_refused(tmp_path: Path) -> None:
    (tmp_path / "p.yaml").write_text(f"seed: {'9' * 400_000}\n")
    assert "seed: '9999999999999999999999999999999999999..." in read(tmp_path / "p.yaml")
    assert "with 400,000 digits; 1000 are allowed." in read(tmp_path / "p.yaml")


def test_what_unpacks_to_more_than_memory_is_refused_before(tmp_path: Path) -> None:
    path = tmp_path / "learned.npz"
    with zipfile.ZipFile(path, "w") as archive, archive.open("student/w.npy", "w") as member:
        member.write(b"0")
    content = bytearray((tmp_path / "learned.npz").read_bytes())
    at = content.rindex(b"PK\x01\x02") + 24
    content[at : at + 4] = (3_000_000_000).to_bytes(4, "little")
    (tmp_path / "learned.npz").write_bytes(content)
    said = refused(text=f"{PIPELINE}learned: {tmp_path / 'learned.npz'}\n")
    assert "it unpacks to 3,000,000,000 bytes; 1,000,000,000 are allowed." in said


@pytest.mark.parametrize("text", ["seed: 3\n  decisions: 5\n", "student:\n  use: table\n    hidden: 3\n"])
def test_a_line_that_is_indented_too_far_is_told(tmp_path: Path, text: str) -> None:
    (tmp_path / "p.yaml").write_text(text)
    assert "a ':' is not expected here; is this line indented further than the line above?" in read(tmp_path / "p.yaml")
