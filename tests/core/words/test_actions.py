"""Action classes: what they declare, and what they refuse (Thesis 3.3.1)."""

from __future__ import annotations

import math
from typing import Any, ClassVar, Literal

import numpy as np
import pytest
from pydantic import ValidationError

from tests.core.oracle.shapes import SHAPES, Flight, Oven, Shape, Valve
from tutorstudent.core.words.actions import Action, AmplificationMap, component
from tutorstudent.core.words.errors import ContractError
from tutorstudent.sims.pioneer.types import DriveAction

NAN, INF = float("nan"), float("inf")


@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: shape.action.__name__)
def test_the_vocabulary_says_what_the_class_declares(shape: Shape) -> None:
    vocabulary = shape.action.vocabulary
    assert set(shape.kinds) == set(vocabulary.kinds)
    for name, (low, high) in shape.bounds.items():
        assert (low, high) == (vocabulary.components[name].low, vocabulary.components[name].high)
    for kind, arms in shape.arms.items():
        expected = [(arm.names, arm.direction, arm.scale, arm.neutral) for arm in arms]
        groups = vocabulary.groups[kind]
        assert expected == [(group.names, group.direction, group.scale, group.neutral) for group in groups]


def test_the_pioneer_amplifies_translation_or_rotation_and_never_the_duration() -> None:
    moved = {kind: [group.names for group in groups] for kind, groups in DriveAction.vocabulary.groups.items()}
    expected = {
        "stop": [],
        "forward": [("translation",)],
        "backward": [("translation",)],
        "left": [("rotation",)],
        "right": [("rotation",)],
    }
    assert expected == moved


def test_a_class_of_one_kind_need_not_name_it() -> None:
    assert Valve.vocabulary.kinds == ("command",)
    assert Valve(opening=0.1).kind == "command"


def test_the_scale_is_the_larger_bounds_distance_from_zero_unless_it_is_stated() -> None:
    class Scaled(Action):
        small: float = component(-0.5, 0.2)
        stated: float = component(-0.5, 0.2, scale=7.0, neutral=0.1, unit="m")

    small, stated = Scaled.vocabulary.components["small"], Scaled.vocabulary.components["stated"]
    assert (small.scale, small.neutral, small.unit) == (0.5, 0.0, "")
    assert (stated.scale, stated.neutral, stated.unit) == (7.0, 0.1, "m")


def test_an_unbounded_component_that_states_its_scale_may_be_amplified() -> None:
    class Free(Action):
        force_n: float = component(scale=12.0)
        amplification: ClassVar[AmplificationMap] = {"command": {"force_n": "outward"}}

    (group,) = Free.vocabulary.groups["command"]
    assert (group.scale, group.low, group.high) == (12.0, (-INF,), (INF,))


def test_a_subclass_may_amplify_something_else() -> None:
    class Careful(DriveAction):
        amplification: ClassVar[AmplificationMap] = {"forward": {"translation": "+"}}

    assert [kind for kind, groups in Careful.vocabulary.groups.items() if groups] == ["forward"]
    assert DriveAction.vocabulary.groups["left"]


def declared(**body: Any) -> str:
    """Return what is said when a class with this body is declared."""
    annotations = {"kind": Literal["go", "halt"], "speed": float, "turn": float, **body.pop("annotations", {})}
    fields = {"speed": component(-1.0, 1.0), "turn": component(), **body}
    with pytest.raises(ContractError) as caught:
        type("Odd", (Action,), {"__annotations__": annotations, "__module__": __name__, **fields})
    return str(caught.value)


NO_SCALE = "has no finite scale; give it bounds or component(..., scale=...)."
KNOWN = "its components are speed, turn."
MISTAKES = {
    "an unknown kind": (
        {"amplification": {"hallt": {"speed": "+"}}},
        "Odd: amplification names the kind 'hallt' (did you mean 'halt'?); its kinds are go, halt.",
    ),
    "an unknown component": (
        {"amplification": {"go": {"sped": "+"}}},
        f"Odd, kind 'go': amplification names the component 'sped' (did you mean 'speed'?); {KNOWN}",
    ),
    "an unknown component of a vector": (
        {"amplification": {"go": {("speed", "zzz"): "outward"}}},
        f"Odd, kind 'go': amplification names the component 'zzz'; {KNOWN}",
    ),
    "a component without a scale": (
        {"amplification": {"halt": {"turn": "+"}}},
        f"Odd, kind 'halt': the component 'turn' {NO_SCALE}",
    ),
    "a scale of zero": (
        {"speed": component(0.0, 0.0), "amplification": {"go": {"speed": "+"}}},
        f"Odd, kind 'go': the component 'speed' {NO_SCALE}",
    ),
    "a negative scale": (
        {"speed": component(-1.0, 1.0, scale=-2.0), "amplification": {"go": {"speed": "+"}}},
        f"Odd, kind 'go': the component 'speed' {NO_SCALE}",
    ),
    "an unknown direction": (
        {"amplification": {"go": {"speed": "up"}}},
        "Odd, kind 'go': direction 'up' of 'speed'; allowed are '+', '-' and 'outward'.",
    ),
    "a vector with a sign": (
        {"turn": component(-1.0, 1.0), "amplification": {"go": {("speed", "turn"): "+"}}},
        "Odd, kind 'go': a vector ('speed', 'turn') keeps its direction; use 'outward', not '+'.",
    ),
    "a kind that is no literal": (
        {"annotations": {"kind": int}},
        "Odd: 'kind' is annotated <class 'int'>; use Literal[...] of the kinds, or leave it out where there is one.",
    ),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_declaration_is_refused_that_has(mistake: str) -> None:
    body, expected = MISTAKES[mistake]
    assert f"action class {expected}" == declared(**body)


AMBIGUOUS: dict[str, dict[str, Any]] = {
    "amplifies what is no float": {
        "annotations": {"speed": int},
        "speed": component(0, 10),
        "amplification": {"go": {"speed": "+"}},
    },
    "moves one component in two groups": {
        "turn": component(-1.0, 1.0),
        "amplification": {"go": {"speed": "+", ("speed", "turn"): "outward"}},
    },
    "names one component twice in a vector": {"amplification": {"go": {("speed", "speed"): "outward"}}},
    "amplifies an empty vector": {"amplification": {"go": {(): "outward"}}},
    "has a neutral that is NaN": {
        "speed": component(0.0, 1.0, neutral=NAN),
        "amplification": {"go": {"speed": "outward"}},
    },
}


@pytest.mark.parametrize("reason", AMBIGUOUS)
def test_a_declaration_that_cannot_be_kept_is_refused_because_it(reason: str) -> None:
    assert "action class Odd" in declared(**AMBIGUOUS[reason])


@pytest.mark.parametrize(
    "bad",
    [
        {"kind": "sideways"},
        {"kind": None},
        {"translation": NAN},
        {"translation": INF},
        {"translation": 1.0000001},
        {"translation": -2},
        {"translation": "0.5"},
        {"translation": True},
        {"translation": None},
        {"translation": np.float32("nan")},
        {"translation": np.array([0.1, 0.2])},
        {"duration_s": -0.1},
        {"duration_s": INF},
        {"speed": 0.1},
    ],
    ids=repr,
)
def test_an_action_refuses(bad: dict[str, Any]) -> None:
    with pytest.raises(ValidationError, match=next(iter(bad))):
        DriveAction(**{"kind": "forward", **bad})


def test_an_action_needs_its_kind_where_there_are_several_and_its_components() -> None:
    with pytest.raises(ValidationError, match="kind"):
        DriveAction(translation=0.1)  # type: ignore[call-arg]
    with pytest.raises(ValidationError, match="fan"):
        Oven(kind="heat", power=20.0)  # type: ignore[call-arg]


@pytest.mark.parametrize("number", [0.5, np.float64(0.5), np.float32(0.5), 1, np.float64(-1.0)], ids=repr)
def test_an_action_takes_numbers_of_python_and_numpy(number: Any) -> None:
    action = DriveAction(kind="forward", translation=number)
    assert float(number) == action.translation
    assert isinstance(action.translation, float)


def test_an_action_is_frozen() -> None:
    action = DriveAction(kind="forward", translation=0.5)
    with pytest.raises(ValidationError, match="frozen"):
        action.translation = 0.9
    with pytest.raises(ValidationError, match="frozen"):
        action.kind = "stop"


def test_bounds_are_inside_and_defaults_do_nothing() -> None:
    at_edges = DriveAction(kind="left", rotation=1.0, translation=-1.0)
    assert (at_edges.rotation, at_edges.translation, at_edges.duration_s) == (1.0, -1.0, 0.0)
    assert tuple(DriveAction(kind="stop").model_dump().values())[1:] == (0.0, 0.0, 0.0)
    assert math.copysign(1, DriveAction(kind="stop", rotation=-0.0).rotation) == -1.0


def test_actions_are_equal_by_value_and_by_class() -> None:
    class Copied(DriveAction):
        pass

    assert DriveAction(kind="left", rotation=0.2) == DriveAction(kind="left", rotation=0.2)
    assert DriveAction(kind="left", rotation=0.2) != DriveAction(kind="left", rotation=0.3)
    assert DriveAction(kind="left") != Copied(kind="left")


def test_a_component_describes_itself_for_people() -> None:
    field = DriveAction.model_fields["duration_s"]
    assert field.description == "how long to hold the command"
    duration = DriveAction.vocabulary.components["duration_s"]
    assert (duration.unit, duration.high) == ("s", 3600.0)
    assert Flight.vocabulary.components["yaw_rps"].high == 3.0
