"""The behaviour contract at the owner's end: what a wrapped controller's owner receives, whatever parts and types do.

`tests.wrapping.oracle` lists the forms of command and what may go wrong; its judge reads what was received and nothing
of the engine's. `tests.soak` runs the same at full size.
"""

from __future__ import annotations

import logging
import warnings
from collections.abc import Iterator

import pytest

from tests.core.oracle.branches import WRAP, find_missing
from tests.wrapping.oracle.cast import EVERYTHING
from tests.wrapping.oracle.doubles import BROKEN, Broken
from tests.wrapping.oracle.trial import Tally, run


@pytest.fixture(autouse=True)
def _silence() -> Iterator[None]:
    logging.disable(logging.CRITICAL)
    with warnings.catch_warnings(action="ignore"):
        yield
    logging.disable(logging.NOTSET)


@pytest.mark.soak
def test_the_contract_of_wrap_holds_whatever_parts_and_types_do() -> None:
    tally = run(11, 20_000)
    assert not tally.breaches, tally.report()
    assert set(EVERYTHING) == set(tally.deeds)
    assert [] == find_missing(tally.hits, WRAP, 4)
    assert tally.clean >= 0.3 * tally.decisions
    assert tally.amplified >= 0.1 * tally.decisions


def test_sound_types_and_honest_parts_cause_no_incident_and_no_breach() -> None:
    tally = run(13, 3000, mischief=0.0)
    assert not tally.breaches, tally.report()
    assert tally.amplified >= 0.1 * tally.decisions


UNDISPUTED = [
    ("student", "raises an exception"),
    ("selector", "returns None"),
    ("change", "moves far"),
    ("number", "becomes NaN"),
    ("number", "doubles"),
    ("number", "raises an exception"),
]


def judged(make_loop: type[Broken]) -> Tally:
    return run(5, 700, chosen=UNDISPUTED, make_loop=make_loop, trial_length=20, mischief=0.3)


@pytest.mark.parametrize("name", BROKEN)
def test_the_judge_names_what_is_wrong_with_a_loop_that(name: str) -> None:
    broken, breach = BROKEN[name]
    assert breach in {key[0] for key in judged(broken).breaches}


def test_the_judge_finds_nothing_wrong_with_a_loop_that_is_not_broken() -> None:
    tally = judged(Broken)
    assert not tally.breaches, tally.report()
