"""Draws the README's picture from the folder of a comparison: ``python docs/images/draw.py demo-out``."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from tutorstudent.core.running.arrays import load_arrays
from tutorstudent.study.pictures.maps import COLOURED_LEVELS, draw_way, make_level_colours
from tutorstudent.study.runs.sketches import load_sketch

ENVIRONMENT = "cave-box"
PANELS = {"prototype2": "The controller alone", "prototype2a": "The same controller with the learner"}


def draw(study: Path, target: Path) -> None:
    """Draw the ways of the first seed of each variant side by side."""
    sketch = load_sketch(study / "sketches" / f"{ENVIRONMENT}.json")
    figure = Figure(figsize=(10, 4.9), layout="constrained")
    axes = figure.subplots(1, 2)
    for axis, (variant, title) in zip(axes, PANELS.items(), strict=True):
        seeds = sorted((study / "runs" / ENVIRONMENT / variant).iterdir(), key=lambda path: int(path.name))
        arrays = load_arrays(seeds[0] / "decisions.npz")
        names = arrays["event_names"].tolist()
        columns = [arrays["events"][:, names.index(name)] for name in ("x_m", "y_m", "distance_m")]
        draw_way(axis, sketch, arrays, np.column_stack(columns[:2]))
        axis.set_title(f"{title}: {columns[2].sum():.0f} m", fontsize=11)
    colours = ScalarMappable(Normalize(0, COLOURED_LEVELS), make_level_colours())
    figure.colorbar(colours, ax=axes, label="amplification level", shrink=0.85, pad=0.01)
    figure.savefig(target, dpi=110, metadata={"Software": None})


if __name__ == "__main__":
    draw(Path(sys.argv[1]), Path(__file__).parent / "cave-box.png")
