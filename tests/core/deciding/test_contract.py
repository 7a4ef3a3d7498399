"""The behaviour contract, with parts that do everything that they should not (docs/architecture.md).

What each part may do is listed in `tests.core.oracle`; the judge there keeps its own record of what the tutor said and
shares no code with the engine. `tests.soak` runs the same at full size.
"""

from __future__ import annotations

import pytest

from tests.core.oracle.behaviours import EVERYTHING
from tests.core.oracle.branches import ENGINE, find_missing
from tests.core.oracle.doubles import BROKEN
from tests.core.oracle.trial import Tally, run
from tutorstudent.core.deciding.engine import Engine

UNDISPUTED = [
    ("student", "raises an exception"),
    ("selector", "returns None"),
    ("amplifier", "returns a negative level"),
    ("change", "moves by NaN"),
    ("condition", "raises SystemExit"),
    ("evaluator", "raises an exception"),
]


@pytest.mark.parametrize(("slot", "behaviour"), EVERYTHING, ids=[f"{slot} {name}" for slot, name in EVERYTHING])
def test_the_contract_holds_when(slot: str, behaviour: str) -> None:
    tally = run(3, 45, chosen=[(slot, behaviour)], trial_length=15)
    assert tally.deeds[slot, behaviour] > 0
    assert not tally.breaches, tally.report()


def test_the_contract_holds_whatever_all_parts_do() -> None:
    tally = run(11, 20_000)
    assert set(EVERYTHING) == set(tally.deeds)
    assert [] == find_missing(tally.hits, ENGINE, 4)
    assert not tally.breaches, tally.report()


def test_the_storm_leaves_enough_decisions_in_which_something_is_learned_and_amplified() -> None:
    tally = run(12, 2000)
    assert tally.clean >= 0.3 * tally.decisions
    assert tally.amplified >= 0.1 * tally.decisions


def test_honest_parts_cause_no_incident_and_no_breach() -> None:
    tally = run(13, 2000, mischief=0.0)
    assert tally.clean >= tally.decisions - tally.decisions // 15 - 20  # all but those that a trial's end leaves open
    assert not tally.breaches, tally.report()


def judged(make_engine: type[Engine]) -> Tally:
    """Return what is seen of an engine, the same pipelines and the same deeds for each."""
    return run(5, 400, chosen=UNDISPUTED, make_engine=make_engine, trial_length=40, mischief=0.3)


@pytest.fixture(scope="module")
def sound() -> Tally:
    """What is seen of the real engine."""
    return judged(Engine)


@pytest.mark.parametrize("name", BROKEN)
def test_the_judge_names_what_is_wrong_with_an_engine_that(name: str, sound: Tally) -> None:
    broken, breach = BROKEN[name]
    assert breach not in {key[0] for key in sound.breaches}, sound.report()
    assert breach in {key[0] for key in judged(broken).breaches}
