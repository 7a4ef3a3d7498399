"""What stands above the environments on the page: what was compared, and what that cost."""

from __future__ import annotations

import math
from collections.abc import Iterable
from html import escape

from tutorstudent.study.page.remarks import describe_goal, make_remarks
from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.plans.plan import Variant
from tutorstudent.study.runs.results import Failure, Study
from tutorstudent.study.tables.tables import CONTROLS, INTERVALS

NO_CONTROLS = (
    "This comparison was made without controls. Amplifying alone may achieve more, whether or not anything was "
    "learned, so nothing on this page shows that learning is worth anything."
)


def make_head(study: Study, title: str, palette: Palette) -> str:
    """Return the head of the page."""
    plan = study.plan
    links = " ".join(f'<a href="#{escape(item.name)}">{escape(item.name)}</a>' for item in plan.environments)
    references = {item.reference for item in plan.environments}
    variants = "".join(_describe_variant(variant, references, palette) for variant in plan.variants())
    claim = CONTROLS if any(variant.control for variant in plan.variants()) else NO_CONTROLS
    lead = f"{_describe_size(study)}{_describe_spent(study)} {describe_goal(study)}"
    return (
        f'<h1>{escape(title)}</h1>\n<p class="lead">{escape(lead)}</p>\n'
        f'<p class="claim">{escape(claim)}</p>\n{_make_remarks(study)}{_make_failures(study.failures)}'
        f'<ul class="variants">{variants}</ul>\n<p class="note">{escape(INTERVALS)}</p>\n<nav>{links}</nav>'
    )


def _describe_size(study: Study) -> str:
    plan = study.plan
    seeds = f"seed {plan.seeds[0]}" if len(plan.seeds) == 1 else f"seeds {plan.seeds[0]} to {plan.seeds[-1]}"
    environments = len(plan.environments)
    return (
        f"{len(plan.variants())} pipelines and controls, {len(plan.seeds)} paired runs each ({seeds}) of "
        f"{plan.decisions} decisions in {environments} environment{'s' if environments > 1 else ''}: "
        f"{len(study.runs)} runs, all of them shown."
    )


def _describe_spent(study: Study) -> str:
    """Return what the runs took; nothing where that is not known of every one."""
    spent = study.spent()
    if not study.runs or spent.wall_s == 0 or any(math.isnan(run.spent().cpu_s) for run in study.runs):
        return ""
    search = " with the search" if study.search else ""
    sittings = f" in {study.sittings()} sittings" if study.sittings() > 1 else ""
    return (
        f" They took{search} {spent.cpu_s:,.0f} CPU seconds, {spent.wall_s:,.0f} seconds of wall time{sittings} on the "
        "machine that ran them."
    )


def _describe_variant(variant: Variant, references: set[str], palette: Palette) -> str:
    swatch = f'<i class="swatch" style="background:{palette.find_css(variant.name)}"></i>'
    name = f"<em>{escape(variant.name)}</em>" if variant.control else f"<strong>{escape(variant.name)}</strong>"
    alone = " The tutor alone, to which differences are taken." if variant.name in references else ""
    return f"<li>{swatch}{name}: {escape(variant.about)}{alone}</li>"


def _make_remarks(study: Study) -> str:
    lines = "".join(f"<p>{escape(text)}</p>" for text in make_remarks(study))
    return f'<div class="remark">{lines}</div>\n' if lines else ""


def _make_failures(failures: Iterable[Failure]) -> str:
    lines = [
        f"<li>{escape(item.environment)}, {escape(item.variant)}, seed {item.seed}: {escape(item.problem)}</li>"
        for item in failures
    ]
    if not lines:
        return ""
    return f'<div class="problem"><p>{len(lines)} runs failed and are in no table:</p><ul>{"".join(lines)}</ul></div>\n'
