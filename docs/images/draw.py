"""Draws the README's picture from the folder of a comparison: ``python docs/images/draw.py demo-out``."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from statistics import fmean

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from tutorstudent.core.roles.world import Sketch
from tutorstudent.core.running.arrays import load_arrays
from tutorstudent.study.pictures.maps import COLOURED_LEVELS, draw_way, make_level_colours
from tutorstudent.study.runs.sketches import load_sketch

ENVIRONMENT = "cave-box"
PANELS = {
    "prototype2": "The controller alone",
    "budgeted": "With the default student",
    "constant-4": "Without a learner: always level 4",
}


def draw(study: Path, target: Path) -> None:
    """Draw the first run of each variant side by side, with what all of its runs found and where they collided."""
    sketch = load_sketch(study / "sketches" / f"{ENVIRONMENT}.json")
    figure = Figure(figsize=(12, 4.5), layout="constrained")
    axes = figure.subplots(1, len(PANELS), sharey=True)
    for axis, (variant, title) in zip(axes, PANELS.items(), strict=True):
        draw_variant(axis, sketch, study / "runs" / ENVIRONMENT / variant)
        axis.set_title(title, fontsize=12)
    colours = ScalarMappable(Normalize(0, COLOURED_LEVELS), make_level_colours())
    figure.colorbar(colours, ax=axes, label="amplification level", shrink=0.85, pad=0.01)
    figure.savefig(target, dpi=100, metadata={"Software": None})


def draw_variant(axis: Axes, sketch: Sketch, variant: Path) -> None:
    """Draw the way of a variant's first run, and the means of all its runs under it."""
    runs = sorted(variant.iterdir(), key=lambda run: int(run.name))
    arrays = load_arrays(runs[0] / "decisions.npz")
    names = arrays["event_names"].tolist()
    draw_way(axis, sketch, arrays, np.column_stack([arrays["events"][:, names.index(name)] for name in ("x_m", "y_m")]))
    summaries = [json.loads((run / "run.json").read_text(encoding="utf-8"))["summary"] for run in runs]
    found, collided = (fmean(summary[name] for summary in summaries) for name in ("attractors", "collided"))
    axis.set_xlabel(f"mean of {len(runs)} runs: {found:.1f} found / {collided:.1f} collided", fontsize=12)


if __name__ == "__main__":
    draw(Path(sys.argv[1]), Path(__file__).parent / "cave-box.png")
