"""What is said on the wire: states as JSON, and answers that are read strictly."""

from __future__ import annotations

import dataclasses
import enum
import json
import math
import re
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import BaseModel

from tutorstudent.core.words.errors import ContractError
from tutorstudent.plugins.process.plain import make_plain
from tutorstudent.plugins.process.protocol import Answer, Unreadable, check_hello, make_line, read_answer
from tutorstudent.sims.pioneer.types import Blob, PioneerState


class Pair(NamedTuple):
    x: float
    y: float


class Mode(enum.Enum):
    AUTO = "auto"


class Word(enum.StrEnum):
    GO = "go"


class Reading(BaseModel):
    celsius: float


@dataclasses.dataclass
class Sensed:
    scan: Any


@pytest.mark.parametrize(
    ("state", "expected"),
    [
        (None, None),
        (True, True),
        (np.True_, True),
        (3, 3),
        (2**80, 2**80),
        (np.int32(3), 3),
        (0.5, 0.5),
        (np.float32(0.5), 0.5),
        (math.nan, "NaN"),
        (np.float32(math.inf), "Infinity"),
        (-math.inf, "-Infinity"),
        ("x", "x"),
        (Mode.AUTO, "auto"),
        (Word.GO, "go"),
        (np.array([[1.0, 2.0]]), [[1.0, 2.0]]),
        (np.array([1.0, math.nan]), [1.0, "NaN"]),
        (np.array([1, 2]), [1, 2]),
        (np.array(1.5), 1.5),
        (np.array(["a"]), ["a"]),
        ((1, [2.0]), [1, [2.0]]),
        (Pair(1.0, 2.0), {"x": 1.0, "y": 2.0}),
        ({"a": Pair(1.0, math.inf)}, {"a": {"x": 1.0, "y": "Infinity"}}),
        (Sensed(np.zeros(2)), {"scan": [0.0, 0.0]}),
        (Reading(celsius=20.5), {"celsius": 20.5}),
    ],
)
def test_a_state_becomes_plain_json(state: Any, expected: Any) -> None:
    found = make_plain(state)
    assert expected == found
    assert type(expected) is type(found)
    assert expected == json.loads(make_line("decide", state=found))["state"]


def test_a_pioneers_state_is_its_fields_by_name() -> None:
    state = PioneerState(np.full(16, 5.0), (Blob("red", 0.1, 2.0, 0.2),), False)
    blob = {"colour": "red", "bearing_rad": 0.1, "range_m": 2.0, "width_rad": 0.2}
    assert {"sonar_m": [5.0] * 16, "blobs": [blob], "stalled": False, "bumped": False} == make_plain(state)


NESTED = st.recursive(
    st.none() | st.booleans() | st.integers() | st.text() | st.floats(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    max_leaves=8,
)


@given(NESTED)
def test_every_nested_value_survives_the_wire(state: Any) -> None:
    message = make_line("decide", number=1, state=make_plain(state))
    assert 1 == message.count(b"\n")
    assert make_plain(state) == json.loads(message)["state"]


@pytest.mark.parametrize(
    ("state", "message"),
    [
        (object(), "state: found object; a state for another program is made of numbers, strings"),
        ({"image": {1, 2}}, "state.image: found set;"),
        ([b"raw"], "state[0]: found bytes;"),
        ({"scan": {3: 1.0}}, "state.scan: found the key 3; a state for another program has strings as keys"),
        (np.array([1 + 2j]), "state[0]: found complex"),
        (Sensed, "state: found type;"),
    ],
)
def test_what_json_cannot_say_is_told_with_its_place(state: Any, message: str) -> None:
    with pytest.raises(ContractError, match=re.escape(message)):
        make_plain(state)


def test_messages_begin_with_their_type_and_hold_no_blanks() -> None:
    assert b'{"type":"decide","number":3,"state":[1.5,"NaN"]}\n' == make_line(
        "decide", number=3, state=make_plain([1.5, math.nan])
    )


def test_an_answer_is_read() -> None:
    said = b'{"type":"action","number":3,"action":{"value":0.5},"situation":"warming","more":1}\r'
    assert Answer(3, {"value": 0.5}, "warming") == read_answer(said)


DEEP = b"[" * 100_000


@pytest.mark.parametrize(
    ("said", "message"),
    [
        (b"", "it said '', which is no JSON object"),
        (b"hello there", "it said 'hello there', which is no JSON object"),
        (b"[1, 2]", "which is no JSON object"),
        (b"\xff\xfe", r"which is no JSON object"),
        (DEEP, "..., which is no JSON object"),
        (b"9" * 10_000, "which is no JSON object"),
        (b'{"type":"action"}', 'expected {"type":"action","number":...,"action":{...}}'),
        (b'{"type":"action","number":"3","action":{}}', 'expected {"type":"action"'),
        (b'{"type":"action","number":true,"action":{}}', 'expected {"type":"action"'),
        (b'{"type":"decide","number":3,"action":{}}', 'expected {"type":"action"'),
        (b'{"type":"action","number":3,"action":0.5}', "'action' is an object and 'situation' a string"),
        (b'{"type":"action","number":3,"action":{},"situation":5}', "'action' is an object and 'situation' a string"),
    ],
)
def test_what_is_no_answer_is_unreadable(said: bytes, message: str) -> None:
    with pytest.raises(Unreadable, match=re.escape(message)) as caught:
        read_answer(said)
    assert len(str(caught.value)) < 700


@pytest.mark.parametrize(
    ("said", "message"),
    [
        (b'{"type":"hi"}', 'expected {"type":"hello","protocol":1}'),
        (b'{"type":"hello","protocol":2}', "it speaks protocol 2; this is protocol 1"),
        (b'{"type":"hello"}', "it speaks protocol None"),
    ],
)
def test_a_greeting_in_another_version_is_refused(said: bytes, message: str) -> None:
    with pytest.raises(Unreadable, match=re.escape(message)):
        check_hello(said)
    check_hello(b'{"type":"hello","protocol":1,"name":"anybody"}')
