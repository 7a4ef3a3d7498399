"""``python -m tests.recordings``: record the streams anew; only for a change that is meant to change decisions."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from tests.recordings.cases import loops, pipelines
from tests.recordings.streams import Digests, arithmetic, digests
from tutorstudent.core.files.rundir import run_pipeline

DATA = Path(__file__).parent / "data" / "streams.json"


def found() -> Iterator[tuple[str, Digests]]:
    """Yield every case with the digests of its stream."""
    for name, pipeline in pipelines():
        yield name, digests(run_pipeline(pipeline).decisions)
    for name, commands in loops().items():
        yield name, digests({"commands": np.array(commands())})


def main() -> None:
    """Write the recordings of today's code."""
    recorded = {"arithmetic": arithmetic(), "streams": dict(found())}
    DATA.write_text(f"{json.dumps(recorded, indent=1, sort_keys=True)}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
