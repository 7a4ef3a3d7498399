"""What any part may do wrong.

A behaviour is handed what the part would honestly return and the actions that it can reach, and returns what the part
returns instead.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Literal, NamedTuple

from tests.core.oracle.lies import Fatal, LyingFloat, LyingStr, Touchy, Unsayable

Verdict = Literal["refused", "fine", "either"]
"""``refused``: an incident and the tutor's own action; ``fine``: no incident; ``either``: the engine may choose."""
Act = Callable[[Any, Sequence[Any]], Any]
NAN, INF = float("nan"), float("inf")
HUGE = 10**9


class Behaviour(NamedTuple):
    """Something that a part does in one call."""

    verdict: Verdict
    act: Act


def _raise(error: BaseException) -> Any:
    raise error


def returns(value: Any) -> Act:
    return lambda honest, actions: value


RAISES: dict[str, Behaviour] = {
    "raises an exception": Behaviour("refused", lambda h, a: _raise(ValueError("hostile"))),
    "raises SystemExit": Behaviour("refused", lambda h, a: _raise(SystemExit(3))),
    "raises GeneratorExit": Behaviour("refused", lambda h, a: _raise(GeneratorExit())),
    "raises StopIteration": Behaviour("refused", lambda h, a: _raise(StopIteration())),
    "raises a BaseException": Behaviour("refused", lambda h, a: _raise(Fatal("fatal"))),
    "raises what cannot be said": Behaviour("refused", lambda h, a: _raise(Unsayable())),
    "recurses for ever": Behaviour("refused", lambda h, a: _recurse()),
}
JUNK: dict[str, Behaviour] = {
    "returns None": Behaviour("refused", returns(None)),
    "returns a string": Behaviour("refused", returns("0.5")),
    "returns an object": Behaviour("refused", returns(object())),
    "returns what cannot be looked at": Behaviour("refused", returns(Touchy())),
}


def _recurse() -> Any:
    return _recurse()


def _spoil(change: Callable[[dict[str, Any], str], None]) -> Behaviour:
    def act(honest: Any, actions: Sequence[Any]) -> Any:
        for action in actions:
            name = next(key for key, value in action.__dict__.items() if isinstance(value, float))
            change(action.__dict__, name)
        return honest

    return Behaviour("refused", act)


def _shift(values: dict[str, Any], name: str) -> None:
    values[name] = values[name] * 0.5 + 0.123 if values[name] != 0.246 else 0.0


MUTATES: dict[str, Behaviour] = {
    "changes a component": _spoil(_shift),
    "changes a component to NaN": _spoil(lambda values, name: values.__setitem__(name, NAN)),
    "changes a component to a lying number": _spoil(lambda v, name: v.__setitem__(name, LyingFloat(v[name] + 0.3))),
    "changes the kind": _spoil(lambda values, name: values.__setitem__("kind", "sideways")),
    "changes the kind to a lying string": _spoil(lambda values, name: values.__setitem__("kind", LyingStr("away"))),
    "takes a component away": _spoil(lambda values, name: values.pop(name) and None),
    "empties the action": _spoil(lambda values, name: values.clear()),
}
