"""Checks of single roles: codecs, changes, conditions, worlds."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np

from tutorstudent.checks.likeness import take_snapshot
from tutorstudent.checks.outcome import CheckSkipped, expect
from tutorstudent.checks.subject import SEED
from tutorstudent.checks.usage import Usage, close, collect_answers, make_fresh
from tutorstudent.core.words.proposals import KindProposal


def says_back_what_it_was_told(usage: Usage) -> None:
    """Decoding what a codec encoded gives the level and ampbit, and the kind where it has one, at levels 0 and 1."""
    for question, answer in _ask_all(usage):
        (target,), (_, proposal) = question, answer
        kind = [proposal.kind] if isinstance(proposal, KindProposal) else []
        told = [proposal.level, proposal.ampbit, *kind]
        wanted = [target.level, target.ampbit, *([target.action.kind] if kind else [])]
        if target.level <= 1:
            expect(
                wanted == told,
                f"decode(encode(target)) says {wanted}",
                f"{told}",
                "let decode() undo encode(); levels 0 and 1 have to be told apart whatever the highest level is",
            )


def grows_with_the_amplification(usage: Usage) -> None:
    """A higher level never moves less: limits are searched for on that ground."""
    asked = sorted((magnitude, amplification, answer) for (amplification, magnitude), answer in _ask_all(usage))
    for (magnitude, low, near), (other, high, far) in pairwise(asked):
        expect(
            magnitude != other or near <= far,
            "fraction() grows with the amplification, or stays",
            f"fraction({low}, {magnitude}) = {near}, fraction({high}, {magnitude}) = {far}",
            "make it monotonic; what has to end somewhere ends with min(..., end)",
        )


def margins_agree_with_the_condition(usage: Usage) -> None:
    """Margins are negative or 0 exactly where the condition is violated."""
    asked = [(question, answer) for question, answer in _ask_all(usage) if answer[1]]
    if not asked:
        raise CheckSkipped("it declares no margins")
    for (state,), (violated, margins) in asked:
        least = min(margins)
        expect(
            least <= 0 if violated else least >= 0,
            "the least margin is 0 or less where the condition is violated, and 0 or more where it is not",
            f"violated: {violated}, least margin {least}, in the state {state!r}",
            "say how far the state is from a violation: positive while it is not one; 0 means violated",
        )


def same_seed_same_trial(usage: Usage) -> None:
    """`reset(seed)` begins the same trial whatever was done before."""
    part = make_fresh(usage)
    first, second = [collect_answers(usage, part) for _ in range(2)]
    state, again = part.reset(SEED), part.reset(SEED)
    close(part)
    expect(
        take_snapshot((first, state)) == take_snapshot((second, again)),
        "two trials of one seed with the same actions are the same",
        "they differ",
        "put everything back in reset(seed), and make the trial's random generator of that seed",
    )


def states_stay_as_they_were(usage: Usage) -> None:
    """States that were handed out do not change when the world moves on, and nobody can change them."""
    part = make_fresh(usage)
    states = [part.reset(SEED)]
    before = [take_snapshot(states[0])]
    for question in usage.make_usual():
        states.append(usage.ask(part, question).state)
        before.append(take_snapshot(states[-1]))
    close(part)
    changed = [number for number, state in enumerate(states) if take_snapshot(state) != before[number]]
    writable = [array for state in states for array in _find_arrays(state) if array.flags.writeable]
    expect(
        not changed and not writable,
        "a state is a new object each time, with read-only arrays",
        f"state {changed[0]} changed later" if changed else f"a state holds {len(writable)} writable arrays",
        "copy what sensors write into, and array.setflags(write=False)",
    )


def draws_itself_with_finite_numbers(usage: Usage) -> None:
    """Outlines, discs and poses of `sketch` are finite: maps and films are made of them."""
    part = make_fresh(usage)
    collect_answers(usage, part)
    sketch = part.sketch()
    close(part)
    numbers = [
        *(value for outline, _ in sketch.polygons for point in outline for value in point),
        *(value for centre, radius, _ in sketch.discs for value in (*centre, radius)),
        *(value for *pose, _ in sketch.poses for value in pose),
    ]
    if not numbers:
        raise CheckSkipped("it does not draw itself")
    strange = [value for value in numbers if not math.isfinite(value)]
    expect(not strange, "sketch() holds finite numbers of metres", f"{strange[:3]}", "leave out what has no place")


def _ask_all(usage: Usage) -> list[tuple[Any, Any]]:
    return list(zip(usage.make_usual(), collect_answers(usage, make_fresh(usage)), strict=True))


def _find_arrays(value: Any, depth: int = 0) -> Iterator[np.ndarray[Any, Any]]:
    if isinstance(value, np.ndarray):
        yield value
    elif depth < 5 and isinstance(value, list | tuple):
        for item in value:
            yield from _find_arrays(item, depth + 1)
    elif depth < 5 and isinstance(value, dict):
        for item in value.values():
            yield from _find_arrays(item, depth + 1)
    elif depth < 5:
        names = [*getattr(value, "__dict__", {}), *getattr(type(value), "__slots__", ())]
        for name in names:
            yield from _find_arrays(getattr(value, name, None), depth + 1)
