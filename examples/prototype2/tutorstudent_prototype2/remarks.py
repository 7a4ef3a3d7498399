"""Where a number or a sentence of chapter 4 does not follow from its own tables. Computed, not asserted."""

from __future__ import annotations

from collections.abc import Iterator

from tutorstudent_prototype2.thesis import (
    DECISIONS,
    Improvement,
    Remark,
    Row,
    improvements,
    percent_more,
    prototype2,
    prototype2a,
)

ROUNDING = 0.05
"""Percentages are printed with one digit behind the point, or two."""
CLAIMED_SHARE = 0.001
CLAIMED_LEAST_PERCENT = 90.0
"""What "almost 100 %" can mean at the least."""


def remarks() -> list[Remark]:
    """Return everything that does not follow."""
    return [*_percentages(), *_share_of_collisions(), *_range_of_improvement(), *_best_learning_phase()]


def from_means(improvement: Improvement) -> tuple[float, float]:
    """Return the percentages that follow from the printed means: fewer collisions, more attractors."""
    before = prototype2(improvement.environment)
    after = next(
        row
        for row in prototype2a()
        if (row.environment, row.learning_phase) == (improvement.environment, improvement.learning_phase)
    )
    return -percent_more(before.collisions, after.collisions), percent_more(before.attractors, after.attractors)


def _percentages() -> Iterator[Remark]:
    for printed in improvements():
        found = zip(printed[3:], from_means(printed), strict=True)
        for said, follows in found:
            if said is not None and abs(said - follows) > ROUNDING:
                yield Remark(f"Table {printed.table}", f"{said} %", f"the printed means give {follows:.2f} %")


def _share_of_collisions() -> Iterator[Remark]:
    beyond = [row for row in prototype2a() if row.collisions >= CLAIMED_SHARE * DECISIONS]
    if beyond:
        shares = ", ".join(f"{100 * row.collisions / DECISIONS:.2f} % ({_where(row)})" for row in beyond)
        yield Remark("4.4, 5.1", "prototype 2A collided in less than 0.1 % of its decisions everywhere", shares)


def _range_of_improvement() -> Iterator[Remark]:
    below = [item for item in improvements() if item.attractors_percent < CLAIMED_LEAST_PERCENT]
    if below:
        found = ", ".join(f"{item.attractors_percent} % ({item.environment})" for item in below)
        yield Remark("4.4, 5.1", "attractors improved by almost 100 % to over 400 %", found)


def _best_learning_phase() -> Iterator[Remark]:
    environments = dict.fromkeys(row.environment for row in prototype2a())
    groups = [[row for row in prototype2a() if row.environment == name] for name in environments]
    most = sum(max(group, key=lambda row: row.attractors).learning_phase == 2500 for group in groups)
    fewest = sum(min(group, key=lambda row: row.collisions).learning_phase == 2500 for group in groups)
    if (most, fewest) != (len(groups), len(groups)):
        counts = f"most attractors in {most} of {len(groups)} environments, fewest collisions in {fewest}"
        yield Remark("4.4", "the learning phase of 2500 decisions gave the best results in all experiments", counts)


def _where(row: Row) -> str:
    return f"{row.environment}, {row.learning_phase}"
