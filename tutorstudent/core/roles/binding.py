"""What a part is told about its slot, and the random stream of the slot."""

from __future__ import annotations

import hashlib
from typing import NamedTuple

import numpy as np

from tutorstudent.core.words.actions import Action


class Binding(NamedTuple):
    """What a part is told once, when a pipeline is built."""

    seed: int
    slot: str
    """Its path in the pipeline, such as ``student.encoder``; used in random streams, learned state and messages."""
    action: type[Action]
    """The tutor's action class, so that a codec knows the kinds."""


def make_stream(seed: int, slot: str) -> np.random.Generator:
    """Return the random generator of a slot: the same seed and slot give the same numbers in any process.

    >>> bool(make_stream(7, "student").random() == make_stream(7, "student").random())
    True
    >>> bool(make_stream(7, "student").random() == make_stream(7, "tutor").random())
    False
    """
    digest = hashlib.sha256(slot.encode()).digest()
    words = [int.from_bytes(digest[i : i + 4], "little") for i in range(0, 16, 4)]
    return np.random.default_rng(np.random.SeedSequence([seed, *words]))
