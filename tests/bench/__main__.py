"""``python -m tests.bench``: measures, prints, and writes the figures into docs/performance.md and bench.json."""

from __future__ import annotations

import json
import os
import platform
import tempfile
import time
from pathlib import Path

from tests.bench.clock import REPETITIONS, Timing, interleaved
from tests.bench.parts import parts_work
from tests.bench.worlds import alone, closed_loop_work
from tutorstudent.core.files.provenance import find_versions

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "performance.md"
BEGIN, END = "<!-- make bench: begin -->", "<!-- make bench: end -->"
OTHERS = 3
YARDSTICK_US = 0.9
"""What one validated action cost on the machine on which the targets were set."""


def measure() -> dict[str, Timing]:
    """Return every timing of the run."""
    with tempfile.TemporaryDirectory() as directory:
        work = parts_work()
        work |= closed_loop_work("alone", str(alone(Path(directory))))
        work |= closed_loop_work("with three others", "cave-predator-prey")
        return interleaved(work)


def goals(seen: dict[str, Timing]) -> list[tuple[str, str, str, str]]:
    """Return (what, target, seen, both in validated actions), medians of one run."""
    us = {name: timing.median for name, timing in seen.items()}
    solo = us["alone: closed loop"] - us["alone: its bare pybullet calls"]
    crowd = us["with three others: closed loop"] - us["with three others: its bare pybullet calls"]
    ratio = us["MLPRegressor.partial_fit x3"] / us["network, teaching x3"]
    action = us["one validated action"]
    bare = us["the controller that is wrapped, alone"]
    rows = [
        ("wrap, silent student, beyond the controller alone", 15, us["wrap, silent student"] - bare),
        ("engine with a silent student", 15, us["engine, silent student"]),
        ("whole cycle without the world", 75, us["whole cycle without world, 14-30-7, teaching rate 3"]),
        ("closed loop minus its bare pybullet calls, alone", 120, solo),
        ("the same for each further robot", 25, (crowd - solo) / OTHERS),
    ]
    return [
        *(
            (what, f"<= {target} us", f"{value:.1f} us", f"{target / YARDSTICK_US:.0f}; {value / action:.0f}")
            for what, target, value in rows
        ),
        ("teaching x3: MLPRegressor.partial_fit to ours", ">= 15 x", f"{ratio:.1f} x", "-"),
    ]


def page(seen: dict[str, Timing]) -> str:
    """Return the measured part of docs/performance.md."""
    found = find_versions()
    machine = (
        f"`make bench`, {time.strftime('%Y-%m-%d')}: {_processor()}, {os.cpu_count()} cores, Python "
        f"{platform.python_version()}, numpy {found['numpy']}, pydantic {found['pydantic']}, "
        f"pybullet {found['pybullet']}. CPU time, {REPETITIONS} interleaved repetitions."
    )
    lines = [
        machine,
        "",
        "| what | target | seen (median) | in validated actions: target; seen |",
        "|---|---|---|---|",
        *(f"| {' | '.join(row)} |" for row in goals(seen)),
        "",
        "| per decision or call, CPU us | least | median | most |",
        "|---|---|---|---|",
        *(f"| {name} | {t.least:.2f} | {t.median:.2f} | {t.most:.2f} |" for name, t in seen.items()),
    ]
    return "\n".join(lines)


def _processor() -> str:
    for line in (
        Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines() if Path("/proc/cpuinfo").exists() else []
    ):
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor() or platform.machine()


def main() -> None:
    """Measure and write."""
    seen = measure()
    text = page(seen)
    print(text)
    (ROOT / "bench.json").write_text(json.dumps({k: t._asdict() for k, t in seen.items()}, indent=2) + "\n")
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(BEGIN)
    _, _, after = rest.partition(END)
    PAGE.write_text(f"{before}{BEGIN}\n{text}\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
