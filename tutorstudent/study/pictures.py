"""All drawings of one environment."""

from __future__ import annotations

from typing import NamedTuple

from tutorstudent.study.curves import Curve, entries, harm, level
from tutorstudent.study.maps import way_map
from tutorstudent.study.palette import Palette
from tutorstudent.study.panels import Bundle, panels
from tutorstudent.study.plan import Environment
from tutorstudent.study.results import Run, Study
from tutorstudent.study.sketches import load_sketch
from tutorstudent.study.strips import strip

LEVEL = "amplification level"
LEVEL_WINDOWS = 50
"""The level is shown as a moving mean over this part of a run: 200 decisions of 10,000."""


class Pictures(NamedTuple):
    """SVG elements, in the order of the page."""

    strips: list[str]
    panels: dict[str, list[str]]
    """By title."""
    maps: list[str]


def pictures(study: Study, environment: Environment, palette: Palette) -> Pictures:
    """Draw everything about one environment."""
    runs = {variant.name: study.of(environment.name, variant.name) for variant in environment.variants}
    harm_title = _harm_title([run for found in runs.values() for run in found])
    traces = {name: [_trace(run, environment, harm_title) for run in found] for name, found in runs.items()}
    titles = [*environment.counters(), harm_title, LEVEL]
    curves = {title: {name: [trace[title] for trace in found] for name, found in traces.items()} for title in titles}
    return Pictures(
        [strip(title, _ends(curves[title]), palette) for title in titles if title != LEVEL],
        {title: panels(Bundle(title, curves[title], environment.reference), palette) for title in titles},
        _maps(study, environment, palette),
    )


def level_window(decisions: int) -> int:
    """Return over how many decisions the level is averaged."""
    return max(1, decisions // LEVEL_WINDOWS)


def _harm_title(runs: list[Run]) -> str:
    known = any("collided" in run.summary for run in runs)
    return "collisions, per decision" if known else "violated decisions"


def _trace(run: Run, environment: Environment, harm_title: str) -> dict[str, Curve]:
    arrays = run.arrays()
    window = level_window(len(arrays["kind"]))
    counted = {counter: entries(arrays, situation) for counter, situation in environment.counters().items()}
    return counted | {harm_title: harm(arrays), LEVEL: level(arrays, window)}


def _ends(curves: dict[str, list[Curve]]) -> dict[str, list[float]]:
    return {name: [float(curve[-1]) for curve in found] for name, found in curves.items()}


def _maps(study: Study, environment: Environment, palette: Palette) -> list[str]:
    """Draw the first run of the tutor alone and of every variant that is no control."""
    sketch = load_sketch(study.folder / "sketches" / f"{environment.name}.json")
    names = [variant.name for variant in environment.variants if not variant.control]
    if environment.reference:
        names = [environment.reference, *(name for name in names if name != environment.reference)]
    firsts = [run for name in names for run in study.of(environment.name, name) if run.seed == study.plan.seeds[0]]
    drawn = [way_map(run.variant, sketch, run.arrays(), palette) for run in firsts]
    return [picture for picture in drawn if picture is not None]
