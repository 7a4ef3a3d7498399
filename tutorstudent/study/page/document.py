"""One HTML file that opens without a network: text, tables and drawings, and nothing that has to be fetched."""

from __future__ import annotations

import json
from collections.abc import Mapping
from html import escape
from importlib import resources

from tutorstudent.study.page.head import head_html
from tutorstudent.study.pictures.galleries import gallery_html
from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.pictures.pictures import pictures
from tutorstudent.study.plans.plan import Environment, Plan
from tutorstudent.study.runs.results import Study
from tutorstudent.study.tables.media import html
from tutorstudent.study.tables.search_table import level_colours_by_name, search_table
from tutorstudent.study.tables.table import Table
from tutorstudent.study.tables.tables import runs_table, tables


def page(study: Study) -> str:
    """Return the page of a study."""
    palette = Palette(study.plan.variants())
    title = "Comparison of " + ", ".join(v.name for v in study.plan.variants() if not v.control)
    style = resources.files("tutorstudent.study.page").joinpath("page.css").read_text(encoding="utf-8")
    dark = f"@media (prefers-color-scheme: dark) {{ :root {{ {palette.declarations(1)} }} }}"
    sections = "\n".join(_section(study, environment, palette) for environment in study.plan.environments)
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>\n{style}:root {{ {palette.declarations(0)} }}\n{dark}\n</style>\n"
        f"</head>\n<body>\n{head_html(study, title, palette)}\n{sections}\n{_pipelines(study.plan)}\n</body>\n</html>\n"
    )


def _section(study: Study, environment: Environment, palette: Palette) -> str:
    colours = palette.css_by_name()
    drawn = pictures(study, environment, palette)
    parts = [
        *map(gallery_html, drawn.overview),
        *(_table(table, environment, colours) for table in tables(study, environment)),
        *map(gallery_html, drawn.details),
        _folded("Learning curves, summed up", "\n".join(map(gallery_html, drawn.totals))),
        _search(study, environment),
        _folded("Every run as numbers", html(runs_table(study, environment), colours)),
    ]
    body = "\n".join(part for part in parts if part)
    name = escape(environment.name)
    return f'<section id="{name}">\n<h2>{name}</h2>\n{body}\n</section>'


def _table(table: Table, environment: Environment, colours: Mapping[str, str]) -> str:
    """Return a table; one that has more rows than there are variants, and so pairs of them, is folded."""
    body = html(table, colours)
    is_long = len(table.rows) > len(environment.variants)
    return _folded(table.title, body) if is_long else f"<h3>{escape(table.title)}</h3>\n{body}"


def _search(study: Study, environment: Environment) -> str:
    table = search_table(study.search, environment.name) if study.search else None
    return _folded(table.title, html(table, level_colours_by_name())) if table and table.rows else ""


def _folded(title: str, body: str) -> str:
    return f"<details><summary>{escape(title)}</summary>\n{body}\n</details>"


def _pipelines(plan: Plan) -> str:
    blocks = "".join(
        _folded(variant.name, f"<pre>{escape(json.dumps(variant.pipeline, indent=2, default=str))}</pre>")
        for variant in plan.environments[0].variants
    )
    text = f"Every value, as in {plan.environments[0].name}; the seed is each run's own."
    return f"<section>\n<h2>What was run</h2>\n<p>{escape(text)}</p>{blocks}\n</section>"
