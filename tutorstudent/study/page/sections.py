"""The sections of the page. A new one is a function here, and its name in one of the two lists."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from functools import cached_property
from html import escape
from typing import Any

from tutorstudent.study.page.head import make_head
from tutorstudent.study.pictures.galleries import Gallery, make_gallery
from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.pictures.pictures import Pictures, draw_pictures
from tutorstudent.study.plans.plan import Environment
from tutorstudent.study.runs.results import Study
from tutorstudent.study.tables.media import make_html
from tutorstudent.study.tables.search_table import colour_levels, make_search_table
from tutorstudent.study.tables.table import Table
from tutorstudent.study.tables.tables import make_runs_table, make_tables


class Chapter:
    """One environment of a study, with what several of its sections are made from."""

    def __init__(self, study: Study, environment: Environment, palette: Palette) -> None:
        self.study, self.environment, self.palette = study, environment, palette

    @cached_property
    def pictures(self) -> Pictures:
        """All its drawings; every run is read once for them."""
        return draw_pictures(self.study, self.environment, self.palette)


def what_was_gained(chapter: Chapter) -> str | None:
    """Return every run's gain against its harm."""
    return _make_galleries(chapter.pictures.overview)


def all_tables(chapter: Chapter) -> str | None:
    """Return the tables; each explains its own columns."""
    return "\n".join(_make_table(chapter, table) for table in make_tables(chapter.study, chapter.environment))


def every_run_and_its_way(chapter: Chapter) -> str | None:
    """Return every run as a dot, learning curves, maps and the film."""
    return _make_galleries(chapter.pictures.details)


def details_over_time(chapter: Chapter) -> str | None:
    """Return the learning curves of measures that are details."""
    return fold("Learning curves of the details", _make_galleries(chapter.pictures.others))


def totals_over_time(chapter: Chapter) -> str | None:
    """Return the curves of what is found and of harm once more, summed up."""
    return fold("Learning curves, summed up", _make_galleries(chapter.pictures.totals))


def search(chapter: Chapter) -> str | None:
    """Return how the constant level was searched for."""
    found = chapter.study.search
    table = make_search_table(found, chapter.environment.name) if found else None
    return fold(table.title, make_html(table, colour_levels())) if table and table.rows else None


def runs_as_numbers(chapter: Chapter) -> str | None:
    """Return a row for each run."""
    return fold(
        "Every run as numbers",
        make_html(make_runs_table(chapter.study, chapter.environment), chapter.palette.list_css()),
    )


def environment(chapter: Chapter) -> str:
    """Return everything about one environment."""
    name = escape(chapter.environment.name)
    return f'<section id="{name}">\n<h2>{name}</h2>\n{_join(IN_AN_ENVIRONMENT, chapter)}\n</section>'


IN_AN_ENVIRONMENT: tuple[Callable[[Chapter], str | None], ...] = (
    what_was_gained,
    all_tables,
    every_run_and_its_way,
    details_over_time,
    totals_over_time,
    search,
    runs_as_numbers,
)
"""Each returns HTML, or None where it has nothing to say."""


def head(study: Study) -> str | None:
    """Return what was compared, and what has to be said of it first."""
    return make_head(study, make_title(study), Palette(study.plan.variants()))


def environments(study: Study) -> str | None:
    """Return a section for each environment."""
    palette = Palette(study.plan.variants())
    return "\n".join(environment(Chapter(study, item, palette)) for item in study.plan.environments)


def what_was_run(study: Study) -> str | None:
    """Return every pipeline with all its values."""
    first = study.plan.environments[0]
    blocks = "".join(
        fold(variant.name, f"<pre>{escape(json.dumps(variant.pipeline, indent=2, default=str))}</pre>") or ""
        for variant in first.variants
    )
    text = f"Every value, as in {first.name}; the seed is each run's own."
    return f"<section>\n<h2>What was run</h2>\n<p>{escape(text)}</p>{blocks}\n</section>"


OF_THE_STUDY: tuple[Callable[[Study], str | None], ...] = (head, environments, what_was_run)
"""The whole page."""


def make_title(study: Study) -> str:
    """Return the title of the page."""
    return "Comparison of " + ", ".join(v.name for v in study.plan.variants() if not v.control)


def make_body(study: Study) -> str:
    """Return all sections."""
    return _join(OF_THE_STUDY, study)


def fold(title: str, body: str | None) -> str | None:
    """Return a part of a section that is closed at first; None for nothing."""
    return f"<details><summary>{escape(title)}</summary>\n{body}\n</details>" if body else None


def _join(sections: Iterable[Callable[..., str | None]], about: Any) -> str:
    return "\n".join(made for section in sections if (made := section(about)))


def _make_galleries(galleries: Iterable[Gallery]) -> str:
    return "\n".join(map(make_gallery, galleries))


def _make_table(chapter: Chapter, table: Table) -> str:
    """Return a table; one that has more rows than there are variants, and so pairs of them, is folded."""
    body = make_html(table, chapter.palette.list_css())
    is_long = len(table.rows) > len(chapter.environment.variants)
    return (fold(table.title, body) if is_long else None) or f"<h3>{escape(table.title)}</h3>\n{body}"
