"""Commands without a dictionary are remembered and compared like all others."""

from __future__ import annotations

from typing import Any

import pytest

import tutorstudent as ts


class Lean:
    """A command in slots, whose copy says something else, or spoils what it was copied from."""

    __slots__ = ("note", "speed")
    spoils = ""

    def __init__(self) -> None:
        self.speed, self.note = 0.4, "eco"

    def __copy__(self) -> Any:
        made = type(self)()
        if self.spoils:
            (self if self.spoils == "own" else made).note = "sport"
        return made


@pytest.mark.parametrize("spoils", ["own", "copy"])
def test_what_is_not_declared_stays_in_slots_too(spoils: str) -> None:
    own = type("Spoiling", (Lean,), {"spoils": spoils, "__slots__": ()})()
    parts = {"student": {"use": "constant", "level": 3}, "amplifier": {"use": "never", "change": "multiplicative"}}
    loop = ts.wrap(lambda _: own, action=ts.scalar(-1, 1, name="speed"), slew=None, **parts)
    loop.step(0.0)
    own.note = "eco"
    assert all(loop.step(0.0) is own for _ in range(3))
    assert ("eco", 0.4) == (own.note, own.speed)
    assert 3 <= loop.engine.incident_counts["action", "mutated"]
