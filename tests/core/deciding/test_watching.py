"""A learner that does nothing says so: what is wrong, and what to do, once for each kind of fault."""

from __future__ import annotations

import logging
import re
import warnings
from collections.abc import Callable
from typing import Any

import pytest

import tutorstudent as ts
from tests.core.oracle.scripted import LevelStudent
from tests.core.toys import Pusher, Rail
from tutorstudent.core.deciding.function_tutor import as_tutor
from tutorstudent.core.deciding.watching import ENOUGH, Notice, Watch, find_assembly_notices
from tutorstudent.core.running.noticing import Noticer
from tutorstudent.plugins.amplifiers import LearningPhase, Never
from tutorstudent.plugins.changes import Additive, Multiplicative
from tutorstudent.plugins.controls import Constant, Silent
from tutorstudent.plugins.evaluators import Conditions
from tutorstudent.plugins.selectors import SameKind
from tutorstudent.plugins.streamlined.modifier import Modifier

UNIT = ts.scalar(-1, 1)


def fail(moment: Any) -> Any:
    raise RuntimeError("no weights.")


def propose(level: int) -> Callable[[Any], ts.LevelProposal]:
    return lambda moment: ts.LevelProposal(level=level, ampbit=True)


def make_engine(said: float = 0.2, action: type[ts.Action] = UNIT, **slots: Any) -> ts.Engine[Any, Any, Any]:
    """Return an engine whose controller always says the same; its student asks for level 1."""
    parts: dict[str, Any] = {
        "student": LevelStudent(propose=propose(1)),
        "selector": Modifier(),
        "amplifier": Never(change=Multiplicative()),
        "evaluator": Conditions(),
        "limits": ts.Limits(factor=1.3, slew=1),
    }
    return ts.Engine(tutor=as_tutor(lambda _: said, action), **parts | slots)


def drive(engine: ts.Engine[Any, Any, Any], decisions: int = 20) -> list[Notice]:
    """Return what is noticed in that many decisions."""
    watch = Watch(engine)
    for _ in range(decisions + 1):
        engine.step(0.0)
        if engine.last is not None:
            watch.observe(engine.last)
    return watch.find_notices()


def test_nothing_is_said_where_all_is_well() -> None:
    assert [] == drive(make_engine())
    assert [] == Watch(make_engine()).find_notices()


STILL = "the controller's commands were at neutral or at their bounds, .* declare another neutral or wider bounds"
FAULTS: list[tuple[str, dict[str, Any], str]] = [
    (
        "student fails",
        {"student": LevelStudent(propose=fail)},
        r"student failed in 20 of 20 decisions; the controller's own",
    ),
    (
        "student fails",
        {"student": LevelStudent(propose=fail)},
        r".* The newest: raised: RuntimeError: no weights. Mend it,",
    ),
    (
        "conditions.hot fails",
        {"conditions": [ts.condition("hot")(fail)()]},
        ".* it counted as violated in each. The newest",
    ),
    (
        "hot violated",
        {"conditions": [ts.condition("hot")(lambda _: True)()]},
        "condition 'hot' was violated after every one of 20 decisions, .* True means violated; turn it round",
    ),
    (
        "level 1",
        {"amplifier": LearningPhase(change=Additive())},
        ".* with the change 'additive' and amount 0.1 even level 1 exceeds limits.factor 1.3 of such .* multiplicative",
    ),
    (
        "level 1",
        {"amplifier": LearningPhase(amount=0.9, change=Additive()), "limits": ts.Limits(factor=None)},
        "nothing can ever be amplified: .* amount 0.9 even level 1 exceeds limits.cap 0.8. Raise the cap, or lower",
    ),
    (
        "level 1",
        {"amplifier": LearningPhase(amount=0.5, change=Multiplicative())},
        "nothing can ever be amplified: .* 'multiplicative' and amount 0.5 even level 1 exceeds limits.factor 1.3",
    ),
    (
        "nothing to move",
        {"said": 0.0, "student": LevelStudent(propose=propose(0)), "amplifier": LearningPhase(change=Multiplicative())},
        f"none of 20 decisions was amplified: {STILL}",
    ),
    ("nothing to move", {"said": 1.0}, f".*: {STILL}"),
    (
        "nobody asked",
        {"student": LevelStudent(propose=propose(0))},
        ".* student 'scripted-level' asked for no level above 0, and amplifier 'never' raised none. Use an amplifier",
    ),
    (
        "no limits",
        {"limits": ts.Limits(cap=0.5)},
        "neither limits.factor nor limits.slew is set, .* by 0.5 of its scale.* take factor 1.3 and slew 1",
    ),
]


@pytest.mark.parametrize(("kind", "slots", "said"), FAULTS, ids=[f"{kind}-{i}" for i, (kind, *_) in enumerate(FAULTS)])
def test_each_kind_of_fault_is_told_with_what_to_do(kind: str, slots: dict[str, Any], said: str) -> None:
    (notice,) = drive(make_engine(**slots))
    assert kind == notice.kind
    pattern = ".*".join(re.escape(text) for text in said.split(".*"))
    assert re.match(pattern, notice.says), notice.says


def test_a_student_that_never_names_the_kind_is_told() -> None:
    class Mute(LevelStudent):
        says = ts.KindProposal

    silent = Mute(propose=lambda moment: ts.KindProposal(kind=None, level=3, ampbit=True))
    (notice,) = drive(make_engine(student=silent, selector=SameKind()))
    assert "kinds" == notice.kind
    assert "never named the tutor's kind, so that selector 'same-kind' took level 0. Where there is one" in notice.says


@pytest.mark.parametrize(
    "slots",
    [
        {"student": Silent()},
        {"student": Silent(), "conditions": [ts.condition("hot")(lambda _: True)()]},
        {"student": Constant(level=2)},
    ],
)
def test_a_control_that_is_taught_nothing_is_meant_to_do_nothing(slots: dict[str, Any]) -> None:
    assert [] == drive(make_engine(**slots))


def test_limits_that_were_left_out_on_purpose_are_no_fault() -> None:
    assert [] == drive(make_engine(limits=ts.Limits(factor=None)))
    assert [] == drive(make_engine(limits=ts.Limits(slew=None)))


def test_a_change_that_cannot_be_asked_beforehand_is_left_to_the_decisions() -> None:
    broken = ts.change("broken")(lambda amplification, magnitude: 1 / 0)
    assert [] == find_assembly_notices(make_engine(amplifier=Never(change=broken())))


def test_a_run_notices_too() -> None:
    noticer = Noticer()
    engine: ts.Engine[Any, Any, Any] = ts.Engine(
        tutor=Pusher(),
        student=LevelStudent(propose=fail),
        selector=Modifier(),
        amplifier=Never(),
        evaluator=Conditions(),
    )
    ts.run(engine, Rail(), 30, observers=[noticer])
    assert ["student fails"] == [notice.kind for notice in noticer.find_notices()]


def test_a_loop_warns_once_after_enough_decisions(caplog: pytest.LogCaptureFixture) -> None:
    loop = ts.Loop(make_engine(student=LevelStudent(propose=propose(0))))
    for _ in range(ENOUGH):
        loop.step(0.0)
    with pytest.warns(ts.TutorStudentWarning, match="asked for no level above 0") as found:
        loop.step(0.0)
    assert [__file__] == [warning.filename for warning in found]
    assert 1 == sum("asked for no level above 0" in record.getMessage() for record in caplog.records)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for _ in range(2 * ENOUGH):
            loop.step(0.0)
    assert 1 == sum("asked for no level above 0" in record.getMessage() for record in caplog.records)


def test_the_warning_comes_where_somebody_else_has_set_up_logging(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(logging.getLogger("tutorstudent"), "disabled", True)
    with pytest.warns(ts.TutorStudentWarning, match="nothing can ever be amplified"):
        ts.wrap(lambda y: 0.5, action=UNIT, amplifier={"use": "never", "amount": 0.5, "change": "multiplicative"})


def test_a_warning_that_is_made_an_error_does_not_cost_a_command() -> None:
    loop = ts.Loop(make_engine(student=LevelStudent(propose=propose(0))))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert [0.2] * 300 == [loop.step(0.0) for _ in range(300)]


def test_wrap_with_an_additive_change_is_told() -> None:
    amplifier = {"use": "learning-phase", "decisions": 0, "change": "additive"}
    loop = ts.wrap(lambda y: 0.2, action=UNIT, amplifier=amplifier)
    with pytest.warns(ts.TutorStudentWarning, match=r"change 'additive' .* exceeds limits.factor 1.3 of such commands"):
        assert {0.2} == {loop.step(0.0) for _ in range(ENOUGH + 1)}


@pytest.mark.parametrize(
    "error", [SystemExit(3), GeneratorExit(), ValueError("not now")], ids=lambda error: type(error).__name__
)
def test_a_change_that_raises_when_it_is_asked_at_assembly_ends_nothing(error: BaseException) -> None:
    @ts.change("moody")
    def moody(amplification: float, magnitude: float) -> float:
        raise error

    loop = ts.wrap(
        lambda state: 0.5, action=ts.scalar(-1, 1), student=Constant(level=3), amplifier=Never(change=moody())
    )
    assert 0.5 == loop.step(0.0)
    assert 1 == loop.engine.incident_counts["amplifier", "raised"]


def test_a_stop_from_outside_passes_through_also_at_assembly() -> None:
    @ts.change("slow")
    def slow(amplification: float, magnitude: float) -> float:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        ts.wrap(lambda state: 0.5, action=ts.scalar(-1, 1), amplifier=Never(change=slow()))
