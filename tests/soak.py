"""The behaviour contract at full size: ``python -m tests.soak --decisions 1000000 --seed 1 [--only engine|wrap]``.

Half of the decisions are the engine's own, half are those of wrapped controllers, judged by what their owners receive.
Exits 1 on any breach, on a behaviour or a branch that came up too rarely, and if too little was learned or amplified to
mean anything.
"""

from __future__ import annotations

import argparse
import logging
import signal
import sys
import warnings
from collections.abc import Sequence
from typing import Any, NamedTuple

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from tests.core.oracle import behaviours, branches
from tests.core.oracle import trial as engine
from tests.wrapping.oracle import cast
from tests.wrapping.oracle import trial as wrap

LEAST_CLEAN, LEAST_AMPLIFIED = 0.3, 0.1
SLICE = 50_000
ONE_IN = 5_000
"""Every branch comes up at least once in so many decisions: 1,000 times in the halves of ten million."""


class Half(NamedTuple):
    """What is soaked, what its parts do wrong, and which branches that has to reach."""

    module: Any
    everything: Sequence[tuple[str, str]]
    branches: tuple[str, ...]


HALVES = {
    "engine": Half(engine, behaviours.EVERYTHING, branches.ENGINE),
    "wrap": Half(wrap, cast.EVERYTHING, branches.WRAP),
}


def soak(names: Sequence[str], decisions: int, seed: int, console: Console) -> dict[str, Any]:
    """Run hostile trials of all halves by turns, showing how far they are, until Ctrl-C at the latest."""
    columns = TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn()
    tallies = {name: HALVES[name].module.Tally() for name in names}
    with Progress(*columns, console=console) as progress, warnings.catch_warnings(action="ignore"):
        task = progress.add_task("decisions", total=decisions * len(names))
        try:
            for done in range(0, decisions, SLICE):
                for name, tally in tallies.items():
                    size = min(SLICE, decisions - done)
                    HALVES[name].module.run(
                        f"{seed} {done}", size, progress=lambda more: progress.advance(task, more), tally=tally
                    )
        except KeyboardInterrupt:
            console.print("stopped")
    return tallies


def shortcomings(half: Half, tally: Any) -> list[str]:
    """Return why a soak proves nothing, or nothing."""
    missing = sorted(set(half.everything) - set(tally.deeds))
    found = [f"never happened: {slot} {name}" for slot, name in missing]
    found += branches.find_missing(tally.hits, half.branches, max(1, tally.decisions // ONE_IN))
    if tally.clean < LEAST_CLEAN * tally.decisions:
        found.append(f"only {tally.clean} of {tally.decisions} decisions without an incident")
    if tally.amplified < LEAST_AMPLIFIED * tally.decisions:
        found.append(f"only {tally.amplified} of {tally.decisions} decisions amplified")
    return found


def show(name: str, tally: Any, console: Console) -> None:
    """Print what was seen."""
    console.print(
        f"{name}: {tally.decisions} decisions, {tally.clean / tally.decisions:.0%} without an incident, "
        f"{tally.amplified / tally.decisions:.0%} amplified; {len(tally.deeds)} hostile behaviours, each at least "
        f"{min(tally.deeds.values(), default=0)} times; {sum(tally.breaches.values())} breaches"
    )
    for branch in HALVES[name].branches:
        console.print(f"{tally.hits[branch]:>9} x {branch}", highlight=False)
    for key, times in tally.breaches.most_common(40):
        console.print(f"{times} x {key[0]} during {key[1]}: {tally.examples[key]}", soft_wrap=True, markup=False)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run from the command line."""
    parser = argparse.ArgumentParser(description="Soak the engine and wrapped controllers in hostile parts.")
    parser.add_argument("--decisions", type=int, default=1_000_000, help="how many decisions (default 1000000)")
    parser.add_argument("--seed", type=int, default=1, help="what is drawn, and when who misbehaves (default 1)")
    parser.add_argument("--only", choices=HALVES, help="one half only, with all the decisions")
    chosen, console = parser.parse_args(arguments), Console()
    signal.signal(signal.SIGINT, signal.default_int_handler)  # what runs in the background may ignore it
    logging.disable(logging.CRITICAL)
    names, failed = [chosen.only] if chosen.only else list(HALVES), False
    for name, tally in soak(names, chosen.decisions // len(names), chosen.seed, console).items():
        show(name, tally, console)
        problems = shortcomings(HALVES[name], tally)
        for problem in problems:
            console.print(f"{name}: {problem}")
        failed = failed or bool(tally.breaches or problems)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
