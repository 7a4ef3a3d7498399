"""What the engine has to say of a decision afterwards: incidents, records, outcome and lesson."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from tests.core.oracle.behaviours import BLAMED
from tests.core.oracle.cast import State
from tests.core.oracle.judge import Breach, Said
from tests.core.oracle.learner import Heard
from tests.core.oracle.plot import Deed


def answered(deeds: Sequence[Deed], blamed: Sequence[str]) -> Iterator[Breach]:
    """What is refused is an incident of the part that did it; what is fine is none."""
    refused = [deed for deed in deeds if deed.behaviour.verdict == "refused"]
    if refused and not any(part in BLAMED[deed.slot] for part in blamed for deed in refused):
        yield Breach("incident", f"went unnoticed (blamed: {', '.join(blamed) or 'nobody'})")
    if blamed and not any(deed.behaviour.verdict in ("refused", "either") for deed in deeds):
        yield Breach("false alarm", f"{', '.join(blamed)} blamed for nothing")


def recorded(turn: Any, words: Said, executed: dict[str, object]) -> Iterator[Breach]:
    """Records show what the tutor said and what was executed, whatever the parts did to their copies."""
    decision = turn.decision
    own = {"kind": words.kind, **words.values, **words.constants}
    for where, action in (
        ("moment", decision.moment.tutor_action),
        ("selected", decision.selected.action),
        ("resulting", decision.resulting.action),
    ):
        if _plain(action.__dict__) != own:
            yield Breach("record", f"the {where} shows {action.__dict__}, the tutor said {own}")
    if _plain(decision.executed.__dict__) != executed:
        yield Breach("record", f"the executed action shows {decision.executed.__dict__}, executed was {executed}")


def _plain(values: dict[str, Any]) -> dict[str, object]:
    """Return values that cannot lie."""
    plain = {float: lambda v: v, str: lambda v: v}
    return {key: plain.get(type(value), lambda v: f"a {type(v).__name__}")(value) for key, value in values.items()}


def judged(turn: Any, state: State, deeds: Sequence[Deed]) -> Iterator[Breach]:
    hostile = [deed for deed in deeds if deed.slot in ("condition", "margins")]
    violated = state.hot or any(deed.behaviour.verdict == "refused" for deed in hostile)
    expected = ("flag",) if violated else ()
    if turn.outcome.violated != expected:
        yield Breach("violated", f"recorded {turn.outcome.violated}, expected {expected}")


def taught(
    turn: Any, heard: Sequence[Heard], words: Said, executed: dict[str, object], deeds: Sequence[Deed]
) -> Iterator[Breach]:
    teaching = [deed for deed in deeds if deed.slot in ("evaluator", "learner", "encode")]
    if any(deed.behaviour.verdict == "refused" for deed in teaching):
        if turn.lesson is not None:
            yield Breach("lesson", "a refused lesson is recorded as taught")
        if heard and any(deed.slot == "evaluator" and deed.behaviour.verdict == "refused" for deed in teaching):
            yield Breach("lesson", "a refused lesson was taught")
        return
    if any(deed.slot == "evaluator" for deed in teaching):
        return
    selected, resulting = turn.decision.selected, turn.decision.resulting
    success = not turn.outcome.violated
    level = resulting.level if success else selected.level if resulting.level > selected.level else 0
    own = {"kind": words.kind, **words.values, **words.constants}
    moment = turn.decision.moment
    expected = [Heard(moment.number, moment.state, own, level, success, resulting.level, executed)]
    if list(heard) != expected:
        yield Breach("lesson", f"taught {heard}, expected {expected}")
