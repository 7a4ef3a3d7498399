"""One HTML file that opens without a network: text, tables and drawings, and nothing that has to be fetched."""

from __future__ import annotations

import json
from collections.abc import Mapping
from html import escape
from importlib import resources

from tutorstudent.study.page.head import make_head
from tutorstudent.study.pictures.galleries import make_gallery
from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.pictures.pictures import draw_pictures
from tutorstudent.study.plans.plan import Environment, Plan
from tutorstudent.study.runs.results import Study
from tutorstudent.study.tables.media import make_html
from tutorstudent.study.tables.search_table import colour_levels, make_search_table
from tutorstudent.study.tables.table import Table
from tutorstudent.study.tables.tables import make_runs_table, make_tables


def make_page(study: Study) -> str:
    """Return the page of a study."""
    palette = Palette(study.plan.variants())
    title = "Comparison of " + ", ".join(v.name for v in study.plan.variants() if not v.control)
    style = resources.files("tutorstudent.study.page").joinpath("page.css").read_text(encoding="utf-8")
    dark = f"@media (prefers-color-scheme: dark) {{ :root {{ {palette.make_declarations(1)} }} }}"
    sections = "\n".join(_make_section(study, environment, palette) for environment in study.plan.environments)
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>\n{style}:root {{ {palette.make_declarations(0)} }}\n{dark}\n"
        f"</style>\n</head>\n<body>\n{make_head(study, title, palette)}\n{sections}\n"
        f"{_make_pipelines(study.plan)}\n</body>\n</html>\n"
    )


def _make_section(study: Study, environment: Environment, palette: Palette) -> str:
    colours = palette.list_css()
    drawn = draw_pictures(study, environment, palette)
    parts = [
        *map(make_gallery, drawn.overview),
        *(_make_table(table, environment, colours) for table in make_tables(study, environment)),
        *map(make_gallery, drawn.details),
        _fold("Learning curves, summed up", "\n".join(map(make_gallery, drawn.totals))),
        _make_search(study, environment),
        _fold("Every run as numbers", make_html(make_runs_table(study, environment), colours)),
    ]
    body = "\n".join(part for part in parts if part)
    name = escape(environment.name)
    return f'<section id="{name}">\n<h2>{name}</h2>\n{body}\n</section>'


def _make_table(table: Table, environment: Environment, colours: Mapping[str, str]) -> str:
    """Return a table; one that has more rows than there are variants, and so pairs of them, is folded."""
    body = make_html(table, colours)
    is_long = len(table.rows) > len(environment.variants)
    return _fold(table.title, body) if is_long else f"<h3>{escape(table.title)}</h3>\n{body}"


def _make_search(study: Study, environment: Environment) -> str:
    table = make_search_table(study.search, environment.name) if study.search else None
    return _fold(table.title, make_html(table, colour_levels())) if table and table.rows else ""


def _fold(title: str, body: str) -> str:
    return f"<details><summary>{escape(title)}</summary>\n{body}\n</details>"


def _make_pipelines(plan: Plan) -> str:
    blocks = "".join(
        _fold(variant.name, f"<pre>{escape(json.dumps(variant.pipeline, indent=2, default=str))}</pre>")
        for variant in plan.environments[0].variants
    )
    text = f"Every value, as in {plan.environments[0].name}; the seed is each run's own."
    return f"<section>\n<h2>What was run</h2>\n<p>{escape(text)}</p>{blocks}\n</section>"
