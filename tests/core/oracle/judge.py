"""Judges one decision by the behaviour contract. Shares no code with the engine."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any, NamedTuple

from tests.core.oracle.shapes import LAWS, Arm, Shape, Values

SLACK = 1e-7
"""In units of scale; rounding must not look like a breach."""
ROUNDING, FAINTEST = 1e-15, 1e-320
"""Relative, and where numbers are too faint for that."""
ENOUGH = 10_000
"""Levels above this one are not searched for."""


class Rules(NamedTuple):
    """What the owner of a pipeline wrote down."""

    shape: Shape
    cap: float
    factor: float | None
    slew: int | None
    amount: float
    law: str


class Said(NamedTuple):
    """The tutor's action as it was when the tutor said it."""

    kind: str
    values: Values
    constants: dict[str, object]
    itself: object


class Claim(NamedTuple):
    """What the engine says that it did."""

    executed: Any
    selected_level: int
    resulting_level: int
    ampbit: bool
    fell_back: bool
    lawful: bool
    """The distances come from the change that the rules name: nobody has lied about them."""


class Last(NamedTuple):
    """What was executed before."""

    kind: str
    level: int


class Breach(NamedTuple):
    """Something that the contract forbids."""

    name: str
    text: str


def said(shape: Shape, action: Any) -> Said:
    """Record a tutor's action by value."""
    values = {name: float(getattr(action, name)) for name in shape.bounds}
    return Said(str(action.kind), values, {name: getattr(action, name) for name in shape.constants}, action)


def judge(rules: Rules, last: Last | None, tutor: Said, claim: Claim) -> list[Breach]:
    """Return every breach of the contract in one decision; none means that it was kept."""
    found = list(_form(rules, tutor, claim))
    if found:  # what has the wrong form cannot be measured
        return found
    executed = {name: getattr(claim.executed, name) for name in rules.shape.bounds}
    arms = rules.shape.arms[tutor.kind]
    found = list(_untouched(arms, tutor, claim))
    for arm in arms:
        found += _direction(arm, tutor.values, executed)
        found += _cap(rules, arm, tutor.values, executed)
        found += _factor(rules, arm, tutor.values, executed)
    found += _levels(rules, last, tutor, claim)
    if claim.lawful:
        found += _shown(rules, arms, tutor.values, executed, claim.resulting_level)
    return found


def _form(rules: Rules, tutor: Said, claim: Claim) -> Iterator[Breach]:
    if type(claim.executed) is not rules.shape.action:
        yield Breach("class", f"executed a {type(claim.executed).__name__}")
        return
    if claim.executed.kind != tutor.kind or type(claim.executed.kind) is not str:
        yield Breach("kind", f"executed {claim.executed.kind!r}, the tutor said {tutor.kind!r}")
    for name, (low, high) in rules.shape.bounds.items():
        value = getattr(claim.executed, name)
        if not isinstance(value, float) or not math.isfinite(value):
            yield Breach("finite", f"{name} is {value!r}")
        elif not low <= float.__add__(value, 0.0) <= high:
            yield Breach("bounds", f"{name} is {value!r}, allowed {low} to {high}")
    for what, level in (("selected", claim.selected_level), ("resulting", claim.resulting_level)):
        if type(level) is not int or level < 0:
            yield Breach("level", f"{what} level is {level!r}")


def _untouched(arms: tuple[Arm, ...], tutor: Said, claim: Claim) -> Iterator[Breach]:
    movable = {name for arm in arms for name in arm.names}
    for name, value in {**tutor.values, **tutor.constants}.items():
        if name not in movable and getattr(claim.executed, name) != value:
            yield Breach("untouched", f"{name} is {getattr(claim.executed, name)!r}, the tutor said {value!r}")
    nothing_moves = claim.resulting_level == 0
    if nothing_moves and claim.executed is not tutor.itself:
        yield Breach("own object", "level 0 executes the tutor's own object")


def _offsets(arm: Arm, values: Values) -> list[float]:
    return [values[name] - neutral for name, neutral in zip(arm.names, arm.neutral, strict=True)]


def _size(arm: Arm, values: Values) -> float:
    return math.hypot(*_offsets(arm, values))


def _direction(arm: Arm, tutor: Values, executed: Values) -> Iterator[Breach]:
    if arm.direction in ("+", "-"):
        (name,) = arm.names
        step = executed[name] - tutor[name]
        if step and (step > 0) != (arm.direction == "+"):
            yield Breach("direction", f"{name} went by {step}, declared {arm.direction}")
        return
    before, after = _offsets(arm, tutor), _offsets(arm, executed)
    length = math.hypot(*before)
    if length == 0:
        if after != before:
            yield Breach("direction", f"{arm.names} left neutral for {after}")
        return
    unit = [part / length if length > 1e-300 else math.copysign(bool(part), part) for part in before]
    along = sum(a * u for a, u in zip(after, unit, strict=True))
    aside = math.hypot(*(a - along * u for a, u in zip(after, unit, strict=True)))
    if length > 1e-300 and aside > SLACK * arm.scale:
        yield Breach("direction", f"{arm.names} turned from {before} to {after}")
    if any(a * b < 0 for a, b in zip(after, before, strict=True)) or math.hypot(*after) < length - SLACK * arm.scale:
        yield Breach("direction", f"{arm.names} shrank or flipped from {before} to {after}")


def _travelled(arm: Arm, tutor: Values, executed: Values) -> float:
    return math.hypot(*(executed[name] - tutor[name] for name in arm.names)) / arm.scale


def _cap(rules: Rules, arm: Arm, tutor: Values, executed: Values) -> Iterator[Breach]:
    distance = _travelled(arm, tutor, executed)
    if distance > rules.cap + SLACK:
        yield Breach("cap", f"{arm.names} moved by {distance} of its scale, cap {rules.cap}")


def _factor(rules: Rules, arm: Arm, tutor: Values, executed: Values) -> Iterator[Breach]:
    if rules.factor is None:
        return
    if _size(arm, executed) > rules.factor * _size(arm, tutor) + SLACK * arm.scale:
        yield Breach("factor", f"{arm.names} grew from {_size(arm, tutor)} to {_size(arm, executed)}")


def _levels(rules: Rules, last: Last | None, tutor: Said, claim: Claim) -> Iterator[Breach]:
    level = claim.resulting_level
    start = last.level if last is not None and last.kind == tutor.kind else 0
    lowest = 0 if rules.slew is None else max(0, start - rules.slew)
    if rules.slew is not None and level > start + rules.slew:
        yield Breach("slew", f"level went from {start} to {level}, slew {rules.slew}")
    if level < lowest and claim.lawful and _allowed(rules, tutor, level + 1) and not _may_stand(rules, tutor, level):
        yield Breach("slew", f"level fell from {start} to {level}, slew {rules.slew}, and the limits allow {level + 1}")
    if level > 0 and (_stands(rules, tutor, claim) or (claim.lawful and _is_at_end(rules, tutor, level - 1))):
        yield Breach("honest", f"level {level} moved no more than level {level - 1}")
    if claim.fell_back and level > lowest:
        yield Breach("fallback", f"fell back to level {level} instead of {lowest}")
    if claim.fell_back and (claim.ampbit is not True or claim.selected_level != level):
        yield Breach("fallback", f"fell back to selected level {claim.selected_level}, ampbit {claim.ampbit!r}")


def _stands(rules: Rules, tutor: Said, claim: Claim) -> bool:
    """Return whether nothing was moved at all."""
    names = [name for arm in rules.shape.arms[tutor.kind] for name in arm.names]
    return all(getattr(claim.executed, name) == tutor.values[name] for name in names)


def _is_at_end(rules: Rules, tutor: Said, level: int) -> bool:
    """Return whether a level surely brings every arm as far as any level does: to a bound, or nowhere."""
    return all(_left(rules, arm, tutor.values, level) < -SLACK * arm.scale for arm in rules.shape.arms[tutor.kind])


def _may_stand(rules: Rules, tutor: Said, level: int) -> bool:
    """Return whether the next level may move nothing more: a bound is near, or the step is less than the rounding."""
    for arm in rules.shape.arms[tutor.kind]:
        step = _want(rules, arm, tutor.values, level + 1) - _want(rules, arm, tutor.values, level)
        largest = max(abs(tutor.values[name]) for name in arm.names)
        is_far = _left(rules, arm, tutor.values, level) > SLACK * arm.scale
        if is_far and step > ROUNDING * largest + FAINTEST:
            return False
    return True


def _left(rules: Rules, arm: Arm, tutor: Values, level: int) -> float:
    """Return how far a level stays from the bound; below 0 where it would go beyond, or where there is no way."""
    way = _way(arm, tutor)
    return _room(rules, arm, tutor, way) - _want(rules, arm, tutor, level) if any(way) else -math.inf


def _allowed(rules: Rules, tutor: Said, level: int) -> bool:
    """Return whether cap and factor allow a level for what the tutor said."""
    for arm in rules.shape.arms[tutor.kind]:
        if LAWS[rules.law](level * rules.amount, _size(arm, tutor.values) / arm.scale) > rules.cap - SLACK:
            return False
        ends = _ends(rules, arm, tutor.values, level)
        if rules.factor is not None and _size(arm, ends) > rules.factor * _size(arm, tutor.values) - SLACK:
            return False
    return True


def _ends(rules: Rules, arm: Arm, tutor: Values, level: int) -> Values:
    """Return where a level brings an arm: as far as the law says, or as far as the first bound that it meets."""
    way = _way(arm, tutor)
    room = max(0.0, min(_want(rules, arm, tutor, level), _room(rules, arm, tutor, way)))
    return {name: tutor[name] + room * part for name, part in zip(arm.names, way, strict=True)}


def _want(rules: Rules, arm: Arm, tutor: Values, level: int) -> float:
    """Return how far a level moves an arm where nothing is in the way."""
    return LAWS[rules.law](level * rules.amount, _size(arm, tutor) / arm.scale) * arm.scale


def _way(arm: Arm, tutor: Values) -> list[float]:
    return {"+": [1.0], "-": [-1.0]}.get(arm.direction) or _heading(_offsets(arm, tutor))


def _room(rules: Rules, arm: Arm, tutor: Values, way: list[float]) -> float:
    """Return how far it is to the first bound."""
    ways = [(rules.shape.bounds[name], tutor[name], part) for name, part in zip(arm.names, way, strict=True) if part]
    return min((((high if part > 0 else low) - value) / part for (low, high), value, part in ways), default=math.inf)


def _heading(offsets: list[float]) -> list[float]:
    """Return the unit vector; by exact fractions, since the length of the faintest numbers would be rounded."""
    longest = max(abs(part) for part in offsets)
    if not longest:
        return [0.0] * len(offsets)
    ratios = [Fraction(part) / Fraction(longest) for part in offsets]
    length = math.sqrt(sum(ratio * ratio for ratio in ratios))
    return [float(ratio) / length for ratio in ratios]


def _shown(rules: Rules, arms: tuple[Arm, ...], tutor: Values, executed: Values, level: int) -> Iterator[Breach]:
    for arm in arms:
        expected = _ends(rules, arm, tutor, level)
        if any(abs(expected[name] - executed[name]) > SLACK * arm.scale for name in arm.names):
            yield Breach("shown", f"level {level} should bring {expected}, executed {executed}")
