"""What student, encoder, codec, selector, amplifier and change may do wrong while a decision is made."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count
from typing import Any

import numpy as np

from tests.core.oracle.acts import HUGE, INF, NAN, Act, Behaviour, returns
from tests.core.oracle.lies import Agreeable, LyingFloat, LyingInt, LyingStr, Touchy
from tutorstudent.core.words.proposals import KindProposal, LevelProposal
from tutorstudent.core.words.records import GradedAction
from tutorstudent.sims.pioneer.types import DriveAction


def _graded(**fields: Any) -> Act:
    return lambda honest, actions: honest._replace(**fields)


def _copy(action: Any) -> Any:
    return type(action)(**action.__dict__)


def _another_kind(honest: GradedAction[Any], actions: Sequence[Any]) -> Any:
    copy = _copy(honest.action)
    copy.__dict__["kind"] = "sideways"
    return honest._replace(action=copy)


FOREIGN = DriveAction(kind="left", rotation=0.77)
GRADES: dict[str, Behaviour] = {
    "returns a level that is NaN": Behaviour("refused", _graded(level=NAN)),
    "returns a level that is infinite": Behaviour("refused", _graded(level=INF)),
    "returns a negative level": Behaviour("refused", _graded(level=-1)),
    "returns a fractional level": Behaviour("refused", _graded(level=2.0)),
    "returns a level as a string": Behaviour("refused", _graded(level="3")),
    "returns no level": Behaviour("refused", _graded(level=None)),
    "returns a level that cannot be looked at": Behaviour("refused", _graded(level=Touchy())),
    "returns a lying negative level": Behaviour("refused", _graded(level=LyingInt(-5))),
    "returns a lying huge level": Behaviour("fine", _graded(level=LyingInt(HUGE))),
    "returns a huge level": Behaviour("fine", _graded(level=HUGE)),
    "returns an astronomic level": Behaviour("either", _graded(level=10**400)),
    "returns a numpy level": Behaviour("fine", _graded(level=np.int64(3))),
    "returns a numpy bit": Behaviour("fine", _graded(ampbit=np.bool_(True))),
    "returns a bit as an int": Behaviour("fine", _graded(ampbit=0)),
    "returns a bit that is 2": Behaviour("refused", _graded(ampbit=2)),
    "returns a bit that is a float": Behaviour("refused", _graded(ampbit=1.0)),
    "returns no bit": Behaviour("refused", _graded(ampbit=None)),
    "returns a bit that lies": Behaviour("refused", _graded(ampbit=LyingInt(7))),
    "returns a foreign action": Behaviour("refused", _graded(action=FOREIGN)),
    "returns no action": Behaviour("refused", _graded(action=None)),
    "returns what equals every action": Behaviour("either", _graded(action=Agreeable())),
    "returns an action that cannot be looked at": Behaviour("refused", _graded(action=Touchy())),
    "returns another kind": Behaviour("refused", _another_kind),
    "returns an equal copy": Behaviour("either", lambda h, a: h._replace(action=_copy(h.action))),
    "returns a plain tuple": Behaviour("refused", lambda h, a: tuple(h)),
}


def _forged(**fields: Any) -> Act:
    """Return a proposal for the tutor's kind, so that it is read, that was changed after it was validated."""

    def act(honest: Any, actions: Sequence[Any]) -> Any:
        forged = type(honest)(**honest.__dict__)
        if isinstance(honest, KindProposal):
            forged.__dict__["kind"] = actions[0].kind
        forged.__dict__.update(fields)
        return forged

    return act


def _proposed(**fields: Any) -> Act:
    return lambda honest, actions: type(honest)(**{**honest.__dict__, **fields})


def _other_type(honest: Any, actions: Sequence[Any]) -> Any:
    if type(honest) is LevelProposal:
        return KindProposal(kind=actions[0].kind, level=2, ampbit=True)
    return LevelProposal(level=2, ampbit=True)


def _reuse() -> Act:
    kept: dict[type[Any], Any] = {}

    def act(honest: Any, actions: Sequence[Any]) -> Any:
        buffer = kept.setdefault(type(honest), honest)
        buffer.__dict__.update(honest.__dict__)
        return buffer

    return act


PROPOSES: dict[str, Behaviour] = {
    "forges a level that is NaN": Behaviour("refused", _forged(level=NAN)),
    "forges a negative level": Behaviour("refused", _forged(level=-3)),
    "forges a level as a string": Behaviour("refused", _forged(level="3")),
    "forges a bit": Behaviour("refused", _forged(ampbit="yes")),
    "proposes a huge level": Behaviour("fine", _proposed(level=HUGE)),
    "proposes a lying level": Behaviour("fine", _proposed(level=LyingInt(4))),
    "proposes numpy values": Behaviour("fine", _proposed(level=np.int64(2), ampbit=np.bool_(False))),
    "proposes a negative level": Behaviour("refused", _proposed(level=-1)),
    "proposes a fractional level": Behaviour("refused", _proposed(level=1.5)),
    "makes the other type of proposal": Behaviour("refused", _other_type),
    "reuses its proposal": Behaviour("fine", _reuse()),
}
NAMES_KINDS: dict[str, Behaviour] = {
    "names a kind that lies": Behaviour("either", _forged(kind=LyingStr("sideways"))),
    "names a wrong kind": Behaviour("fine", _proposed(kind="sideways")),
    "names no kind": Behaviour("fine", _proposed(kind=None)),
}
_calls = count()
CHANGES: dict[str, Behaviour] = {
    "moves by NaN": Behaviour("refused", returns(NAN)),
    "moves by infinity": Behaviour("refused", returns(INF)),
    "moves backwards": Behaviour("refused", returns(-0.1)),
    "moves by a lying NaN": Behaviour("refused", returns(LyingFloat("nan"))),
    "moves by a lying negative": Behaviour("refused", returns(LyingFloat(-0.5))),
    "moves by a lying number": Behaviour("either", returns(LyingFloat(5.0))),
    "moves by a complex number": Behaviour("refused", returns(1j)),
    "moves by a numpy number": Behaviour("fine", lambda h, a: np.float64(h)),
    "moves far": Behaviour("either", returns(1e9)),
    "moves otherwise at each call": Behaviour("either", lambda h, a: (next(_calls) * 0.37) % 1.3),
    "moves less where it should move more": Behaviour("either", lambda h, a: 1 / (1 + 3 * h)),
}


ENCODES: dict[str, Behaviour] = {
    "encodes NaN": Behaviour("either", lambda h, a: np.full_like(h, NAN)),
    "encodes the wrong shape": Behaviour("either", lambda h, a: h[:0]),
}
