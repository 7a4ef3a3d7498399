"""Checks of where a part's random numbers come from."""

from __future__ import annotations

import random
from collections.abc import Iterator
from typing import Any

import numpy as np

from tutorstudent.checks.likeness import snapshot
from tutorstudent.checks.outcome import CheckSkipped, expect
from tutorstudent.checks.subject import SEED, family
from tutorstudent.checks.usage import Usage, answers, close, fresh
from tutorstudent.core.roles.binding import stream
from tutorstudent.core.roles.part import Component
from tutorstudent.core.roles.world import World

_GENERATORS = (np.random.Generator, np.random.RandomState, random.Random)


def same_seed_same_answers(usage: Usage) -> None:
    """Two instances with the same options, seed and slot say the same."""
    pairs = zip(answers(usage, fresh(usage)), answers(usage, fresh(usage)), strict=True)
    differing = [number for number, (one, other) in enumerate(pairs) if snapshot(one) != snapshot(other)]
    expect(
        not differing,
        "two instances with the same seed give the same answers",
        f"they differ from answer {differing[0] + 1} on" if differing else "",
        "draw random numbers from self.rng only (a world: from the seed of reset), and look at no clock, id or hash",
    )


def has_its_own_random_numbers(usage: Usage) -> None:
    """Random numbers depend on the slot, so that two parts of one pipeline never draw the same ones."""
    if issubclass(usage.subject.cls, World):
        raise CheckSkipped("a world draws from the seed of its trial")
    one, other = _used(usage, "here"), _used(usage, "there")
    generators = dict(_generators(one))
    untouched = all(
        snapshot(_state(value)) == snapshot(_state(stream(SEED, slot))) for slot, value in generators.items()
    )
    if untouched:
        raise CheckSkipped("it uses no random numbers")
    others = {place.replace("there", "here", 1): _state(value) for place, value in _generators(other)}
    shared = [place for place, value in generators.items() if snapshot(_state(value)) == snapshot(others.get(place))]
    expect(
        not shared,
        "its random numbers depend on seed and slot",
        f"the generator {shared[0]} is the same in two slots" if shared else "",
        "use self.rng, which is there from setup() on; seed other generators from it",
    )


def leaves_global_random_numbers_alone(usage: Usage) -> None:
    """The generators of `numpy.random` and `random` belong to everybody: they are neither drawn from nor seeded."""
    saved = _globals()
    _set_globals(_unlikely())
    try:
        before = snapshot(_globals())
        part = fresh(usage)
        answers(usage, part)
        close(part)
        after = snapshot(_globals())
    finally:
        _set_globals(saved)
    expect(
        before == after,
        "numpy.random and random are left as they are",
        "the state of a global generator changed",
        "draw from self.rng; hand it on to libraries, as in random_state=int(self.rng.integers(2**31))",
    )


def _used(usage: Usage, slot: str) -> Any:
    part = fresh(usage, slot)
    answers(usage, part)
    return part


def _generators(part: Component) -> Iterator[tuple[str, Any]]:
    # Its own generator stands under its slot, all others under slot and attribute.
    for member in family(part):
        for name, value in sorted(vars(member).items()):
            if isinstance(value, _GENERATORS):
                yield (member.slot if name == "rng" else f"{member.slot}.{name}"), value


def _state(generator: Any) -> Any:
    if isinstance(generator, np.random.Generator):
        return generator.bit_generator.state
    return generator.get_state() if isinstance(generator, np.random.RandomState) else generator.getstate()


def _globals() -> tuple[Any, Any]:
    return np.random.get_state(), random.getstate()  # noqa: NPY002 - these are what is watched


def _set_globals(states: tuple[Any, Any]) -> None:
    np.random.set_state(states[0])  # noqa: NPY002
    random.setstate(states[1])


def _unlikely() -> tuple[Any, Any]:
    # A part that always seeds with its favourite number is caught only where that was not done before.
    return np.random.RandomState(0x7E57).get_state(), random.Random(0x7E57).getstate()  # noqa: S311
