"""The film of one environment on the page; it moves only when the reader asks for it."""

from __future__ import annotations

from base64 import b64encode
from html import escape

from tutorstudent.core.world import Sketch
from tutorstudent.study.film import Film, film
from tutorstudent.study.galleries import Gallery
from tutorstudent.study.plan import Environment
from tutorstudent.study.traces import Traces


def film_gallery(environment: Environment, traces: Traces, sketch: Sketch, seed: int) -> Gallery:
    """Return the film of the first run of the first learner; a gallery without pictures if there is nothing to see."""
    name = _first_learner(environment)
    if name not in traces.firsts:
        return Gallery("Film", "", "cinema", [])
    title, measures = f"{name}, seed {seed}", traces.measures
    taken = film(title, sketch, traces.firsts[name], measures.counters, measures.harm)
    if taken is None:
        return Gallery("Film", "", "cinema", [])
    return Gallery("Film", _caption(taken, title, measures.harm), "cinema", [_figure(taken, title)])


def _first_learner(environment: Environment) -> str:
    given = [variant.name for variant in environment.variants if not variant.control]
    return next((name for name in given if name != environment.reference), "")


def _caption(taken: Film, title: str, harm: str) -> str:
    speed = "" if taken.time_lapse is None else f", {taken.time_lapse:.0f} times as fast as it was"
    return (
        f"{escape(title)}, the first run: decisions {taken.first:,} to {taken.last:,}{speed}. Lines have the colour of "
        f"the level; a ring is a {escape(harm)} decision. Only the learner's pose is recorded: outlines are where "
        "robots begin."
    )


def _figure(taken: Film, title: str) -> str:
    width, height = taken.size
    alike = f'width="{width}" height="{height}" alt="{escape(title)}, seen from above, '
    return (
        f'<img class="still" {alike}at the end." src="data:image/png;base64,{b64encode(taken.still).decode()}">'
        f"<details><summary>Play the film ({taken.duration_s:.0f} s)</summary>"
        f'<img {alike}as it drives." src="data:image/gif;base64,{b64encode(taken.gif).decode()}"></details>'
    )
