"""Pictures that belong together, with a caption that explains them, as HTML."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterable
from html import escape
from typing import NamedTuple

from tutorstudent.core.roles.world import Sketch
from tutorstudent.core.words.measures import Measure
from tutorstudent.study.numbers.curves import describe_point, make_middles, name_curve, thin_out
from tutorstudent.study.numbers.traces import Traces
from tutorstudent.study.pictures.film import Film, make_film
from tutorstudent.study.pictures.harms import draw_harm_map
from tutorstudent.study.pictures.maps import draw_way_map, list_level_colours
from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.pictures.panels import Bundle, draw_panels
from tutorstudent.study.plans.plan import Environment


class Gallery(NamedTuple):
    """Pictures in a row, or in several."""

    title: str
    note: str
    """How to read them, HTML."""
    layout: str
    """Class of the style sheet: ``pair``, ``wide``, ``film`` or ``film maps``."""
    figures: list[str]
    """HTML elements."""


def make_gallery(gallery: Gallery) -> str:
    """Return a gallery with its heading."""
    figures = "".join(f'<figure class="picture">{figure}</figure>' for figure in gallery.figures)
    note = f'<p class="note">{gallery.note}</p>'
    return f'<h3>{escape(gallery.title)}</h3>\n{note}\n<div class="{gallery.layout}">{figures}</div>'


def rate_gallery(
    environment: Environment, traces: Traces, decisions: int, palette: Palette, measure: Measure
) -> Gallery:
    """Return the learning curves of one measure."""
    covered, title = describe_point(decisions), name_curve(measure)
    is_count = measure.summed == "sum" and not measure.unit
    last, curves = f"In the last {covered}", traces.rates(measure)
    bundle = Bundle(title, make_middles(decisions), last, curves, environment.reference, is_count)
    about = f" {escape(_capitalise(measure.description))}." if measure.description else ""
    note = f"Each point covers {covered}. {_make_lines(environment, bundle)}{about}"
    return Gallery(_capitalise(title), note, "film", draw_panels(bundle, palette))


def make_total_galleries(
    environment: Environment, traces: Traces, decisions: int, palette: Palette
) -> Iterable[Gallery]:
    """Yield a gallery for each thing that is counted."""
    at = thin_out(decisions) + 1.0
    for title in (*traces.counted.counters, traces.counted.harm_total()):
        bundle = Bundle(title, at, "At the end of each run", traces.totals(title), environment.reference)
        yield Gallery(_capitalise(title), _make_lines(environment, bundle), "film", draw_panels(bundle, palette))


def _make_lines(environment: Environment, bundle: Bundle) -> str:
    known = environment.reference and bundle.curves.get(environment.reference)
    dashed = f" Dashed: the mean of {escape(environment.reference)}." if known else ""
    return f"Thin: every run. Thick: their mean.{dashed}"


def _capitalise(title: str) -> str:
    return title[:1].upper() + title[1:]


def make_way_gallery(environment: Environment, traces: Traces, sketch: Sketch, seed: int, palette: Palette) -> Gallery:
    """Return the way of the first run of the tutor alone and of every variant that is no control."""
    names = [variant.name for variant in environment.variants if not variant.control]
    if environment.reference:
        names = [environment.reference, *(name for name in names if name != environment.reference)]
    drawn = [draw_way_map(name, sketch, traces.firsts[name], palette) for name in names if name in traces.firsts]
    bars = "".join(f'<i style="background:{colour}"></i>' for colour in list_level_colours())
    note = (
        f"The run with seed {seed}, the first, not a chosen one; bodies stand where they begin. "
        f'<span class="key">Amplification level 0 <span class="scale">{bars}</span> 8</span>'
    )
    return Gallery("Where it drove", note, "film maps", [picture for picture in drawn if picture is not None])


def make_harm_gallery(traces: Traces, sketch: Sketch, palette: Palette) -> Gallery:
    """Return where every variant and control was harmed."""
    drawn = [
        draw_harm_map(name, sketch, found, traces.firsts.get(name), palette)
        for name, found in traces.by_variant.items()
    ]
    collided = traces.counted.harm == "collided"
    note = (
        f"Every {escape(traces.counted.harm)} decision of all runs is a dot where the robot stood then"
        f"{', a ring where a contact began' if collided else ''}; the more there are, the fainter each. "
        "In the background the way of the first run; bodies stand where they begin."
    )
    title = "Where it collided" if collided else "Where conditions were violated"
    return Gallery(title, note, "film", [picture for picture in drawn if picture is not None])


def make_film_gallery(environment: Environment, traces: Traces, sketch: Sketch, seed: int) -> Gallery:
    """Return the film of the first run of the first learner; a gallery without pictures if there is nothing to see."""
    name = _find_first_learner(environment)
    if name not in traces.firsts:
        return Gallery("Film", "", "cinema", [])
    title, counted = f"{name}, seed {seed}", traces.counted
    taken = make_film(title, sketch, traces.firsts[name], counted.counters, counted.harm)
    if taken is None:
        return Gallery("Film", "", "cinema", [])
    return Gallery("Film", _make_caption(taken, title, counted.harm), "cinema", [_make_figure(taken, title)])


def _find_first_learner(environment: Environment) -> str:
    given = [variant.name for variant in environment.variants if not variant.control]
    return next((name for name in given if name != environment.reference), "")


def _make_caption(taken: Film, title: str, harm: str) -> str:
    speed = "" if taken.time_lapse is None else f", {taken.time_lapse:.0f} times as fast as it was"
    return (
        f"{escape(title)}, the first run: decisions {taken.first:,} to {taken.last:,}{speed}. Lines have the colour of "
        f"the level; a ring is a {escape(harm)} decision. Only the learner's pose is recorded: outlines are where "
        "robots begin."
    )


def _make_figure(taken: Film, title: str) -> str:
    width, height = taken.size
    alike = f'width="{width}" height="{height}" alt="{escape(title)}, seen from above, '
    return (
        f'<img class="still" {alike}at the end." src="data:image/png;base64,{b64encode(taken.still).decode()}">'
        f"<details><summary>Play the film ({taken.duration_s:.0f} s)</summary>"
        f'<img {alike}as it drives." src="data:image/gif;base64,{b64encode(taken.gif).decode()}"></details>'
    )
