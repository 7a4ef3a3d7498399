"""What goes wrong while a pipeline is put together is told with its place; all that was made is closed."""

from __future__ import annotations

from enum import Enum
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest

from tests.core.toys import PIPELINE, Push, Pusher, Rail, toy_pipeline, toy_registry
from tutorstudent.core.files.pipeline import Pipeline, describe
from tutorstudent.core.roles import part as part_module
from tutorstudent.core.roles.leaves import Condition, Encoder
from tutorstudent.core.roles.part import Field
from tutorstudent.core.running.observers import Observer
from tutorstudent.core.words.errors import BrokenPlugin, ContractError, PipelineError, TutorStudentError


class Pull(Push):
    """Other actions."""


class Awkward(Encoder[Any, Any]):
    """Refuses its options once it knows its place."""

    name = "awkward"
    width = 1

    class Options(part_module.Options):
        error: str = Field("", description="what it raises")

    def setup(self) -> None:
        error: type[TutorStudentError] = {"contract": ContractError, "plugin": BrokenPlugin}[self.options.error]
        raise error("this encoder is awkward.")

    def encode(self, moment: Any) -> Any:
        raise NotImplementedError


class Demanding(Rail):
    """Its scene cannot be read."""

    name = "demanding"

    def setup(self) -> None:
        raise PipelineError("scene.yaml:9:1: no floor.")


class Elsewhere(Rail):
    """Executes other actions."""

    name = "elsewhere"
    action = Pull


class Blind(Condition[float]):
    """Cannot be set up."""

    name = "blind"

    def setup(self) -> None:
        raise PipelineError("no camera.")

    def violated(self, state: float) -> bool:
        return False


class Ledger(Observer):
    """Notes that it was closed; may fail at that, or at its beginning."""

    name = "ledger"
    closed: ClassVar[list[str]] = []

    class Options(part_module.Options):
        page: str = Field("one", description="what it notes")
        fails: bool = Field(default=False, description="whether it cannot be closed")
        lost: bool = Field(default=False, description="whether it cannot be set up")

    def setup(self) -> None:
        if self.options.lost:
            raise PipelineError("the ledger is lost.")

    def observe(self, turn: Any, step: Any) -> None:
        pass

    def close(self) -> None:
        self.closed.append(self.options.page)
        if self.options.fails:
            raise RuntimeError("stuck")


class Noted(Rail):
    """Notes in the ledger that it was closed."""

    name = "noted"

    def close(self) -> None:
        Ledger.closed.append("world")


class NotedPusher(Pusher):
    """Notes in the ledger that it was closed."""

    name = "noted-pusher"

    def close(self) -> None:
        Ledger.closed.append("tutor")


class Mood(Enum):
    CALM = "calm"


class Runner(part_module.Options):
    forward: float = Field(0.3, description="how fast it runs")


class Odd(part_module.Options):
    """Options of other types than YAML has."""

    where: Path = Field(Path("maps/hall.yaml"), description="a path")
    how: Mood = Field(Mood.CALM, description="an enumeration")
    sides: tuple[float, float] = Field((1.0, 2.0), description="a tuple")
    share: Any = Field(np.float32(0.5), description="a number of numpy's")
    prey: Runner = Field(Runner(), description="who is chased")
    herd: list[Runner] = Field([], description="who is chased beside it")
    packs: dict[str, list[Runner]] = Field({}, description="who runs together")
    table: Any = Field({1: np.arange(2)}, description="a table")


class Grey(Rail):
    """A rail with odd options."""

    name = "grey"
    Options = Odd


REGISTRY = toy_registry()
for awkward in (Awkward, Demanding, Blind, Ledger, Elsewhere, Grey, Noted, NotedPusher):
    REGISTRY.add(awkward)


def pipeline(text: str = PIPELINE) -> Pipeline:
    return toy_pipeline(text, REGISTRY)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"seed": -1}, "p.yaml (with seed=-1): seed: pipeline: option 'seed': input should be greater"),
        ({"world.length_m": -2}, "p.yaml (with world.length_m=-2): world.length_m: world 'rail': option 'length_m'"),
        ({"tutor": {"use": "pushr"}}, 'p.yaml (with tutor={"use": "pushr"}): tutor.use: no tutor named'),
        ({"world.use": "rial"}, "p.yaml (with world.use=rial): world.use: no world named 'rial'"),
        (
            {"selector": "modifier"},
            "p.yaml (with selector=modifier): selector: selector 'modifier' needs LevelProposal",
        ),
        ({"limits": list(range(30))}, "p.yaml (with limits=[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11...): limits: found"),
        ({"seed": 9, "conditions": ["crashd"]}, 'p.yaml (with conditions=["crashd"]): conditions.0: no condition'),
    ],
)
def test_a_mistake_in_a_replaced_value_names_it_instead_of_a_line(values: dict[str, Any], message: str) -> None:
    with pytest.raises(TutorStudentError) as caught, pipeline().replaced(values).built():
        pass
    assert str(caught.value).startswith(message)


@pytest.mark.parametrize(
    ("old", "new", "error", "message"),
    [
        (
            "{use: ranges, ranges: [[0, 5]]}",
            "{use: awkward, error: contract}",
            ContractError,
            "p.yaml:7:3: student.encoder: this encoder is awkward.",
        ),
        (
            "{use: ranges, ranges: [[0, 5]]}",
            "{use: awkward, error: plugin}",
            BrokenPlugin,
            "p.yaml:7:3: student.encoder: this encoder is awkward.",
        ),
        ("use: rail", "use: demanding", PipelineError, "p.yaml:3:1: world: scene.yaml:9:1: no floor."),
        ("[crashed]", "[crashed, blind]", PipelineError, "p.yaml:11:23: conditions.1: no camera."),
        (
            "seed: 3",
            "observers: [ledger, {use: ledger, lost: true}]",
            PipelineError,
            "p.yaml:1:21: observers.1: the ledger is lost.",
        ),
    ],
)
def test_a_part_that_cannot_be_set_up_is_told_with_its_place(old: str, new: str, error: type, message: str) -> None:
    found = pipeline(PIPELINE.replace(old, new))
    with pytest.raises(error) as caught, found.built():
        pass
    assert (error, message) == (type(caught.value), str(caught.value))


def test_a_world_of_other_actions_is_refused_with_its_place() -> None:
    found = pipeline(PIPELINE.replace("use: rail", "use: elsewhere"))
    with pytest.raises(ContractError, match="p.yaml:3:1: world: world 'elsewhere' executes Pull but"), found.built():
        pass


def test_everything_is_closed_whatever_one_of_them_does() -> None:
    text = PIPELINE + "observers: [ledger, {use: ledger, page: two, fails: true}, {use: ledger, page: three}]\n"
    text = text.replace("use: rail", "use: noted").replace("tutor: pusher", "tutor: noted-pusher")
    Ledger.closed.clear()
    with pytest.raises(RuntimeError, match="stuck"), pipeline(text).built():
        Ledger.closed.append("begin")
    assert ["begin", "three", "two", "one", "world", "tutor"] == Ledger.closed


@pytest.mark.parametrize(
    ("option", "message"),
    [
        ("prey: {forwrd: 1}", "p.yaml:3:27: world.prey.forwrd: world 'grey': unknown option 'prey.forwrd' (did you"),
        ("herd: [{}, {forwrd: 1}]", "option 'herd.1.forwrd' (did you mean 'forward'?). Options: forward."),
        ("packs: {a: [{forwrd: 1}]}", "world.packs.a.0.forwrd: world 'grey': unknown option 'packs.a.0.forwrd'."),
        ("prey: {forward: x}", "p.yaml:3:27: world.prey.forward: world 'grey': option 'prey.forward': input should"),
    ],
)
def test_an_unknown_option_within_an_option_is_told_with_what_is_allowed_there(option: str, message: str) -> None:
    found = pipeline(PIPELINE.replace("{use: rail, length_m: 5}", f"{{use: grey, {option}}}"))
    with pytest.raises(PipelineError) as caught, found.built():
        pass
    assert message in str(caught.value)


def test_a_description_holds_plain_values_only() -> None:
    found = pipeline(PIPELINE.replace("{use: rail, length_m: 5}", "grey"))
    with found.built() as built:
        values = describe(built.engine, built.world, found)["world"]
        expected = {"where": "maps/hall.yaml", "how": "calm", "sides": [1.0, 2.0], "share": 0.5, "table": {"1": [0, 1]}}
        assert expected == {key: values[key] for key in expected}
        assert [str, str, list, float, dict] == [type(values[key]) for key in expected]


def test_an_option_that_no_file_can_hold_is_refused_with_its_place() -> None:
    found = pipeline(PIPELINE.replace("{use: rail, length_m: 5}", "grey"))
    odd = found.replaced({"world.share": object()})
    message = (
        r"p.yaml:3:1 \(with world.share=.*\): world: cannot be written into a file: an option holds a object; options"
    )
    with odd.built() as built, pytest.raises(PipelineError, match=message):
        describe(built.engine, built.world, odd)
