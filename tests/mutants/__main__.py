"""Put one fault after the other into the deciding code and see whether the tests notice: ``python -m tests.mutants``.

The package is copied into a temporary folder, so its own files stay as they are. Each mutant has a process of its own:
first a choice of quick tests, then a short soak. What survives is listed; some of it changes nothing that can be seen.
"""

from __future__ import annotations

import argparse
import compileall
import importlib.util
import logging
import os
import random
import shutil
import sys
import tempfile
import time
import warnings
from collections.abc import Sequence
from pathlib import Path

import numpy  # noqa: F401, ICN001 - here, so that no mutant has to load it
import pydantic  # noqa: F401
import pytest

from tests.mutants.operators import Mutant, make_mutants

ROOT = Path(__file__).parents[2]
DECIDING = ("guard", "grading", "ladder", "limiting", "rendering", "gate", "checking")
WORDS = ("forms", "named_form", "backup")
FILES = [*(f"core/deciding/{name}.py" for name in DECIDING), *(f"core/words/{name}.py" for name in WORDS)]
FOLDERS = ("tests/wrapping", "tests/core/deciding", "tests/core/words")
SOAKS = ("test_contract.py", "test_contract_of_wrap.py")
"""Instead of these, a shorter soak."""
DEADLINE_S, SOAKED = 90, 4000


def find_tests() -> list[str]:
    """Return the quick tests of the deciding code."""
    found = [path for folder in FOLDERS for path in sorted((ROOT / folder).glob("test_*.py"))]
    return [str(path) for path in found if path.name not in SOAKS]


def is_noticed(package: Path) -> bool:
    """Return whether tests or soak notice what is wrong with a package."""
    sys.path.insert(0, str(package.parent))
    import tutorstudent

    if Path(tutorstudent.__file__).parent != package:
        raise RuntimeError("the copy was not imported")
    if pytest.main(["-x", "-q", "-p", "no:cacheprovider", *find_tests()]):
        return True
    from tests.core.oracle import trial
    from tests.wrapping.oracle import trial as wrap_trial

    logging.disable(logging.CRITICAL)
    warnings.simplefilter("ignore")
    return any(bool(half.run(3, SOAKED).breaches) for half in (trial, wrap_trial))


def try_out(package: Path, file: str, mutant: Mutant, original: str) -> str:
    """Return what became of a mutant: killed, hung or survived."""
    path = package / file
    Path(importlib.util.cache_from_source(str(path))).unlink(missing_ok=True)
    path.write_text(mutant.source, encoding="utf-8")
    child = os.fork()
    if child == 0:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        os.dup2(1, 2)
        status = 1
        try:
            status = int(is_noticed(package))
        finally:
            os._exit(status)
    try:
        return _wait(child)
    finally:
        path.write_text(original, encoding="utf-8")


def _wait(child: int) -> str:
    deadline = time.monotonic() + DEADLINE_S
    while time.monotonic() < deadline:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            return "killed" if status else "survived"
        time.sleep(0.05)
    os.kill(child, 9)
    os.waitpid(child, 0)
    return "hung"


def say(text: str) -> None:
    """Print a line at once."""
    sys.stdout.write(f"{text}\n")
    sys.stdout.flush()


def main(arguments: Sequence[str] | None = None) -> int:
    """Run from the command line."""
    parser = argparse.ArgumentParser(description="See whether the tests notice faults in the deciding code.")
    parser.add_argument("--files", nargs="*", default=FILES, help="below tutorstudent/")
    parser.add_argument("--share", type=float, default=1.0, help="which share of the mutants, drawn at random")
    parser.add_argument("--seed", type=int, default=1, help="of what is drawn")
    chosen, drawn, counts = parser.parse_args(arguments), random.Random(), {"killed": 0, "hung": 0, "survived": 0}
    drawn.seed(chosen.seed)
    sys.dont_write_bytecode = True
    with tempfile.TemporaryDirectory() as folder:
        package = Path(folder).resolve() / "tutorstudent"
        shutil.copytree(ROOT / "tutorstudent", package)
        compileall.compile_dir(str(package), quiet=2)
        for file in chosen.files:
            original = (package / file).read_text(encoding="utf-8")
            if try_out(package, file, Mutant(0, "", original), original) != "survived":
                sys.exit("the tests fail without a fault")
            for mutant in make_mutants(original):
                if drawn.random() >= chosen.share:
                    continue
                found = try_out(package, file, mutant, original)
                counts[found] += 1
                if found != "killed":
                    say(f"{found}: {file}:{mutant.line} {mutant.what}")
            say(f"up to {file}: {counts}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
