"""The messages: one JSON object a line, in UTF-8. docs/process-protocol.md is for those who write the other side."""

from __future__ import annotations

import json
import math
from typing import Any, NamedTuple

from tutorstudent.core.words.actions import Action, Group

PROTOCOL = 1
SHOWN = 120
"""Characters of a line that a message shows."""


class Unreadable(Exception):
    """A line that is no message of the protocol."""


class Answer(NamedTuple):
    """What a program says to one decision."""

    number: int
    action: dict[str, Any]
    situation: str


def make_line(kind: str, **values: Any) -> bytes:
    r"""Return a message as a line: ``type`` first, the others in order, without blanks, so that a shell can match it.

    >>> make_line("reset")
    b'{"type":"reset"}\n'
    """
    text = json.dumps({"type": kind, **values}, separators=(",", ":"), allow_nan=False)
    return text.encode("ascii") + b"\n"


def make_hello(action: type[Action], seed: int) -> bytes:
    """Return the first message: version, seed, and what the tutor's actions are."""
    words = action.vocabulary
    components = {
        spec.name: {
            "low": _make_bound(spec.low),
            "high": _make_bound(spec.high),
            "neutral": spec.neutral,
            "unit": spec.unit,
            "required": action.model_fields[spec.name].is_required(),
        }
        for spec in words.components.values()
    }
    amplified = {kind: [_describe_group(group) for group in groups] for kind, groups in words.groups.items()}
    vocabulary = {"name": action.__name__, "kinds": list(words.kinds), "components": components, "amplified": amplified}
    return make_line("hello", protocol=PROTOCOL, seed=seed, action=vocabulary)


def check_hello(said: bytes) -> None:
    """Raise `Unreadable` unless the line greets in our version of the protocol."""
    message = _read_object(said)
    if message.get("type") != "hello":
        raise Unreadable(f'it began with {_quote(said)}; expected {{"type":"hello","protocol":{PROTOCOL}}}')
    if message.get("protocol") != PROTOCOL:
        raise Unreadable(f"it speaks protocol {message.get('protocol')!r}; this is protocol {PROTOCOL}")


def read_answer(said: bytes) -> Answer:
    """Return what a line answers; raises `Unreadable`."""
    message = _read_object(said)
    number, action, situation = message.get("number"), message.get("action"), message.get("situation", "")
    if message.get("type") != "action" or type(number) is not int:
        raise Unreadable(f'it said {_quote(said)}; expected {{"type":"action","number":...,"action":{{...}}}}')
    if not isinstance(action, dict) or not isinstance(situation, str):
        raise Unreadable(f"it said {_quote(said)}; 'action' is an object and 'situation' a string")
    return Answer(number, action, situation)


def _read_object(said: bytes) -> dict[str, Any]:
    try:
        message = json.loads(said)
    except (ValueError, RecursionError):
        raise Unreadable(f"it said {_quote(said)}, which is no JSON object") from None
    if not isinstance(message, dict):
        raise Unreadable(f"it said {_quote(said)}, which is no JSON object")
    return message


def _quote(said: bytes) -> str:
    text = said[: SHOWN + 1].decode("utf-8", "backslashreplace")
    return repr(text) if len(said) <= SHOWN else f"{text[:SHOWN]!r}..."


def _make_bound(bound: float) -> float | None:
    return bound if math.isfinite(bound) else None


def _describe_group(group: Group) -> dict[str, Any]:
    return {"components": list(group.names), "direction": group.direction}
