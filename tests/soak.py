"""The behaviour contract at full size: ``python -m tests.soak --decisions 1000000 --seed 1``.

Exits 1 on any breach, on a behaviour that never happened, and if too little was learned or amplified to mean anything.
"""

from __future__ import annotations

import argparse
import sys

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from tests.core.oracle.behaviours import EVERYTHING
from tests.core.oracle.trial import Tally, run

LEAST_CLEAN, LEAST_AMPLIFIED = 0.3, 0.1


def soak(decisions: int, seed: int, console: Console) -> Tally:
    """Run hostile trials, showing how far they are."""
    columns = TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn()
    with Progress(*columns, console=console) as progress:
        task = progress.add_task("decisions", total=decisions)
        return run(seed, decisions, progress=lambda done: progress.advance(task, done))


def shortcomings(tally: Tally) -> list[str]:
    """Return why a soak proves nothing, or nothing."""
    missing = sorted(set(EVERYTHING) - set(tally.deeds))
    found = [f"never happened: {slot} {name}" for slot, name in missing]
    if tally.clean < LEAST_CLEAN * tally.decisions:
        found.append(f"only {tally.clean} of {tally.decisions} decisions without an incident")
    if tally.amplified < LEAST_AMPLIFIED * tally.decisions:
        found.append(f"only {tally.amplified} of {tally.decisions} decisions amplified")
    return found


def show(tally: Tally, console: Console) -> None:
    """Print what was seen."""
    console.print(
        f"{tally.decisions} decisions, {tally.clean / tally.decisions:.0%} without an incident, "
        f"{tally.amplified / tally.decisions:.0%} amplified; {len(tally.deeds)} hostile behaviours, each at least "
        f"{min(tally.deeds.values(), default=0)} times; {sum(tally.breaches.values())} breaches"
    )
    for (name, during), times in tally.breaches.most_common(40):
        example = tally.examples[name, during]
        console.print(f"{times} x {name} during {during}: {example}", soft_wrap=True, markup=False)


def main() -> int:
    """Run from the command line."""
    parser = argparse.ArgumentParser(description="Soak the engine in hostile parts.")
    parser.add_argument("--decisions", type=int, default=1_000_000, help="how many decisions (default 1000000)")
    parser.add_argument("--seed", type=int, default=1, help="what is drawn, and when who misbehaves (default 1)")
    chosen, console = parser.parse_args(), Console()
    tally = soak(chosen.decisions, chosen.seed, console)
    show(tally, console)
    problems = shortcomings(tally)
    for problem in problems:
        console.print(problem)
    return 1 if tally.breaches or problems else 0


if __name__ == "__main__":
    sys.exit(main())
