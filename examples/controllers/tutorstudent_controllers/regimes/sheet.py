"""The study as Markdown: one row a cell, and what was promised before the first run."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tutorstudent_controllers.paired import Difference
from tutorstudent_controllers.regimes.registered import Registered
from tutorstudent_controllers.regimes.verdicts import Measured, Verdict

HEAD = (
    "cell",
    "tutor alone",
    "**budgeted**",
    "*blind*",
    "*ramp*",
    "*best fixed level*",
    "own violations / budget",
    "of the best fixed",
    "of blind",
    "blind violates times",
    "runs",
)


def write_sheet(registered: Registered, verdicts: Sequence[Verdict]) -> str:
    """Return both tables. Gain / violated decisions; a number that misses what was registered has a (!)."""
    lines = [
        _row(HEAD),
        _row(["---", *["---:"] * (len(HEAD) - 1)]),
        *(_row(_cells(registered, item)) for item in verdicts),
        "",
        *_promises(registered, verdicts),
        "",
        *_singles(verdicts),
    ]
    return "\n".join(lines) + "\n"


def _cells(registered: Registered, item: Verdict) -> Iterator[str]:
    yield item.cell
    yield _pair(item.alone)
    yield _pair(item.budgeted)
    yield _pair(item.blind)
    yield _pair(item.ramp)
    yield f"{item.best}: {_pair(item.fixed)}"
    yield _mark(f"{item.own:.0f} / {item.allowed:.0f}", item.keeps_budget <= registered.within)
    yield _mark(f"{item.share_of_best:.2f}", item.share_of_best >= registered.share)
    yield _mark(f"{item.share_of_blind:.2f}", item.share_of_blind >= registered.blind_share)
    yield "-" if item.times_fewer is None else f"{item.times_fewer:.1f}"
    yield str(item.runs)


def _promises(registered: Registered, verdicts: Sequence[Verdict]) -> Iterator[str]:
    count = len(verdicts)
    within = sum(item.keeps_budget <= registered.within for item in verdicts)
    good = sum(item.share_of_best >= registered.share and item.keeps_budget <= registered.within for item in verdicts)
    times = [item.times_fewer for item in verdicts if item.times_fewer is not None]
    fewer = f"{np.exp(np.mean(np.log(times))):.1f}" if times else "-"
    yield _row(["registered", "reached"])
    yield _row(["---", "---"])
    yield _row(
        [f"own violations within {registered.within:g} x the budget in 90 % of the cells", f"{within} of {count}"]
    )
    yield _row(
        [
            "3 x fewer own violations than the blind twin, as a geometric mean over the cells in which that has any",
            f"{fewer} x over {len(times)} cells",
        ]
    )
    blind = sum(item.share_of_blind >= registered.blind_share for item in verdicts)
    yield _row([f"gain at least {registered.blind_share:g} of the blind twin's", f"{blind} of {count} cells"])
    yield _row(
        [
            f"gain at least {registered.share:g} of the best fixed level in hindsight, within the budget, in 80 %",
            f"{good} of {count} cells",
        ]
    )


def _singles(verdicts: Sequence[Verdict]) -> Iterator[str]:
    """Say how it fares against one and the same level everywhere; levels beyond the limits are the highest within."""
    yield _row(
        [
            "one fixed level everywhere",
            "budgeted better on gain or violations",
            "the level better on gain or violations",
            "budgeted better on one, worse on none",
            "the level better on one, worse on none",
            "cells",
        ]
    )
    yield _row(["---", "---:", "---:", "---:", "---:", "---:"])
    for level in sorted({level for item in verdicts for level in item.against}):
        there = [item.against[max(known for known in item.against if known <= level)] for item in verdicts]
        better = [_is_above(gain) or _is_below(violated) for gain, violated in there]
        worse = [_is_below(gain) or _is_above(violated) for gain, violated in there]
        won = sum(good and not bad for good, bad in zip(better, worse, strict=True))
        lost = sum(bad and not good for good, bad in zip(better, worse, strict=True))
        yield _row(map(str, (level, sum(better), sum(worse), won, lost, len(there))))


def _is_above(found: Difference) -> bool:
    return found.interval is not None and found.interval[0] > 0


def _is_below(found: Difference) -> bool:
    return found.interval is not None and found.interval[1] < 0


def _pair(found: Measured) -> str:
    return f"{found.gain.mean():.4g} / {found.violated.mean():.4g}"


def _mark(text: str, holds: bool) -> str:
    return text if holds else f"{text} (!)"


def _row(cells: Sequence[str] | Iterator[str]) -> str:
    return f"| {' | '.join(cells)} |"
