"""All drawings of one environment."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from typing import NamedTuple

from tutorstudent.study.numbers.gains import find_gains
from tutorstudent.study.numbers.traces import Traces, read_traces
from tutorstudent.study.pictures.galleries import (
    Gallery,
    make_film_gallery,
    make_harm_gallery,
    make_total_galleries,
    make_way_gallery,
    rate_gallery,
)
from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.pictures.scatter import draw_scatter
from tutorstudent.study.pictures.strips import draw_strip
from tutorstudent.study.plans.plan import Environment
from tutorstudent.study.runs.results import Study
from tutorstudent.study.runs.sketches import load_sketch


class Pictures(NamedTuple):
    """In the order of the page; galleries without a picture are left out."""

    overview: list[Gallery]
    details: list[Gallery]
    totals: list[Gallery]
    """The learning curves once more, summed up."""
    others: list[Gallery]
    """The learning curves of what is a detail."""


def draw_pictures(study: Study, environment: Environment, palette: Palette) -> Pictures:
    """Draw everything about one environment."""
    traces = read_traces(study, environment)
    sketch = load_sketch(study.folder / "sketches" / f"{environment.name}.json")
    decisions, seed = study.plan.decisions, study.plan.seeds[0]
    rates = {item: rate_gallery(environment, traces, decisions, palette, item) for item in traces.counted.measures}
    return Pictures(
        _keep_filled([_make_gain_gallery(environment, traces, palette)]),
        _keep_filled(
            [
                _make_strip_gallery(traces, palette),
                *(gallery for measure, gallery in rates.items() if not measure.detail),
                make_way_gallery(environment, traces, sketch, seed, palette),
                make_harm_gallery(traces, sketch, palette),
                make_film_gallery(environment, traces, sketch, seed),
            ]
        ),
        _keep_filled(make_total_galleries(environment, traces, decisions, palette)),
        _keep_filled(gallery for measure, gallery in rates.items() if measure.detail),
    )


def _keep_filled(galleries: Iterable[Gallery]) -> list[Gallery]:
    return [gallery for gallery in galleries if gallery.figures]


def _make_gain_gallery(environment: Environment, traces: Traces, palette: Palette) -> Gallery:
    found = find_gains(environment, traces)
    controls = [variant.name for variant in environment.variants if variant.control]
    on_the_right = f" On the right, percent of the mean of {escape(environment.reference)}."
    note = (
        "A dot is a run; a large mark is the mean of a variant, a hollow ring that of a control, with a standard "
        f"deviation to each side.{on_the_right if found and found.has_percent else ''} Dashed: "
        "0.1\N{NO-BREAK SPACE}% of the decisions, a bound to hold results against."
    )
    title = "What was gained, and what it cost"
    return Gallery(title, note, "wide", [] if found is None else [draw_scatter(found, palette, controls)])


def _make_strip_gallery(traces: Traces, palette: Palette) -> Gallery:
    titles = [*traces.counted.counters, traces.counted.harm_total()]
    ends = {
        title: {name: [float(curve[-1]) for curve in found] for name, found in traces.totals(title).items()}
        for title in titles
    }
    goals = traces.goals()
    if traces.counted.goal not in ends and any(goals.values()):
        ends = {traces.counted.goal: goals} | ends
    drawn = [draw_strip(title, values, palette) for title, values in ends.items()]
    return Gallery("Every run", "A dot is a run, a bar the median.", "pair", drawn)
