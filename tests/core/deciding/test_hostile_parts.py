"""What parts, and the owner's own objects, must not be able to do."""

from __future__ import annotations

import gc
from typing import Any, ClassVar

import numpy as np
import pytest

import tutorstudent as ts
from tests.core.oracle.scripted import KindStudent, LevelStudent
from tests.core.toys import Push, Pusher, Rail
from tutorstudent.core.deciding.engine import Engine
from tutorstudent.core.deciding.guard import Breach
from tutorstudent.core.running.recorder import Recorder
from tutorstudent.core.running.runner import run
from tutorstudent.core.words.proposals import KindProposal, LevelProposal
from tutorstudent.core.words.snapshots import take_snapshot
from tutorstudent.plugins.amplifiers import Never
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.selectors import SameKind
from tutorstudent.plugins.streamlined.modifier import Modifier


class Pathless(Exception):
    __traceback__: Any = property(lambda self: 5)


def rebinds(*args: Any) -> bool:
    args = 5  # type: ignore[assignment]  # noqa: F841
    raise ValueError("a plain bug")


def loses_its_trace(state: Any) -> bool:
    raise Pathless


def names_its_kind(state: Any) -> bool:
    raise Breach([], "x")  # type: ignore[arg-type]


@pytest.mark.parametrize("condition", [rebinds, loses_its_trace, names_its_kind])
def test_whatever_is_raised_is_an_incident(condition: Any) -> None:
    loop = ts.wrap(lambda state: 0.5, action=ts.scalar(-1, 1), condition=condition)
    for number in range(3):
        loop.step(number)
    assert {("conditions.condition-1", "raised"): 2} == loop.engine.incident_counts


def engine(propose: Any, naming: bool = False, **how: Any) -> Engine[Any, Any, Any]:
    student: Any = (KindStudent if naming else LevelStudent)(propose=propose)
    selector: Any = SameKind() if naming else Modifier()
    return Engine(tutor=Pusher(), student=student, selector=selector, amplifier=Never(), evaluator=Conditions(), **how)


def rename(action: Any) -> None:
    action.__dict__["other"] = action.__dict__.pop("force")


def change_class(action: Any) -> None:
    object.__setattr__(action, "__class__", type("Other", (Push,), {}))


@pytest.mark.parametrize("spoil", [rename, change_class])
def test_an_action_that_was_spoilt_without_touching_its_values_is_seen(spoil: Any) -> None:
    def propose(moment: Any) -> LevelProposal:
        spoil(moment.tutor_action)
        return LevelProposal(level=2, ampbit=False)

    found = engine(propose)
    run(found, Rail(), 3, observers=[Recorder()])
    assert {("student", "mutated"): 3} == found.incident_counts


def test_what_is_amplified_cannot_be_changed() -> None:
    def propose(moment: Any) -> LevelProposal:
        moment.tutor_action.vocabulary.groups["push"] = ()
        return LevelProposal(level=2, ampbit=False)

    found = engine(propose)
    assert 0.2 == found.step(0.0).force
    assert {("student", "raised"): 1} == found.incident_counts


def test_a_proposal_that_was_never_validated_is_refused() -> None:
    bad = KindProposal.model_construct(kind="rest", level="high", ampbit=True)
    found = engine(lambda moment: bad, naming=True)
    run(found, Rail(), 3, observers=[Recorder()])
    assert {("student", "wrong-return"): 3} == found.incident_counts


def test_what_was_learned_is_taken_whole_or_not_at_all() -> None:
    found = engine(lambda moment: LevelProposal(level=2, ampbit=False))
    for wrong in ({"decisions": 7, "nobody": {}}, {"decisions": -7}):
        with pytest.raises(ts.ContractError, match="learned state"):
            found.load_state_dict(wrong)
        assert 0 == found.decisions


class Port:
    closed: ClassVar[list[str]] = []

    def __init__(self) -> None:
        self.name = "port"

    def __del__(self) -> None:
        self.closed.append(self.name)


def test_what_parts_are_shown_lets_go_of_nothing() -> None:
    port = Port()
    loop = ts.wrap(lambda state: 0.5, action=ts.scalar(-1, 1), condition=lambda state: state.name == "gone")
    for _ in range(4):
        loop.step(port)
    gc.collect()
    assert [] == Port.closed


def test_a_row_of_a_structured_array_is_copied() -> None:
    rows = np.zeros(2, dtype=[("a", float)])
    take_snapshot(rows[0])["a"] = 5
    assert 0 == rows["a"].sum()


def test_a_condition_that_was_made_already_is_taken_as_it_is() -> None:
    @ts.condition("too-hot")
    def too_hot(celsius: float) -> bool:
        return celsius > 80

    loop: Any = ts.wrap(lambda state: 0.5, action=ts.scalar(-1, 1), condition=too_hot)
    for celsius in (20, 90):
        loop.step(celsius)
    assert ("too-hot",) == loop.engine.last.outcome.violated
    assert not loop.engine.incidents
