"""Judges one command by what the owner received, what the controller said and what the owner declared; nothing else.

All limits are computed here, with exact fractions. Slew counts levels, which the owner does not see: the judge keeps
the lowest and the highest level that explain what was received.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from tests.core.oracle.judge import Breach
from tests.wrapping.oracle.imprint import imprint
from tests.wrapping.oracle.kits import Bounds, Kit

SLACK = Fraction(1, 10**8)
"""Relative; rounding must not look like a breach."""
TINIEST = Fraction(5e-324)
TOLERANCE = Fraction(1, 10**9)
"""Of a number, where a level is told from what somebody wrote (the behaviour contract, 6)."""
HIGHEST = 1000


class Rules(NamedTuple):
    """What an owner wrote down."""

    kit: Kit
    bounds: Bounds
    cap: float
    factor: float | None
    slew: int | None
    amount: float
    law: str


class Said(NamedTuple):
    """The controller's command as it was when it was said."""

    itself: Any
    numbers: tuple[Fraction, ...]
    kinds: tuple[type[Any], ...]
    rest: Any
    whole: Any


class Levels(NamedTuple):
    """The lowest and the highest level that can have been executed last."""

    low: int = 0
    high: int = 0


def say(kit: Kit, command: Any) -> Said:
    """Record a command of the controller's by value."""
    numbers = kit.read(command)
    rest = imprint(command, kit.skipped)
    exact = tuple(Fraction(float(number)) for number in numbers)
    return Said(command, exact, tuple(map(type, numbers)), rest, imprint(command))


def _grain(number: Any) -> Fraction:
    coarse = Fraction(float(np.finfo(number.dtype).eps)) if isinstance(number, np.floating) else Fraction(1, 2**52)
    smallest = (
        Fraction(float(np.finfo(number.dtype).smallest_subnormal)) if isinstance(number, np.floating) else TINIEST
    )
    return abs(Fraction(float(number))) * coarse + smallest


class Measured(NamedTuple):
    """What was received, in numbers."""

    numbers: tuple[Fraction, ...]
    travelled: Fraction
    """The square of the distance from the controller's own."""
    size: Fraction
    """The square of the controller's own distance from neutral."""
    slack: Fraction
    """What rounding may add to a distance: four units in the last place of the largest number."""
    grain: tuple[Fraction, ...]
    """The distance between neighbours in the owner's precision, round about."""


def measure(rules: Rules, said: Said, received: Any, strict: bool) -> Measured | list[Breach]:
    """Return what was received in numbers, or why it has none.

    Args:
        strict: Whether the numbers have to keep their types too; not where the owner's type chose others.
    """
    found = list(_form(rules.kit, said, received, strict and rules.kit.exact and rules.kit.fixed))
    if found:
        return found
    floats = [float.__add__(float(number), 0.0) for number in rules.kit.read(received)]
    if not all(map(math.isfinite, floats)):
        return [Breach("finite", f"received {floats}")]
    numbers, neutral = tuple(map(Fraction, floats)), Fraction(rules.bounds.neutral)
    travelled = sum(((new - old) ** 2 for new, old in zip(numbers, said.numbers, strict=True)), Fraction(0))
    size = sum(((old - neutral) ** 2 for old in said.numbers), Fraction(0))
    largest = max(*map(abs, numbers), *map(abs, said.numbers), abs(neutral))
    before, after = rules.kit.read(said.itself), rules.kit.read(received)
    own = Fraction(rules.kit.grain)
    grain = tuple(max(_grain(old), _grain(new)) + own for old, new in zip(before, after, strict=True))
    slack = largest / 2**50 + TINIEST * (1 + Fraction(rules.bounds.scale))  # faint numbers are coarse in units of scale
    return Measured(numbers, travelled, size, slack, grain)


def _form(kit: Kit, said: Said, received: Any, strict: bool) -> Iterator[Breach]:
    whole = kit.exact and kit.skipped != ((),)
    if whole and type(received) is not type(said.itself):
        yield Breach("type", f"received a {type(received).__name__}, said was a {type(said.itself).__name__}")
        return
    try:
        kinds = tuple(map(type, kit.read(received)))
        rest = imprint(received, kit.skipped)
    except Exception as error:
        yield Breach("type", f"what was received cannot be read: {type(error).__name__}: {error}")
        return
    if len(kinds) != kit.size:
        yield Breach("type", f"received {len(kinds)} numbers")
    elif strict and kinds != said.kinds:
        yield Breach("type", f"received {_names(kinds)}, said were {_names(said.kinds)}")
    elif not all(issubclass(kind, float | int | np.number | Fraction) or kind.__name__ == "Decimal" for kind in kinds):
        yield Breach("type", f"received {_names(kinds)}")
    if whole and kit.skipped and rest != said.rest:
        yield Breach("rest", f"not declared, and changed: {rest} instead of {said.rest}")


def _names(kinds: Sequence[type[Any]]) -> str:
    return ", ".join(kind.__name__ for kind in kinds)


def judge(rules: Rules, said: Said, got: Measured) -> list[Breach]:
    """Return every breach of bounds, direction, cap and factor; the controller's own numbers are none."""
    if got.numbers == said.numbers:
        return []
    return [*_bounds(rules, got), *_direction(rules, said, got), *_cap(rules, got), *_factor(rules, got)]


def _bounds(rules: Rules, got: Measured) -> Iterator[Breach]:
    for number, low, high in zip(got.numbers, rules.bounds.low, rules.bounds.high, strict=True):
        if not Fraction(low) <= number <= Fraction(high):
            yield Breach("bounds", f"received {float(number)!r}, allowed {low} to {high}")


def _direction(rules: Rules, said: Said, got: Measured) -> Iterator[Breach]:
    neutral = Fraction(rules.bounds.neutral)
    for new, old in zip(got.numbers, said.numbers, strict=True):
        step, outward = new - old, old - neutral
        if step and (not outward or (step > 0) != (outward > 0)):
            yield Breach("direction", f"went from {float(old)!r} to {float(new)!r}, neutral {rules.bounds.neutral}")


def _above(square: Fraction, limit: Fraction, slack: Fraction) -> bool:
    """Return whether a squared distance is above a limit, rounding aside."""
    return square > (limit * (1 + SLACK) + slack) ** 2


def _cap(rules: Rules, got: Measured) -> Iterator[Breach]:
    if _above(got.travelled, Fraction(rules.cap) * Fraction(rules.bounds.scale), got.slack):
        distance = math.sqrt(got.travelled)
        yield Breach("cap", f"went {distance}, allowed are {rules.cap} x {rules.bounds.scale}")


def _factor(rules: Rules, got: Measured) -> Iterator[Breach]:
    if rules.factor is None:
        return
    neutral, factor = Fraction(rules.bounds.neutral), Fraction(rules.factor)
    after = sum((number - neutral) ** 2 for number in got.numbers)
    if after > _grown(got.size * factor**2, got.slack):
        yield Breach("factor", f"grew from {math.sqrt(got.size)} to {math.sqrt(after)}, allowed is {rules.factor}")


def _grown(square: Fraction, slack: Fraction) -> Fraction:
    """Return at least the square of (root + slack), without taking a root of something too small for it."""
    return square * (1 + 3 * SLACK) + slack**2 * (1 + 1 / SLACK)


def step_length(rules: Rules, got: Measured) -> Fraction:
    """Return the square of what one level moves."""
    unit = got.size if rules.law == "multiplicative" else Fraction(rules.bounds.scale) ** 2
    return unit * Fraction(rules.amount) ** 2


def judge_levels(rules: Rules, got: Measured, before: Levels, lawful: bool, own: bool) -> tuple[Levels, list[Breach]]:
    """Return which levels may have been executed, and every breach of slew.

    Args:
        lawful: Nobody has lied about how far a level moves.
        own: The controller's own was executed instead of what was decided.
    """
    most = HIGHEST if rules.slew is None else min(before.high + rules.slew, HIGHEST)
    if not lawful:
        return Levels(0, most), []
    unit, found = step_length(rules, got), []
    if got.travelled > _grown(unit * most**2, got.slack):
        found.append(Breach("slew", f"moved {_count(got.travelled, unit)} levels; at most {most} were allowed"))
    least = 0 if rules.slew is None or own else _least(rules, got, before.low - rules.slew)
    if least and not _stopped(rules, got) and _grown(got.travelled, got.slack + sum(got.grain)) < unit * least**2:
        found.append(Breach("slew", f"moved {_count(got.travelled, unit)} levels; at least {least} were expected"))
    if _stopped(rules, got) or _grown(unit, Fraction(0)) < (got.slack * 2**50 * SLACK) ** 2:  # levels look the same
        return Levels(0, most), found
    reached = _count(got.travelled, unit)
    coarse = sum(got.grain) + got.slack + got.slack * 2**50 * TOLERANCE  # what is written may miss a level by so much
    grain = float(coarse) / math.sqrt(unit) if math.sqrt(unit) > 1e-300 else float(HIGHEST)
    low, high = math.ceil(reached * (1 - 1e-6) - grain - 1e-6), math.floor(reached * (1 + 1e-6) + grain + 1e-6)
    return Levels(max(low, 0), min(most, max(high, 0))), found


def _count(travelled: Fraction, unit: Fraction) -> float:
    return math.sqrt(min(travelled / unit, Fraction(10) ** 30)) if unit else math.inf


def _least(rules: Rules, got: Measured, level: int) -> int:
    """Return the highest level up to `level` that cap and factor surely allow."""
    unit, cap = step_length(rules, got), (Fraction(rules.cap) * Fraction(rules.bounds.scale)) ** 2
    factor = None if rules.factor is None else got.size * Fraction(rules.factor - 1) ** 2
    safe = [room for room in (cap, factor) if room is not None]
    while level > 0 and any(unit * level**2 * (1 + SLACK) ** 2 > room for room in safe):
        level -= 1
    return max(level, 0)


def _stopped(rules: Rules, got: Measured) -> bool:
    """Return whether a bound stopped it, or may have, or there was nothing to move."""
    if not got.size:
        return True
    ends = zip(got.numbers, rules.bounds.low, rules.bounds.high, got.grain, strict=True)
    return any(
        number - 4 * grain - got.slack <= Fraction(low) or number + 4 * grain + got.slack >= Fraction(high)
        for number, low, high, grain in ends
    )


def judge_heading(rules: Rules, said: Said, got: Measured) -> list[Breach]:
    """Return a breach if a vector turned: what its numbers gained is not in proportion to what they were."""
    if len(got.numbers) == 1 or not got.travelled:
        return []
    neutral = Fraction(rules.bounds.neutral)
    steps = [new - old for new, old in zip(got.numbers, said.numbers, strict=True)]
    arms = [old - neutral for old in said.numbers]
    room = max(map(abs, arms)) * 8 * (sum(got.grain) + got.slack) + max(map(abs, arms)) * max(map(abs, steps)) * SLACK
    turned = any(abs(steps[0] * arm - step * arms[0]) > room for step, arm in zip(steps, arms, strict=True))
    return [Breach("direction", f"turned from {list(map(float, arms))} by {list(map(float, steps))}")] if turned else []
