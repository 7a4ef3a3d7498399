"""Run a study of docs/student.md: python -m tutorstudent_controllers.regimes controllers --out studies/student."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

import tutorstudent as ts
from tutorstudent_controllers.regimes.registered import read
from tutorstudent_controllers.regimes.running import run
from tutorstudent_controllers.regimes.sheet import write_sheet
from tutorstudent_controllers.regimes.verdicts import judge

SHEET = "student.md"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run what has not been run yet, print the tables and write them into the folder."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("study", choices=("controllers", "pioneer"))
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--runs", type=int, help="fewer runs than registered, to see that all works")
    parser.add_argument("--decisions", type=int, help="fewer decisions than registered")
    chosen = parser.parse_args(arguments)
    try:
        registered = read(chosen.study)
        registered = registered._replace(decisions=chosen.decisions or registered.decisions)
        runs, failures = run(registered, chosen.out, chosen.workers, chosen.runs)
    except ts.TutorStudentError as error:
        sys.exit(str(error))
    text = write_sheet(registered, judge(registered, runs))
    (chosen.out / SHEET).write_text(text, encoding="utf-8")
    sys.stdout.write(f"{text}\n{len(runs)} runs, {len(failures)} failed or not run yet\n")
    return int(bool(failures))


if __name__ == "__main__":
    sys.exit(main())
