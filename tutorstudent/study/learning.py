"""Learning curves: what changed over the decisions, as rates and summed up."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

from tutorstudent.study.bins import covers, middles
from tutorstudent.study.curves import thinned
from tutorstudent.study.galleries import Gallery
from tutorstudent.study.palette import Palette
from tutorstudent.study.panels import Bundle, panels
from tutorstudent.study.plan import Environment
from tutorstudent.study.traces import MATCH, Traces


def rate_galleries(environment: Environment, traces: Traces, decisions: int, palette: Palette) -> Iterable[Gallery]:
    """Yield a gallery for each rate: the counters, the harm, the level, and how often the student named the kind."""
    covered = covers(decisions)
    for title in traces.measures.rates():
        bundle = Bundle(title, middles(decisions), f"In the last {covered}", traces.rates(title), environment.reference)
        about = f" {escape(NAMING)}" if title == MATCH else ""
        note = f"Each point covers {covered}. {_lines(environment, bundle)}{about}"
        yield Gallery(_capital(title), note, "film", panels(bundle, palette))


def total_galleries(environment: Environment, traces: Traces, decisions: int, palette: Palette) -> Iterable[Gallery]:
    """Yield a gallery for each thing that is counted."""
    at = thinned(decisions) + 1.0
    for title in (*traces.measures.counters, traces.measures.harm_total()):
        bundle = Bundle(title, at, "At the end of each run", traces.totals(title), environment.reference)
        yield Gallery(_capital(title), _lines(environment, bundle), "film", panels(bundle, palette))


NAMING = (
    "Share of the decisions in which the student named the tutor's kind of action; only of students that name kinds."
)


def _lines(environment: Environment, bundle: Bundle) -> str:
    known = environment.reference and bundle.curves.get(environment.reference)
    dashed = f" Dashed: the mean of {escape(environment.reference)}." if known else ""
    return f"Thin: every run. Thick: their mean.{dashed}"


def _capital(title: str) -> str:
    return title[:1].upper() + title[1:]
