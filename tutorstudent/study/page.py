"""One HTML file that opens without a network: text, tables and drawings, and nothing that has to be fetched."""

from __future__ import annotations

import json
from collections.abc import Iterable
from html import escape
from importlib import resources

from tutorstudent.study.galleries import folded_html, gallery_html
from tutorstudent.study.media import html
from tutorstudent.study.palette import Palette
from tutorstudent.study.pictures import pictures
from tutorstudent.study.plan import Environment, Plan, Variant
from tutorstudent.study.results import Failure, Study
from tutorstudent.study.tables import CONTROLS, INTERVALS, runs_table, tables


def page(study: Study) -> str:
    """Return the page of a study."""
    palette = Palette(study.plan.variants())
    title = "Comparison of " + ", ".join(v.name for v in study.plan.variants() if not v.control)
    style = resources.files("tutorstudent.study").joinpath("page.css").read_text(encoding="utf-8")
    dark = f"@media (prefers-color-scheme: dark) {{ :root {{ {palette.declarations(1)} }} }}"
    sections = "\n".join(_section(study, environment, palette) for environment in study.plan.environments)
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>\n{style}:root {{ {palette.declarations(0)} }}\n{dark}\n</style>\n"
        f"</head>\n<body>\n{_head(study, title, palette)}\n{sections}\n{_pipelines(study.plan)}\n</body>\n</html>\n"
    )


def _head(study: Study, title: str, palette: Palette) -> str:
    plan = study.plan
    links = " ".join(f'<a href="#{escape(item.name)}">{escape(item.name)}</a>' for item in plan.environments)
    references = {item.reference for item in plan.environments}
    variants = "".join(_variant(variant, references, palette) for variant in plan.variants())
    controls = any(variant.control for variant in plan.variants())
    claim = f'<p class="claim">{escape(CONTROLS)}</p>' if controls else f'<p class="claim">{escape(NO_CONTROLS)}</p>'
    return (
        f'<h1>{escape(title)}</h1>\n<p class="lead">{escape(_size(study))}</p>\n{claim}\n{_failures(study.failures)}'
        f'<ul class="variants">{variants}</ul>\n<p class="note">{escape(INTERVALS)}</p>\n<nav>{links}</nav>'
    )


NO_CONTROLS = (
    "This comparison was made without controls. Driving faster finds more attractors whether or not anything was "
    "learned, so nothing on this page shows that learning is worth anything."
)


def _size(study: Study) -> str:
    plan = study.plan
    seeds = f"seed {plan.seeds[0]}" if len(plan.seeds) == 1 else f"seeds {plan.seeds[0]} to {plan.seeds[-1]}"
    places = len(plan.environments)
    return (
        f"{len(plan.variants())} pipelines and controls, {len(plan.seeds)} paired runs each ({seeds}) of "
        f"{plan.decisions} decisions in {places} environment{'s' if places > 1 else ''}: "
        f"{len(study.runs)} runs, all of them shown."
    )


def _variant(variant: Variant, references: set[str], palette: Palette) -> str:
    swatch = f'<i class="swatch" style="background:{palette.css(variant.name)}"></i>'
    name = f"<em>{escape(variant.name)}</em>" if variant.control else f"<strong>{escape(variant.name)}</strong>"
    alone = " The tutor alone, to which differences are taken." if variant.name in references else ""
    return f"<li>{swatch}{name}: {escape(variant.about)}{alone}</li>"


def _failures(failures: Iterable[Failure]) -> str:
    lines = [
        f"<li>{escape(item.environment)}, {escape(item.variant)}, seed {item.seed}: {escape(item.problem)}</li>"
        for item in failures
    ]
    if not lines:
        return ""
    return f'<div class="problem"><p>{len(lines)} runs failed and are in no table:</p><ul>{"".join(lines)}</ul></div>\n'


def _section(study: Study, environment: Environment, palette: Palette) -> str:
    colours = palette.css_by_name()
    shown = "\n".join(f"<h3>{table.title}</h3>\n{html(table, colours)}" for table in tables(study, environment))
    every = runs_table(study, environment)
    drawn = pictures(study, environment, palette)
    galleries = "\n".join(gallery_html(gallery) for gallery in drawn.shown)
    return (
        f'<section id="{escape(environment.name)}">\n<h2>{escape(environment.name)}</h2>\n'
        f"{shown}\n{galleries}\n{folded_html('Learning curves, summed up', drawn.totals)}\n"
        f"<details><summary>Every run as numbers</summary>{html(every, colours)}</details>\n</section>"
    )


def _pipelines(plan: Plan) -> str:
    blocks = "".join(
        f"<details><summary>{escape(variant.name)}</summary>"
        f"<pre>{escape(json.dumps(variant.pipeline, indent=2, default=str))}</pre></details>"
        for variant in plan.environments[0].variants
    )
    text = f"Every value, as in {plan.environments[0].name}; the seed is each run's own."
    return f"<section>\n<h2>What was run</h2>\n<p>{escape(text)}</p>{blocks}\n</section>"
