"""Checks of where a part's random numbers come from."""

from __future__ import annotations

import random
from collections.abc import Iterator
from typing import Any

import numpy as np

from tutorstudent.checks.likeness import take_snapshot
from tutorstudent.checks.outcome import CheckSkipped, expect
from tutorstudent.checks.subject import SEED, walk_family
from tutorstudent.checks.usage import Usage, close, collect_answers, make_fresh
from tutorstudent.core.roles.binding import make_stream
from tutorstudent.core.roles.part import Component
from tutorstudent.core.roles.world import World

_GENERATORS = (np.random.Generator, np.random.RandomState, random.Random)


def same_seed_same_answers(usage: Usage) -> None:
    """Two instances with the same options, seed and slot say the same."""
    pairs = zip(collect_answers(usage, make_fresh(usage)), collect_answers(usage, make_fresh(usage)), strict=True)
    differing = [number for number, (one, other) in enumerate(pairs) if take_snapshot(one) != take_snapshot(other)]
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
    one, other = _use(usage, "here"), _use(usage, "there")
    generators = dict(_find_generators(one))
    untouched = all(
        take_snapshot(_get_state(value)) == take_snapshot(_get_state(make_stream(SEED, slot)))
        for slot, value in generators.items()
    )
    if untouched:
        raise CheckSkipped("it uses no random numbers")
    others = {key.replace("there", "here", 1): _get_state(value) for key, value in _find_generators(other)}
    shared = [
        key for key, value in generators.items() if take_snapshot(_get_state(value)) == take_snapshot(others.get(key))
    ]
    expect(
        not shared,
        "its random numbers depend on seed and slot",
        f"the generator {shared[0]} is the same in two slots" if shared else "",
        "use self.rng, which is there from setup() on; seed other generators from it",
    )


def leaves_global_random_numbers_alone(usage: Usage) -> None:
    """The generators of `numpy.random` and `random` belong to everybody: they are neither drawn from nor seeded."""
    saved = _get_globals()
    _set_globals(_make_unlikely())
    try:
        before = take_snapshot(_get_globals())
        part = make_fresh(usage)
        collect_answers(usage, part)
        close(part)
        after = take_snapshot(_get_globals())
    finally:
        _set_globals(saved)
    expect(
        before == after,
        "numpy.random and random are left as they are",
        "the state of a global generator changed",
        "draw from self.rng; hand it on to libraries, as in random_state=int(self.rng.integers(2**31))",
    )


def _use(usage: Usage, slot: str) -> Any:
    part = make_fresh(usage, slot)
    collect_answers(usage, part)
    return part


def _find_generators(part: Component) -> Iterator[tuple[str, Any]]:
    # Its own generator stands under its slot, all others under slot and attribute.
    for member in walk_family(part):
        for name, value in sorted(vars(member).items()):
            if isinstance(value, _GENERATORS):
                yield (member.slot if name == "rng" else f"{member.slot}.{name}"), value


def _get_state(generator: Any) -> Any:
    if isinstance(generator, np.random.Generator):
        return generator.bit_generator.state
    return generator.get_state() if isinstance(generator, np.random.RandomState) else generator.getstate()


def _get_globals() -> tuple[Any, Any]:
    return np.random.get_state(), random.getstate()  # noqa: NPY002 - these are what is watched


def _set_globals(states: tuple[Any, Any]) -> None:
    np.random.set_state(states[0])  # noqa: NPY002
    random.setstate(states[1])


def _make_unlikely() -> tuple[Any, Any]:
    # A part that always seeds with its favourite number is caught only where that was not done before.
    return np.random.RandomState(0x7E57).get_state(), random.Random(0x7E57).getstate()  # noqa: S311
